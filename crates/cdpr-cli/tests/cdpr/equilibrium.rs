//! `fk` where the load decides: elastic cables, too few cables, constant tensions.

use super::{SQUARE, cdpr, cdpr_in, file_with, listed, numbers};

/// The square with elastic cables of 1 kN and a platform of 1 kg in an upright plane.
fn elastic_square() -> String {
    let elastic = SQUARE.replace("platform_anchor_m", "axial_stiffness_EA_N = 1000.0\nplatform_anchor_m");
    elastic.replace("[home_pose]", "gravity_m_s2 = [0.0, -9.81]\n\n[platform]\nmass_kg = 1.0\n\n[home_pose]")
}

/// Forward and back: the inverse problem at the pose and tensions found gives the lengths that were asked for.
#[test]
fn ik_at_the_equilibrium_gives_the_lengths_back() {
    let (folder, _) = file_with("square.toml", elastic_square().as_bytes());
    let lengths = [6.0, 6.1, 6.2, 6.3];
    let run =
        cdpr_in(folder.path(), &format!("fk square.toml --model elastic --lengths {} --format json", listed(&lengths)));
    assert_eq!(run.exit_code, 0, "{}", run.stdout);
    let keys = ["status", "pose", "tensions_N", "residuals_m", "iterations", "wrench_residual_N", "stability_N_per_m"];
    let fk = run.json_with(&keys);
    assert!(fk["wrench_residual_N"].as_f64().unwrap() < 1e-9 && fk["stability_N_per_m"].as_f64().unwrap() > 0.0);
    let (pose, tensions) = (numbers(&fk["pose"]["position_m"]), numbers(&fk["tensions_N"]));
    assert!(tensions.iter().all(|&tension| tension > 0.0), "{tensions:?}");
    let (pose, tensions) = (listed(&pose), listed(&tensions));
    let ik = format!("ik square.toml --model elastic --pose {pose} --tensions {tensions} --format json");
    let found = numbers(&cdpr_in(folder.path(), &ik).json()["controlled_lengths_m"]);
    assert!(found.iter().zip(lengths).all(|(found, given)| (found - given).abs() < 1e-9), "{found:?}");
}

