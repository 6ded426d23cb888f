//! Measurement files as written by loggers and trackers.

use std::fmt::Write;

use super::*;

/// Samples of the planar example on a circle at 100 Hz: poses (m), lengths (m), time (s).
fn rows(robot: &Robot, count: usize) -> Vec<(f64, [f64; 2], Vec<f64>)> {
    let row = |k: usize| {
        let (time, angle) = (0.01 * k as f64, 0.01 * k as f64);
        let position = [0.5 + 0.8 * angle.cos(), 4.0 + 0.8 * angle.sin()];
        (time, position, lengths(robot, position))
    };
    (0..count).map(row).collect()
}

fn lengths(robot: &Robot, position: [f64; 2]) -> Vec<f64> {
    let pose = robot.motion_pattern.pose(robot.plane, &position).unwrap();
    let length = |cable: &crate::robot::Cable| (cable.frame_anchor - pose.transform(&cable.platform_anchor)).norm();
    robot.cables.iter().map(length).collect()
}

fn robot() -> Robot {
    Robot::builtin("planar-example").unwrap()
}

const LENGTHS: &str = "cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4";

fn whole(robot: &Robot, count: usize) -> String {
    let mut text = format!("t_s,x_m,y_m,{LENGTHS}\n");
    for (time, [x, y], q) in rows(robot, count) {
        writeln!(text, "{time},{x},{y},{},{},{},{}", q[0], q[1], q[2], q[3]).unwrap();
    }
    text
}

fn read_with(text: &str, options: &ReadingOptions) -> Result<Reading, ReadError> {
    MeasurementFile { bytes: text.as_bytes(), name: "data.csv", options }.samples(&robot())
}

fn mapped(pairs: &[(&str, &str)]) -> ReadingOptions {
    let columns = pairs.iter().map(|(name, column)| ((*name).to_owned(), (*column).to_owned())).collect();
    ReadingOptions { columns, ..ReadingOptions::default() }
}

#[test]
fn columns_are_found_by_the_names_that_the_map_gives_them() {
    let plain = Samples::from_csv(whole(&robot(), 5).as_bytes(), "data.csv", &robot()).unwrap().samples;
    let foreign = whole(&robot(), 5).replace("x_m", "X_world").replace("cable_length_m_", "l");
    let pairs =
        [("x_m", "X_world"), ("cable_length_m_1", "l1"), ("cable_length_m_2", "l2"), ("cable_length_m_3", "l3")];
    let all = [&pairs[..], &[("cable_length_m_4", "l4")]].concat();
    assert_eq!(read_with(&foreign, &mapped(&all)).unwrap().samples, plain);
    // the column in the map takes precedence over the one with this name
    let both = whole(&robot(), 5).replace("t_s", "x_mm").replace("x_m,", "X,");
    let reading = read_with(&both, &mapped(&[("x_m", "X")])).unwrap();
    assert_eq!((reading.samples.poses, reading.samples.time), (plain.poses, None));
    assert!(reading.notices[0].contains("ignored columns `x_mm`"), "{:?}", reading.notices);
    for (pairs, what) in [
        (&[("x_world", "x_m")][..], "the unit `world`"),
        (&[("colour", "x_m")], "`colour` is no column of measurements"),
        (&[("x_m", "X_wrld")], "there is no column `X_wrld`"),
        (&[("x_m", "X_world"), ("y_m", "X_world")], "both"),
    ] {
        let error = read_with(&foreign, &mapped(pairs)).unwrap_err();
        assert_eq!((error.code, error.line()), ("csv::columns", Some(1)), "{error}");
        assert!(error.to_string().contains(what) || what.starts_with("the unit"), "{error}");
    }
}

