//! Times of the library on arrays, for comparison with what Python pays for the same: nanoseconds per pose, the best of many rounds, as JSON.
#![expect(clippy::print_stdout, reason = "an example prints its answer")]

use std::error::Error;
use std::time::{Duration, Instant};

use cdpr::equilibrium::{ForwardAnswers, ForwardRows, ForwardSettings, State, Status};
use cdpr::tension::{self, Limits, Method};
use cdpr::{Load, Model, Pose, Robot};

/// Time that each question is asked again and again.
const PATIENCE: Duration = Duration::from_millis(600);

fn main() -> Result<(), Box<dyn Error>> {
    let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").ok_or("unknown robot")?;
    let rigid = Model::new(robot.clone(), "standard".parse()?)?;
    let elastic = Model::new(robot, "elastic".parse()?)?;
    let mut times = Vec::new();
    for count in [4096, 100_000] {
        let rows = rows(count);
        let mut lengths = vec![0.0; 8 * count];
        let time = best(count, || Ok(rigid.lengths_of_rows(rows[..].into(), &mut lengths)?))?;
        times.push((format!("lengths_{count}"), time));
    }
    let rows = rows(4096);
    let (load, limits) = (Load::of(elastic.robot())?, Limits::of(elastic.robot(), None, None)?);
    let (mut tensions, mut statuses) = (vec![0.0; 8 * 4096], vec![tension::Status::Undecided; 4096]);
    let time = best(4096, || {
        Ok(elastic.tensions_of_rows(&load, &limits, Method::Qp, rows[..].into(), &mut tensions, &mut statuses)?)
    })?;
    times.push(("tensions_4096".to_owned(), time));
    let mut lengths = vec![0.0; 8 * 4096];
    let given = vec![4000.0; 8 * 4096];
    elastic.inverse_of_rows(rows[..].into(), &given, &State::at_home(&elastic), &mut lengths)?;
    let (mut poses, mut ends) = (vec![[0.0; 7]; 4096], vec![Status::NotConverged; 4096]);
    let (mut residual_rms, mut iterations) = (vec![0.0; 4096], vec![0; 4096]);
    let time = best(4096, || {
        let problems = ForwardRows { lengths: &lengths, guesses: rows[..].into(), load: None };
        let answers = ForwardAnswers {
            poses: &mut poses,
            statuses: &mut ends,
            residual_rms: Some(&mut residual_rms),
            iterations: Some(&mut iterations),
            tensions: Some(&mut tensions),
        };
        let settings = ForwardSettings::default();
        Ok(elastic.forward_of_rows(&problems, &settings, &mut State::at_home(&elastic), answers)?)
    })?;
    times.push(("forward_4096".to_owned(), time));
    let entries: Vec<String> = times.iter().map(|(name, time)| format!("\"{name}\": {time:.2}")).collect();
    println!("{{{}}}", entries.join(", "));
    Ok(())
}

/// Poses in the middle of the robot, as `python/benches/times.py` has them.
fn rows(count: usize) -> Vec<[f64; 7]> {
    let pose = |k: usize| {
        let t = k as f64;
        let position = [t.sin(), (1.3 * t).cos(), 2.0 + (0.7 * t).sin()];
        let angles = [0.1 * (0.9 * t).sin(), 0.1 * t.cos(), 0.1 * (0.4 * t).sin()];
        Pose::from_xyz_angles(position.into(), angles).numbers()
    };
    (0..count).map(pose).collect()
}

/// Nanoseconds per pose of the fastest round.
fn best(count: usize, mut round: impl FnMut() -> Result<(), Box<dyn Error>>) -> Result<f64, Box<dyn Error>> {
    let (begun, mut best) = (Instant::now(), f64::INFINITY);
    while begun.elapsed() < PATIENCE {
        let start = Instant::now();
        round()?;
        best = best.min(start.elapsed().as_secs_f64());
    }
    Ok(1e9 * best / count as f64)
}
