//! The work of the peer programs (NumPy, SciPy, CasADi, Eigen, Ceres and others) on the same inputs, as rows for the same table:
//! `cargo bench -p benches --bench peers -- FOLDER > FOLDER/results/cdpr.jsonl`, where `FOLDER/data` holds the inputs (raw
//! little-endian numbers). See the book, “What it costs”.
//!
//! Times are CPU time of this thread where the system tells it (Linux), else of the wall clock; medians of rounds.

use std::cell::Cell;
use std::hint::black_box;
use std::path::PathBuf;
use std::time::Instant;

use cdpr::calibration::Loss;
use cdpr::calibration::fit::{self, optimal_parameters};
use cdpr::equilibrium::{Solutions, State, closed_form, elastostatics, feasibility, forward_kinematics};
use cdpr::geometry::{Pose, PoseBatch, Wrench};
use cdpr::measurement::Samples;
use cdpr::model::{Composition, Model};
use cdpr::nalgebra::{DMatrix, Vector3};
use cdpr::robot::{CableStiffness, Pulley, Robot, StiffnessBasis};
use cdpr::scalar::LaneTable;
use cdpr::statics::Load;
use cdpr::tension::{Limits, quadratic};

/// Inputs of one run.
struct Data {
    folder: PathBuf,
}

impl Data {
    /// Rows of this many numbers.
    fn rows(&self, name: &str, columns: usize) -> Vec<Vec<f64>> {
        let path = self.folder.join(name);
        let bytes = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let number = |bytes: &[u8]| f64::from_le_bytes(bytes.try_into().expect("eight bytes"));
        let numbers: Vec<f64> = bytes.chunks_exact(8).map(number).collect();
        numbers.chunks_exact(columns).map(<[f64]>::to_vec).collect()
    }

    fn poses(&self, name: &str) -> Vec<Pose> {
        self.rows(name, 6).iter().map(|row| pose_of(row)).collect()
    }

    fn lengths(&self, name: &str) -> LaneTable {
        let rows = self.rows(name, 8);
        let mut table = LaneTable::new(8);
        table.resize(rows.len());
        rows.iter().enumerate().for_each(|(item, row)| table.write(item, row));
        table
    }

    /// The peers' robot with chosen effects.
    fn model(&self, composition: Composition) -> Model {
        let mut robot = Robot::builtin("cablerobot-simulator-helicopter").expect("built in");
        let rows = self.rows("robot.bin", 3);
        for (index, cable) in robot.cables.iter_mut().enumerate() {
            cable.frame_anchor = Vector3::from_row_slice(&rows[index]);
            cable.platform_anchor = Vector3::from_row_slice(&rows[8 + index]);
            (cable.length_offset, cable.length_scale) = (None, None);
            cable.pulley = Some(Pulley::Whole { radius: 0.161, swivel_axis: Vector3::z().into() });
            (cable.series_compliance, cable.hidden_length) = (None, None);
            cable.stiffness = Some(CableStiffness::Axial(2e6));
            cable.stiffness_by = Some(StiffnessBasis::Actual);
        }
        Model::new(robot, composition).expect("a model")
    }
}

/// A pose by position and angles.
fn pose_of(row: &[f64]) -> Pose {
    Pose::from_xyz_angles(Vector3::new(row[0], row[1], row[2]), [row[3], row[4], row[5]])
}

/// CPU time of this thread (s), or the wall clock's.
fn seconds(start: Instant) -> f64 {
    let cpu = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = cpu.and_then(|text| text.split(' ').next().and_then(|first| first.parse::<f64>().ok()));
    nanoseconds.map_or_else(|| start.elapsed().as_secs_f64(), |nanoseconds| nanoseconds * 1e-9)
}

/// Prints one row: nanoseconds per item, `items` of which one call works off.
#[expect(clippy::print_stdout, reason = "the rows are what the program is for")]
fn row(workload: &str, candidate: &str, items: usize, note: &str, work: &mut dyn FnMut()) {
    let start = Instant::now();
    let first = Instant::now();
    work();
    // the system's clock of CPU time ticks every few milliseconds
    let calls = (0.1 / first.elapsed().as_secs_f64()).ceil().max(1.0) as usize;
    let mut times: Vec<f64> = (0..7)
        .map(|_| {
            let before = seconds(start);
            (0..calls).for_each(|_| work());
            (seconds(start) - before) * 1e9 / (calls * items) as f64
        })
        .collect();
    times.sort_by(f64::total_cmp);
    let (median, lo, hi) = (times[3], times[0], times[6]);
    println!(
        "{{\"w\": \"{workload}\", \"c\": \"{candidate}\", \"ns\": {median:.4}, \"lo\": {lo:.4}, \"hi\": {hi:.4}, \"n\": {items}, \
         \"note\": \"{note}\"}}"
    );
}