/// Line numbers are those of the file, also after comments and blank lines.
#[test]
fn rows_with_gaps_are_mistakes_or_are_left_out_and_counted() {
    let text = whole(&robot(), 40);
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    lines[5] = "# the tracker lost sight\n".to_owned(); // line 6 and a blank one: all below move by one
    lines[7] = lines[7].replacen(',', ",NaN,", 1); // ragged, line 9
    for row in [10, 11, 12] {
        let at = lines[row].rfind(',').unwrap();
        lines[row].truncate(at + 1); // empty, lines 12 to 14
    }
    lines[20] = lines[20].replacen(",1.", ",100000.", 1); // beyond the robot, line 22
    let dirty = lines.join("\n");
    let error = read_with(&dirty, &ReadingOptions::default()).unwrap_err();
    assert_eq!((error.code, error.line()), ("csv::ragged-row", Some(9)), "{error}");
    let reading = read_with(&dirty, &ReadingOptions { skip_invalid: true, ..ReadingOptions::default() }).unwrap();
    assert_eq!(reading.samples.len(), 39 - 5);
    let words = &reading.notices[0];
    for part in [
        "5 of 39 rows are left out",
        "1 such as line 9 (this row has 8 fields",
        "3 such as line 12 (column `cable_length_m_4` is empty",
        "1 such as line 22 (column `x_m`",
    ] {
        assert!(words.contains(part), "`{part}` is missing in: {words}");
    }
    assert_eq!(reading.samples.lines.as_ref().unwrap()[..7], [2, 3, 4, 5, 8, 10, 11]);
}

#[test]
fn a_file_with_gaps_everywhere_is_refused_by_its_first() {
    let options = ReadingOptions { skip_invalid: true, ..ReadingOptions::default() };
    let text = whole(&robot(), 3).replace(",1.", ",no");
    let error = read_with(&text, &options).unwrap_err();
    assert_eq!((error.code, error.line()), ("csv::not-a-number", Some(2)), "{error}");
}

#[test]
fn data_without_poses_are_refused_with_the_reason() {
    let text: String = whole(&robot(), 3)
        .lines()
        .map(|line| {
            let fields: Vec<&str> = line.split(',').collect();
            format!("{},{}\n", fields[0], fields[3..].join(","))
        })
        .collect();
    let error = read_with(&text, &ReadingOptions::default()).unwrap_err();
    assert_eq!((error.code, error.line()), ("csv::no-poses", Some(1)));
    let words = error.to_string();
    assert!(words.contains("no poses") && words.contains("which columns are x_m, y_m"), "{words}");
}

#[test]
fn lengths_that_count_from_an_unknown_pose_are_lengths_with_unknown_offsets() {
    let text = whole(&robot(), 5);
    let plain = read_with(&text, &ReadingOptions::default()).unwrap();
    let changes = text.replace("cable_length_m", "cable_length_change_m");
    let reading = read_with(&changes, &ReadingOptions::default()).unwrap();
    assert_eq!(reading.samples, plain.samples);
    assert!(reading.notices[0].contains("length-offset"), "{:?}", reading.notices);
}

#[test]
fn cables_counted_from_0_are_refused_with_their_new_names() {
    let plain = ReadingOptions::default();
    let from_0 = (1..=4).fold(whole(&robot(), 8), |text, cable| {
        text.replacen(&format!("cable_length_m_{cable}"), &format!("cable_length_m_{}", cable - 1), 1)
    });
    let error = read_with(&from_0, &plain).unwrap_err();
    assert_eq!((error.code, error.line()), ("csv::cable-count", Some(1)), "{error}");
    let words = error.to_string();
    assert!(words.contains("counted from 1: rename _0 … _3 to _1 … _4") && words.contains("data.csv:1:13"), "{words}");
    // a column more, beside those of all cables
    let more = whole(&robot(), 8).replace("t_s", "tension_N_0").replacen("tension_N_0", "cable_length_m_0", 1);
    assert_eq!(read_with(&more, &plain).unwrap().samples.len(), 8);
    // the map may name them
    let names: Vec<(String, String)> =
        (1..=4).map(|cable| (format!("cable_length_m_{cable}"), format!("cable_length_m_{}", cable - 1))).collect();
    let pairs: Vec<(&str, &str)> = names.iter().map(|(name, column)| (name.as_str(), column.as_str())).collect();
    let read = read_with(&from_0, &mapped(&pairs)).unwrap().samples;
    assert_eq!(read.lengths, read_with(&whole(&robot(), 8), &plain).unwrap().samples.lengths);
}