/// A point on one cable of 2 m hangs 2 m below its outlet and pulls with its weight.
#[test]
fn a_point_on_one_cable_hangs_below_its_outlet() {
    let (kept, _) = SQUARE.split_once("[[cable]]\nname = \"b\"").unwrap();
    let (folder, _) = file_with("one.toml", kept.as_bytes());
    let run = cdpr_in(folder.path(), "fk one.toml --lengths 2 --wrench 0,-10 --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stdout);
    let fk = run.json();
    let position = numbers(&fk["pose"]["position_m"]);
    assert!(position[0].abs() < 1e-9 && (position[1] + 2.0).abs() < 1e-9, "{position:?}");
    assert!((numbers(&fk["tensions_N"])[0] - 10.0).abs() < 1e-8);
    // a pendulum of this weight and length: m g/l
    assert!((fk["stability_N_per_m"].as_f64().unwrap() - 5.0).abs() < 1e-6);
    let unloaded = cdpr_in(folder.path(), "fk one.toml --lengths 2 --format json").json();
    assert!(unloaded["reason"].as_str().unwrap().contains("gravity_m_s2"), "{unloaded}");
}

/// The tensions of the planar example balance its load at home; they are printed as integers.
#[test]
fn tensions_lead_back_to_the_pose_where_they_balance_the_load() {
    let run = cdpr("fk planar-example --tensions 5808,5909,2390,2421 --guess 0.5,5 --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stdout);
    let fk = run.json_with(&["status", "pose", "tensions_N", "stability_N_per_m"]);
    assert!(fk.get("residuals_m").is_none(), "no lengths were given: {fk}");
    let position = numbers(&fk["pose"]["position_m"]);
    // half a newton against some 1000 N/m
    assert!(position[0].abs() < 2e-3 && (position[1] - 5.2).abs() < 2e-3, "{position:?}");
    assert_eq!(cdpr("fk planar-example --tensions 1,1,1,1").exit_code, 1);
}

#[test]
fn what_the_forward_problem_lacks_is_named() {
    let lengths = "--lengths 9,9,9,9,9,9,9,9";
    for (command, words) in [
        (format!("fk cogiro --model elastic {lengths}"), "axial_stiffness_EA_N"),
        (format!("fk cogiro {lengths} --tensions 1,1"), "cannot be used with"),
        ("fk cogiro".to_owned(), "--lengths"),
        ("fk planar-example --tensions 1,2,3".to_owned(), "--tensions"),
        ("fk planar-example --tensions 1,2,-3,4".to_owned(), "cable 3"),
        ("fk planar-example --lengths 6,6,6,6 --wrench 1".to_owned(), "--wrench"),
    ] {
        let run = cdpr(&command);
        assert!(run.exit_code == 2 && run.stderr.contains(words), "{command}: {}", run.stderr);
    }
    let weightless = elastic_square().replace("mass_kg = 1.0", "");
    let (folder, _) = file_with("square.toml", weightless.as_bytes());
    let run = cdpr_in(folder.path(), "fk square.toml --model elastic --lengths 6,6,6,6");
    assert!(run.exit_code == 2 && run.stderr.contains("mass_kg"), "{}", run.stderr);
}

/// A rigid platform on every second cable of CoGiRo has no pose that its lengths alone determine, but one at which it rests under its
/// weight; without its mass nobody has an answer. All commands say the same of both.
#[test]
fn all_commands_agree_on_which_robots_have_a_forward_solution() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    let mut robot = cdpr_model::robot::Robot::builtin("cogiro").unwrap();
    robot.cables = [0, 2, 4, 6].map(|cable| robot.cables[cable].clone()).to_vec();
    robot.home.as_mut().unwrap().position.z = 2.0;
    write("four.toml", &robot.to_toml());
    (robot.platform.mass, robot.external_wrench) = (None, None);
    write("weightless.toml", &robot.to_toml());
    let study = "[control]\nrobot = \"four.toml\"\n[machine]\nrobot = \"four.toml\"\n\
                 [initial]\npose = [0, 0, 2, 0, 0, 0]\noffset = \"none\"\n\
                 [poses.grid]\nmin = [-0.5, -0.5, 2, 0, 0, 0]\nmax = [0.5, 0.5, 2.5, 0, 0, 0]\ncount = [2, 2, 2, 1, 1, 1]\n";
    write("study.toml", study);
    write("weightless-study.toml", &study.replace("four.toml", "weightless.toml"));

    let lengths = cdpr_in(folder.path(), "ik four.toml --pose 0,0,2,0,0,0 --format json").json();
    let lengths = listed(&numbers(&lengths["controlled_lengths_m"]));
    let forward = cdpr_in(folder.path(), &format!("fk four.toml --lengths {lengths} --format json"));
    assert_eq!(forward.json()["status"], "converged", "{}{}", forward.stdout, forward.stderr);
    let accuracy = cdpr_in(folder.path(), "accuracy study.toml --format json");
    assert_eq!((accuracy.exit_code, &accuracy.json()["statuses"]["converged"]), (0, &8.into()), "{}", accuracy.stdout);
    assert_eq!(cdpr_in(folder.path(), "simulate study.toml --out data.csv").exit_code, 0);
    let evaluated = cdpr_in(folder.path(), "evaluate four.toml data.csv --format json");
    assert_eq!((evaluated.exit_code, &evaluated.json()["answered"]), (0, &8.into()), "{}", evaluated.stdout);
    // exact records of where it came to rest: the same equilibrium, to what the search leaves
    assert!(evaluated.json()["position_error_m"]["max"].as_f64().unwrap() < 1e-6, "{}", evaluated.stdout);
    let checked = cdpr_in(folder.path(), "check four.toml").prose();
    assert!(checked.contains("`fk` answers where cables and load are in equilibrium"), "{checked}");

    let forward = cdpr_in(folder.path(), &format!("fk weightless.toml --lengths {lengths} --format json"));
    assert_eq!((forward.exit_code, &forward.json()["status"]), (1, &"singular".into()), "{}", forward.stdout);
    let accuracy = cdpr_in(folder.path(), "accuracy weightless-study.toml --format json");
    assert_eq!((accuracy.exit_code, &accuracy.json()["status"]), (1, &"not-converged".into()), "{}", accuracy.stdout);
    let evaluated = cdpr_in(folder.path(), "evaluate weightless.toml data.csv --format json");
    assert_eq!((evaluated.exit_code, &evaluated.json()["answered"]), (1, &0.into()), "{}", evaluated.stdout);
    let checked = cdpr_in(folder.path(), "check weightless.toml").prose();
    assert!(checked.contains("while the file states no load, `fk` calls it singular"), "{checked}");
}