fn inverse_kinematics(data: &Data) {
    let (rows, poses) = (data.rows("poses.bin", 6), data.poses("poses.bin"));
    let batch: PoseBatch = poses.iter().collect();
    let mut lengths = LaneTable::default();
    for (workload, composition) in [("W1_std", Composition::STANDARD), ("W1_pulley", Composition::PULLEY)] {
        let model = data.model(composition);
        row(workload, "cdpr batch", poses.len(), "streamed out; quaternions in", &mut || {
            model.batch_cable_lengths(black_box(&batch), &mut lengths);
        });
        row(workload, "cdpr pose by pose", 10_000, "", &mut || {
            poses[..10_000].iter().for_each(|pose| drop(black_box(model.cable_lengths(black_box(pose)))));
        });
        let mut own = [0.0; 8];
        row(workload, "cdpr pose by pose, caller's memory", 10_000, "quaternions in", &mut || {
            for pose in &poses[..10_000] {
                model.write_cable_lengths(black_box(pose), &mut own).expect("courses");
                black_box(&mut own);
            }
        });
        row(workload, "cdpr pose by pose, angles in", 10_000, "caller's memory", &mut || {
            for angles in &rows[..10_000] {
                model.write_cable_lengths(&pose_of(black_box(angles)), &mut own).expect("courses");
                black_box(&mut own);
            }
        });
    }
    let model = data.model(Composition::STANDARD);
    let mut state = State::at_home(&model);
    row("W2_struct_jac", "cdpr pose by pose", 10_000, "memory of a state; quaternions in", &mut || {
        for pose in &poses[..10_000] {
            black_box(model.structure_matrix_in(black_box(pose), &mut state).expect("courses"));
        }
    });
    let parts: Vec<PoseBatch> = poses.chunks(512).take(100).map(|part| part.iter().collect()).collect();
    let mut matrices = LaneTable::default();
    row("W2_struct_jac", "cdpr batch", 51_200, "512 at a time; the Jacobian is -A", &mut || {
        parts.iter().for_each(|part| model.batch_structure_matrices(black_box(part), &mut matrices));
    });
}

/// Largest difference of position (m) and angle (rad) between solutions and true poses.
fn largest_error(found: impl Iterator<Item = Pose>, expected: &[Pose]) -> f64 {
    let apart = |(a, b): (Pose, &Pose)| (a.position - b.position).amax().max(a.angle_to(b));
    found.zip(expected).map(apart).fold(0.0, f64::max)
}

fn forward(data: &Data) {
    let (expected, starts) = (data.poses("fk_true.bin"), data.poses("fk_start.bin"));
    let guesses: PoseBatch = starts.iter().collect();
    let model = data.model(Composition::STANDARD);
    let (table, rows) = (data.lengths("fk_q.bin"), data.rows("fk_q.bin", 8));
    let mut solver = forward_kinematics::Solver::new(&model, &Default::default()).expect("settings");
    let mut solutions = Solutions::default();
    solver.solve_batch(&table, &guesses, &mut solutions).expect("lengths");
    let error = largest_error((0..solutions.len()).map(|item| solutions.pose(item)), &expected);
    let steps = (0..solutions.len()).map(|item| f64::from(solutions.iterations(item))).sum::<f64>();
    let note = format!("max err {error:.1e}, mean iterations {:.2}", steps / solutions.len() as f64);
    row("W3_fk", "cdpr batch", starts.len(), &note, &mut || {
        solver.solve_batch(black_box(&table), &guesses, &mut solutions).expect("lengths");
    });
    row("W3_fk", "cdpr one by one", starts.len(), &note, &mut || {
        for (lengths, start) in rows.iter().zip(&starts) {
            black_box(solver.solve(lengths, start).expect("lengths").iterations);
        }
    });
}

fn elastic(data: &Data) {
    let (expected, starts) = (data.poses("fk_true.bin"), data.poses("fk_start.bin"));
    let guesses: PoseBatch = starts.iter().collect();
    let model = data.model(Composition::ELASTIC);
    let (table, rows) = (data.lengths("el_qtheta.bin"), data.rows("el_qtheta.bin", 8));
    let mut solver = elastostatics::Solver::new(&model, &load(), &Default::default()).expect("settings");
    let mut solutions = Solutions::default();
    solver.solve_batch(&table, &guesses, &mut solutions).expect("lengths");
    // the closed form's tensions may be negative, which cables cannot have
    let is_near = |item: &usize| largest_error(std::iter::once(solutions.pose(*item)), &expected[*item..]) < 1e-6;
    let near: Vec<usize> = (0..solutions.len()).filter(is_near).collect();
    let error = near.iter().map(|&item| largest_error(std::iter::once(solutions.pose(item)), &expected[item..]));
    let note = format!(
        "max err {:.1e}, to another equilibrium (slack cables) {}",
        error.fold(0.0, f64::max),
        solutions.len() - near.len()
    );
    row("W6_elastofk", "cdpr batch", starts.len(), &note, &mut || {
        solver.solve_batch(black_box(&table), &guesses, &mut solutions).expect("lengths");
    });
    row("W6_elastofk", "cdpr one by one", starts.len(), &note, &mut || {
        for (lengths, start) in rows.iter().zip(&starts) {
            black_box(solver.solve(lengths, start).expect("lengths").iterations);
        }
    });
}