#[test]
fn blanks_before_quotes_are_none_of_the_name_or_the_number() {
    let plain = ReadingOptions::default();
    let text = whole(&robot(), 6);
    let (header, body) = text.split_once('\n').unwrap();
    let quoted = |line: &str| line.split(',').map(|field| format!("\"{field}\"")).collect::<Vec<_>>().join(", ");
    let expected = read_with(&text, &plain).unwrap().samples;
    let named = format!("{}\n{body}", quoted(header));
    assert_eq!(read_with(&named, &plain).unwrap().samples, expected);
    let all: String = text.lines().map(|line| quoted(line) + "\n").collect();
    assert_eq!(read_with(&all, &plain).unwrap().samples, expected);
}

#[test]
fn what_stands_for_no_number_offers_to_leave_the_row_out() {
    for word in ["-", "#N/A", "n/a", "NaN", "NA", "null", ""] {
        let text = whole(&robot(), 6).replacen("\n0.02,", &format!("\n0.02,{word},"), 1);
        let text = text.lines().map(|line| {
            let fields: Vec<&str> = line.split(',').collect();
            let is_longer = fields.len() > 7;
            let kept = fields.iter().enumerate().filter(|(place, _)| !(is_longer && *place == 2));
            kept.map(|(_, field)| *field).collect::<Vec<_>>().join(",") + "\n"
        });
        let text: String = text.collect();
        let error = read_with(&text, &ReadingOptions::default()).unwrap_err();
        assert_eq!((error.code, error.line()), ("csv::not-a-number", Some(4)), "{word}: {error}");
        assert!(error.to_string().contains("have rows with mistakes left out"), "{word}: {error}");
        let options = ReadingOptions { skip_invalid: true, ..ReadingOptions::default() };
        assert_eq!(read_with(&text, &options).unwrap().samples.len(), 5, "{word}");
    }
}

#[test]
fn parts_of_the_data_have_the_words_that_splits_know() {
    let with = |words: [&str; 4]| {
        let text = whole(&robot(), 4);
        let mut words = std::iter::once("set").chain(words);
        text.lines().map(|line| format!("{line},{}\n", words.next().unwrap())).collect::<String>()
    };
    let read = |words| read_with(&with(words), &ReadingOptions::default());
    let samples = read(["train", "validation", "test", ""]).unwrap().samples;
    assert_eq!(samples.set.unwrap(), ["train", "validation", "test", ""]);
    let error = read(["train", "train", "val", "train"]).unwrap_err();
    assert_eq!((error.code, error.line()), ("csv::set", Some(4)), "{error}");
    let words = error.to_string();
    assert!(words.contains("`val`") && words.contains("`train`, and `validation` or `test`"), "{words}");
}

/// A log of the winches at 100 Hz and one of a tracker at 120 Hz with a gap of half a second: rows in the gap have no
/// pose.
#[test]
fn two_logs_are_merged_by_time_and_not_across_gaps() {
    let robot = robot();
    let mut log = format!("t_s,{LENGTHS}\n");
    for (time, _, q) in rows(&robot, 300) {
        writeln!(log, "{time},{},{},{},{}", q[0], q[1], q[2], q[3]).unwrap();
    }
    let mut track = "stamp;X;Y\n".to_owned();
    for k in 0..=400 {
        let time = f64::from(k) / 120.0;
        if !(1.0..1.5).contains(&time) {
            let [x, y] = [0.5 + 0.8 * time.cos(), 4.0 + 0.8 * time.sin()];
            track += &format!("{time};{x};{y}\n").replace('.', ",");
        }
    }
    let options = mapped(&[("x_m", "X"), ("y_m", "Y"), ("t_s", "stamp")]);
    let plain = ReadingOptions::default();
    let data = MeasurementFile { bytes: log.as_bytes(), name: "log.csv", options: &plain };
    let tracker = MeasurementFile { bytes: track.as_bytes(), name: "tracker.csv", options: &options };
    let reading = data.merged_with(&tracker, &robot, None).unwrap();
    let samples = &reading.samples;
    // 100 … 149 but those at the edges: the last pose before the gap is at 0.9917 s, the first after it at 1.5 s
    assert_eq!(samples.len(), 300 - 50, "{:?}", reading.notices);
    for sample in 0..samples.len() {
        let pose = samples.poses[sample];
        let found = robot.motion_pattern.pose_to_components(robot.plane, &pose);
        let expected = lengths(&robot, [found[0], found[1]]);
        // the chord of 8.3 ms lies 7 µm off the circle
        for (found, expected) in samples.lengths_of(sample).iter().zip(expected) {
            assert!((found - expected).abs() < 1e-5, "{sample}: {found} {expected}");
        }
    }
    let words = reading.notices.join("\n");
    for part in [
        "tracker.csv: read as ; separated with decimal commas",
        "250 rows have the poses of tracker.csv",
        "50 rows are left out",
    ] {
        assert!(words.contains(part), "`{part}` is missing in: {words}");
    }
    let all = data.merged_with(&tracker, &robot, Some(0.6)).unwrap();
    assert_eq!(all.samples.len(), 300);
    let later = log.replace("\n0", "\n90").replace("\n1", "\n91").replace("\n2", "\n92");
    let data = MeasurementFile { bytes: later.as_bytes(), ..data };
    let error = data.merged_with(&tracker, &robot, None).unwrap_err();
    assert!(error.code == "csv::merge" && error.message.contains("from 90 s to"), "{error}");
}

