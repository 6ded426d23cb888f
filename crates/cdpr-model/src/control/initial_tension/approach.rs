//! Stages in which a real robot is brought to its initial tensions.

use super::{Task, driving, offsets_of};
use crate::control::input_error::InputError;
use crate::control::status::Status;

/// The path from one set of initial tensions to another, with the control model commanding x_ini all the time.
#[derive(Clone, Debug, PartialEq)]
pub struct Approach {
    /// The state to be set first, then the stages in their order.
    pub stages: Vec<Stage>,
    /// Cables (0-based) in the order in which a stage moves them: those that pay out first, so that no tension rises
    /// earlier than necessary.
    pub order: Vec<usize>,
    /// Least and largest tension of any cable while the cables move one after the other (N).
    pub tensions: [f64; 2],
    /// Largest distance of the platform from x_ini meanwhile (m).
    pub largest_displacement: f64,
    /// Number of moves after which the machine does not come to rest.
    pub unanswered: usize,
}

/// A stage of the path. After each the platform rests at x_ini: tensions between two balanced sets are balanced too.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// Winch offsets q_off, added to the control model's lengths (m).
    pub offsets: Vec<f64>,
    /// Readings of the force sensors at rest (N).
    pub tensions: Vec<f64>,
    /// Moves of the winches that lead here, one at a time; empty at the start.
    pub moves: Vec<Move>,
}

/// One turn of a winch.
#[derive(Clone, Debug, PartialEq)]
pub struct Move {
    /// Cable (0-based).
    pub cable: usize,
    /// Length that is paid out (m; negative if wound in).
    pub by: f64,
    /// Tensions that emerge (N); `None` if the machine does not come to rest.
    pub tensions: Option<Vec<f64>>,
}

/// The path in this many stages of equal change of tension.
pub fn approach(task: &Task<'_>, from: &[f64], to: &[f64], stages: usize) -> Result<Approach, InputError> {
    let stage = |k: usize| -> Result<Stage, InputError> {
        let fraction = k as f64 / stages.max(1) as f64;
        let tensions: Vec<f64> = from.iter().zip(to).map(|(from, to)| from + fraction * (to - from)).collect();
        Ok(Stage { offsets: offsets_of(task, &tensions)?, tensions, moves: Vec::new() })
    };
    let mut stages: Vec<Stage> = (0..=stages.max(1)).map(stage).collect::<Result<_, _>>()?;
    let (first, last) = (&stages[0].offsets, &stages[stages.len() - 1].offsets);
    let change: Vec<f64> = first.iter().zip(last).map(|(first, last)| last - first).collect();
    let mut order: Vec<usize> = (0..change.len()).collect();
    order.sort_by(|&a, &b| change[b].total_cmp(&change[a]));
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    let mut see = |tensions: &[f64]| {
        range = tensions.iter().fold(range, |[least, most], &f| [least.min(f), most.max(f)]);
    };
    stages.iter().for_each(|stage| see(&stage.tensions));
    let (mut largest_displacement, mut unanswered) = (0.0_f64, 0);
    for k in 1..stages.len() {
        let mut offsets = stages[k - 1].offsets.clone();
        let mut moves = Vec::with_capacity(order.len());
        for &cable in &order {
            let by = stages[k].offsets[cable] - offsets[cable];
            offsets[cable] += by;
            let outcome = driving(task, &offsets)?.outcome(&task.pose);
            let is_at_rest = outcome.status == Status::Converged;
            if is_at_rest {
                largest_displacement = largest_displacement.max((outcome.pose.position - task.pose.position).norm());
                outcome.tensions.iter().for_each(|tensions| see(tensions));
            }
            unanswered += usize::from(!is_at_rest);
            moves.push(Move { cable, by, tensions: outcome.tensions.filter(|_| is_at_rest) });
        }
        stages[k].moves = moves;
    }
    Ok(Approach { stages, order, tensions: range, largest_displacement, unanswered })
}