fn load() -> Load {
    Load::constant(Wrench::new(0.0, 0.0, -7500.0, 0.0, -600.0, 0.0))
}

fn tensions(data: &Data) {
    let model = data.model(Composition::STANDARD);
    let limits = Limits::uniform(8, 1000.0, 9000.0).expect("in order");
    let poses = data.poses("qp_poses.bin");
    let batch: PoseBatch = poses.iter().collect();
    let mut table = LaneTable::default();
    row("W4_closed", "cdpr batch, structure + closed form", poses.len(), "", &mut || {
        closed_form::solve_batch(&model, &load(), &limits, black_box(&batch), &mut table).expect("fits");
    });
    let (mut state, acting) = (State::at_home(&model), load());
    row("W4_closed", "cdpr pose by pose, structure + closed form", poses.len(), "memory of a state", &mut || {
        for pose in &poses {
            black_box(model.closed_form_tensions(black_box(pose), &acting, &limits, &mut state).expect("fits"));
        }
    });
    let matrices: Vec<DMatrix<f64>> = poses.iter().map(|pose| model.structure_matrix(pose).expect("courses")).collect();
    let wrench = [0.0, 0.0, -7500.0, 0.0, -600.0, 0.0];
    let mut solver = quadratic::Solver::new(8, 6);
    let infeasible = Cell::new(0);
    let mut solve = || {
        infeasible.set(0);
        for matrix in &matrices {
            solver.forget();
            let found = solver.solve(black_box(matrix), &wrench, &limits, None).expect("fits");
            infeasible.set(infeasible.get() + usize::from(found.status != quadratic::Status::Feasible));
        }
    };
    solve();
    row("W4_qp", "cdpr exact, cold", matrices.len(), "with a proof where infeasible", &mut solve);
    row("W4_qp_inner", "cdpr exact, cold", matrices.len(), &format!("infeasible {}", infeasible.get()), &mut solve);
    let poses = data.poses("grid.bin");
    let mut answers = vec![false; poses.len()];
    let mut decide = || feasibility::feasible(&model, &load(), &limits, black_box(&poses), &mut answers).expect("fits");
    decide();
    let mut again = answers.clone();
    let feasible = answers.iter().filter(|answer| **answer).count();
    let note = format!("feasible {feasible} of {}", poses.len());
    row("W5_grid", "cdpr exact, batch", poses.len(), &note, &mut || {
        feasibility::feasible(&model, &load(), &limits, black_box(&poses), &mut again).expect("fits");
    });
}

fn calibration(data: &Data) {
    let model = data.model(Composition::STANDARD);
    let (poses, lengths) = (data.poses("cal_x.bin"), data.rows("cal_q.bin", 8).concat());
    let samples = Samples { poses, lengths, cable_count: 8, ..Samples::default() };
    let free = "frame-anchor,platform-anchor".parse().expect("parameters");
    // least squares, as the peers: the default looks for outliers besides
    let settings = fit::Settings { loss: Loss::Squared, ..fit::Settings::default() };
    let found = optimal_parameters(&model, &samples, &free, &settings).expect("data");
    let cost: f64 = (samples.poses.iter().zip(samples.lengths.chunks(8)))
        .flat_map(|(pose, lengths)| {
            let modelled = found.model.cable_lengths(pose).expect("courses");
            modelled.into_iter().zip(lengths).map(|(a, b)| (a - b).powi(2)).collect::<Vec<f64>>()
        })
        .sum();
    let note = format!("cost {cost:.10e}, iterations {}", found.iterations);
    row("W7a_cal48", "cdpr by cable blocks", 1, &note, &mut || {
        black_box(optimal_parameters(&model, black_box(&samples), &free, &settings).expect("data").iterations);
    });
}

fn main() {
    let folder = std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    let Some(folder) = folder.map(PathBuf::from).filter(|folder| folder.join("data").is_dir()) else {
        // `cargo bench` without a folder: there is nothing to compare with
        return;
    };
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global().expect("the first pool");
    let data = Data { folder: folder.join("data") };
    inverse_kinematics(&data);
    forward(&data);
    tensions(&data);
    elastic(&data);
    calibration(&data);
}