/// Five poses held for two seconds with noise, and the motions between them.
fn held(robot: &Robot, is_still: bool) -> Samples {
    use rand::{RngExt, SeedableRng};
    let mut noise = rand_chacha::ChaCha8Rng::seed_from_u64(3);
    let (mut samples, mut time) = (Samples { cable_count: 4, ..Samples::default() }, Vec::new());
    for k in 0..1500 {
        let t = 0.01 * f64::from(k);
        // 2 s at rest, 1 s on the way
        let phase = if is_still { (t / 3.0).floor() + ((t % 3.0) - 2.0).max(0.0) } else { t / 3.0 };
        let exact = [0.5 + 0.4 * phase, 4.0 + 0.1 * phase];
        let mut disturbed = |value: f64, sigma: f64| value + sigma * 12.0_f64.sqrt() * (noise.random::<f64>() - 0.5);
        let read = exact.map(|value| disturbed(value, 1e-4));
        samples.poses.push(robot.motion_pattern.pose(robot.plane, &read).unwrap());
        samples.lengths.extend(lengths(robot, exact).iter().map(|length| disturbed(*length, 5e-5)));
        time.push(t);
    }
    samples.time = Some(time);
    samples
}

#[test]
fn poses_held_for_seconds_are_averaged_with_their_scatter() {
    let robot = robot();
    let found = held(&robot, true).at_rest(&robot).unwrap();
    assert!(found.is_held && found.takes_scatter);
    assert_eq!(found.samples.len(), 5);
    for (k, pose) in found.samples.poses.iter().enumerate() {
        let found = robot.motion_pattern.pose_to_components(robot.plane, pose);
        let exact = [0.5 + 0.4 * k as f64, 4.0 + 0.1 * k as f64];
        // 200 rows of 0.1 mm; rows at the edges of the motions are left out
        found
            .iter()
            .zip(exact)
            .for_each(|(found, exact)| assert!((found - exact).abs() < 3e-5, "{k}: {found} {exact}"));
    }
    let (position, length) = (found.samples.sigmas.position.unwrap(), found.samples.sigmas.length.unwrap());
    // 1000 rows of two or four numbers
    assert!((position / 1e-4 - 1.0).abs() < 0.05 && (length / 5e-5 - 1.0).abs() < 0.05, "{position} {length}");
    assert!(found.to_string().starts_with("5 poses are held, each the mean of 201 rows; 495 rows"), "{found}");
}

#[test]
fn a_motion_without_rest_is_cut_into_quasi_static_samples() {
    let robot = robot();
    let samples = held(&robot, false);
    let found = samples.at_rest(&robot).unwrap();
    // 2.06 m in 15 s, a hundredth of the diagonal of 12.8 m or a second each: one every 0.94 s
    assert!(!found.is_held && (14..=18).contains(&found.samples.len()), "{found}");
    assert_eq!((found.rows, found.takes_scatter), ((1500, 0), false));
    for sample in 0..found.samples.len() {
        let pose = robot.motion_pattern.pose_to_components(robot.plane, &found.samples.poses[sample]);
        for (found, expected) in found.samples.lengths_of(sample).iter().zip(lengths(&robot, [pose[0], pose[1]])) {
            // the mean of 90 rows on an arc
            assert!((found - expected).abs() < 2e-4, "{sample}: {found} {expected}");
        }
    }
    let timeless = Samples { time: None, ..samples };
    assert!(timeless.at_rest(&robot).is_err());
}
