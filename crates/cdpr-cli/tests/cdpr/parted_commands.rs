//! Commands planned in parts by `cdpr sweep plan -- COMMAND`: shards, the merged answer, and what cannot be planned.

use std::path::Path;

use super::cdpr_in;
use super::reachable::study;

const BENCHMARK: &str = "benchmark --robots planar-example,cogiro --models standard --seed 2";

/// A folder with a study that has tolerances, and one that has rounds.
fn studies() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(study("planar-wide-grid")).unwrap();
    let with =
        |name: &str, tables: &str| std::fs::write(folder.path().join(name), format!("{text}\n{tables}")).unwrap();
    with("drawn.toml", "[tolerances]\naccuracy_m = 0.01\nrobots = 40\n[tolerances.machine]\nframe_anchor_m = 0.002\n");
    with("rounds.toml", "[campaign]\nfree = \"frame-anchor\"\nrounds = 2\nposes_per_round = 4\n");
    folder
}

/// The answer without the folder that it is written into.
fn answer(folder: &Path, words: &str) -> String {
    let run = cdpr_in(folder, &format!("{words} --format json"));
    assert!(run.exit_code < 2, "{words}: {}", run.stderr);
    run.stdout
}

#[test]
fn commands_in_parts_answer_as_whole_with_the_same_files() {
    let folder = studies();
    for (command, parts) in [
        (BENCHMARK, 2),
        ("sensitivity drawn.toml --seed 5 --poses-csv poses.csv", 3),
        ("campaign rounds.toml --out rounds --repeats 2", 2),
    ] {
        let folder = folder.path();
        let run = |words: &str| {
            let run = cdpr_in(folder, &format!("sweep {words}"));
            assert_eq!(run.exit_code, 0, "{words}: {}{}", run.stdout, run.stderr);
            run
        };
        run(&format!("plan --out parts -- {command}"));
        assert!(run("run parts --points 1").stdout.contains("1 computed"));
        assert_eq!(cdpr_in(folder, "sweep merge parts").exit_code, 2);
        // the files that it reads are in the plan
        let hidden = folder.join("elsewhere");
        std::fs::create_dir(&hidden).unwrap();
        let names = ["drawn.toml", "rounds.toml"];
        names.iter().for_each(|name| std::fs::rename(folder.join(name), hidden.join(name)).unwrap());
        assert!(run("run parts").stdout.contains(&format!("{} computed, 1 already there", parts - 1)));
        let merged = answer(folder, "sweep merge parts");
        names.iter().for_each(|name| std::fs::rename(hidden.join(name), folder.join(name)).unwrap());
        std::fs::remove_dir(&hidden).unwrap();
        assert_eq!(merged, answer(folder, command), "{command}");
        for name in ["poses.csv", "rounds/result.json", "rounds/round-1/record.csv"] {
            let whole = std::fs::read(folder.join(name)).ok();
            assert_eq!(whole, std::fs::read(folder.join("parts").join(name)).ok(), "{command}: {name}");
        }
        std::fs::remove_dir_all(folder.join("parts")).unwrap();
        let _ = std::fs::remove_file(folder.join("poses.csv"));
        let _ = std::fs::remove_dir_all(folder.join("rounds"));
    }
}

#[test]
fn what_cannot_be_planned_is_told() {
    let folder = studies();
    for (command, words) in [
        ("check planar-example", "no parts"),
        ("sensitivity rounds.toml", "no parts"),
        ("benchmark --robots no-such-robot", "no-such-robot"),
        ("sweep merge parts", "there is no plan"),
    ] {
        let run = cdpr_in(folder.path(), &format!("sweep plan --out parts -- {command}"));
        assert!(run.exit_code == 2 && run.stderr.contains(words), "{command}: {}", run.stderr);
        assert!(!folder.path().join("parts").exists());
    }
    let run = cdpr_in(folder.path(), &format!("sweep plan --out parts -- {BENCHMARK}"));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let plan = folder.path().join("parts/plan.json");
    let changed = std::fs::read_to_string(&plan).unwrap().replace("\"2\"", "\"3\"");
    std::fs::write(&plan, changed).unwrap();
    let run = cdpr_in(folder.path(), "sweep run parts");
    assert!(run.exit_code == 2 && run.stderr.contains("changed by hand"), "{}", run.stderr);
    let run = cdpr_in(folder.path(), "sweep plan sweep.toml --out parts -- benchmark");
    assert_eq!(run.exit_code, 2, "{}", run.stdout);
}

/// Repetitions are campaigns of their own: one with the seed of a repetition has its rounds.
#[test]
fn a_repetition_is_the_campaign_with_its_seed() {
    let folder = studies();
    let of = |words: &str| -> serde_json::Value { serde_json::from_str(&answer(folder.path(), words)).unwrap() };
    let repeated = of("campaign rounds.toml --out first --repeats 1");
    let own = &repeated["repeats"][0];
    let alone = of(&format!("campaign rounds.toml --out second --seed {}", own["seed"]));
    assert_eq!(own["rounds"].as_array().unwrap().len(), alone["rounds"].as_array().unwrap().len());
    for (own, alone) in own["rounds"].as_array().unwrap().iter().zip(alone["rounds"].as_array().unwrap()) {
        let near = |key: &str, other: &serde_json::Value| {
            let (own, other) = (own[key].as_f64().unwrap(), other.as_f64().unwrap());
            // records of a campaign go through their file
            assert!((own - other).abs() < 1e-9 * other.abs().max(1e-6), "{key}: {own} {other}");
        };
        near("poses", &alone["poses"]);
        near("reach_share", &alone["reach_share"]);
        near("driven_position_mean_m", &alone["driven"]["position_error_m"]["mean"]);
    }
    let run = cdpr_in(folder.path(), "campaign rounds.toml --out third --repeats 2");
    assert!(run.stdout.contains("with 2 other seeds"), "{}", run.stdout);
}
