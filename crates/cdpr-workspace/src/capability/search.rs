//! Branch and bound: the least value of every quantity in a box.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::demand::{Absent, Quantity};
use super::face::{Judged, Place};
use super::limit::{LimitedBy, NotHeld};
use super::question::Capability;
use crate::{Bounds, Point, WorkspaceError};
use cdpr_model::scalar::map_all;

/// When the search stops.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Largest difference between value and lower bound, divided by the value.
    pub gap: f64,
    /// Poses that may be judged.
    pub poses: u64,
}

impl Default for Settings {
    fn default() -> Self {
        Self { gap: 0.01, poses: 100_000 }
    }
}

/// Why the search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Status {
    /// Every quantity is known within the gap.
    Found,
    /// More poses than allowed would be needed: the gap is wider than asked for.
    PosesUsedUp,
    /// The robot does not hold its own load somewhere in the box.
    NotHeld,
}

/// The least value of a quantity in the box.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The quantity.
    pub quantity: Quantity,
    /// Least value of all poses that were judged.
    pub value: f64,
    /// Lower bound that holds everywhere in the box; −∞ while it is not proved that the load is held everywhere.
    pub at_least: f64,
    /// Point with the least value.
    pub at: Point,
    /// Limit that stands in the way of more there.
    pub limited_by: LimitedBy,
}

impl Found {
    /// Share of the value by which it may be too large: 0 to 1.
    pub fn gap(&self) -> f64 {
        match self.value > 0.0 {
            true => ((self.value - self.at_least.max(0.0)) / self.value).max(0.0),
            false => 0.0,
        }
    }
}

/// Answer for a box.
#[must_use = "check `status` before using the values"]
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Why the search ended.
    pub status: Status,
    /// Quantities that are answered; empty if the own load is not held.
    pub found: Vec<Found>,
    /// Quantities that the robot's file does not answer.
    pub absent: Vec<Absent>,
    /// A pose at which the own load is not held.
    pub not_held: Option<NotHeld>,
    /// Poses that were judged.
    pub poses: u64,
}

/// Poses along each side of the box before the search.
const SIDE: usize = 5;
/// Cells that are cut at once.
const BATCH: usize = 64;
/// Share of a value that is rounding.
const ROUNDING: f64 = 1e-12;
/// Step at which the descent ends, as a share of the box.
const FINEST: f64 = 1e-4;

impl Capability<'_> {
    /// The least value of every quantity in a box of positions.
    pub fn solve(&self, bounds: &Bounds, settings: &Settings) -> Result<Solution, WorkspaceError> {
        let (expected, found) = (2 * self.model.axes().len(), 2 * bounds.dimension());
        if expected != found {
            return Err(WorkspaceError::BoundsCount { expected, found });
        }
        for (setting, value, wanted) in [
            ("gap", settings.gap, "it is a share above 0 and below 1"),
            ("number of poses", settings.poses as f64, "it is 1 or more"),
        ] {
            if !(value > 0.0 && (setting != "gap" || value < 1.0)) {
                return Err(WorkspaceError::Capability { setting, value, wanted });
            }
        }
        let mut search = Search { asked: self, bounds, settings, best: Vec::new(), poses: 0 };
        let ended = search.run();
        let poses = search.poses;
        let absent = self.absent.clone();
        match ended {
            Err(not_held) => {
                Ok(Solution { status: Status::NotHeld, found: Vec::new(), absent, not_held: Some(*not_held), poses })
            }
            Ok(at_least) => {
                let found: Vec<Found> = search.found(&at_least);
                let is_found = found.iter().all(|one| one.at_least >= (1.0 - settings.gap) * one.value);
                let status = if is_found { Status::Found } else { Status::PosesUsedUp };
                Ok(Solution { status, found, absent, not_held: None, poses })
            }
        }
    }
}

/// A part of the box.
#[derive(Clone, Debug)]
struct Cell {
    center: Point,
    half: Point,
    at_least: Vec<f64>,
    /// Least bound over value of all quantities.
    share: f64,
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cell {
    /// The least share comes first, of these the largest cell.
    fn cmp(&self, other: &Self) -> Ordering {
        let size = |cell: &Self| cell.half.iter().map(|side| side * side).sum::<f64>();
        let by_place = |a: &Point, b: &Point| a.iter().zip(b).map(|(a, b)| a.total_cmp(b)).find(|order| order.is_ne());
        (other.share.total_cmp(&self.share))
            .then(size(self).total_cmp(&size(other)))
            .then_with(|| by_place(&self.center, &other.center).unwrap_or(Ordering::Equal))
    }
}

/// Least value of a quantity so far.
#[derive(Clone, Copy, Debug)]
struct Best {
    value: f64,
    at: Point,
}

struct Search<'a> {
    asked: &'a Capability<'a>,
    bounds: &'a Bounds,
    settings: &'a Settings,
    best: Vec<Best>,
    poses: u64,
}

impl Search<'_> {
    /// Lower bounds of all quantities.
    fn run(&mut self) -> Result<Vec<f64>, Box<NotHeld>> {
        let count = self.asked.demands.len();
        self.best = vec![Best { value: f64::INFINITY, at: self.bounds.middle() }; count];
        self.look_around()?;
        (0..count).try_for_each(|index| self.descend(index))?;
        let mut half = [0.0; 3];
        (0..self.bounds.dimension()).for_each(|axis| half[axis] = 0.5 * self.bounds.extent(axis));
        let whole = Cell { center: self.bounds.middle(), half, at_least: vec![f64::NEG_INFINITY; count], share: -1.0 };
        let (mut open, mut least) = (BinaryHeap::from([whole]), vec![f64::INFINITY; count]);
        let mut keep = |cell: &Cell| {
            least.iter_mut().zip(&cell.at_least).for_each(|(least, bound)| *least = least.min(*bound));
        };
        while !open.is_empty() && self.poses < self.settings.poses {
            let mut parts = Vec::new();
            while parts.len() < 2 * BATCH
                && let Some(cell) = open.pop()
            {
                // values may have fallen since the cell was judged
                match self.share(&cell.at_least) >= 1.0 - self.settings.gap {
                    true => keep(&cell),
                    false => parts.extend(halves(&cell)),
                }
            }
            let places: Vec<Place> = parts.iter().map(|part| self.place(part)).collect();
            let judged = self.judge_all(&places)?;
            for (mut part, judged) in parts.into_iter().zip(judged) {
                // what holds in a cell holds in its parts
                let bounds = part.at_least.iter_mut().zip(&judged.at_least);
                bounds.for_each(|(bound, found)| *bound = bound.max(*found));
                part.share = self.share(&part.at_least);
                open.push(part);
            }
        }
        open.iter().for_each(keep);
        Ok(least)
    }

    /// A cell, with the quantities that its bounds leave open.
    fn place(&self, cell: &Cell) -> Place {
        let is_open = |index: &usize| self.share_of(*index, cell.at_least[*index]) < 1.0 - self.settings.gap;
        let bounded = (0..self.best.len()).filter(is_open).map(|index| 1 << index).sum();
        Place { center: cell.center, half: cell.half, bounded }
    }

    /// Judges the poses of a grid over the box with its faces; an error with the worst one if the load is not held.
    fn look_around(&mut self) -> Result<(), Box<NotHeld>> {
        let dimension = self.bounds.dimension();
        let at = |index: usize| {
            let mut point = [0.0; 3];
            for (axis, along) in point.iter_mut().enumerate().take(dimension) {
                let step = index / SIDE.pow(axis as u32) % SIDE;
                *along = self.bounds.least()[axis] + self.bounds.extent(axis) * step as f64 / (SIDE - 1) as f64;
            }
            Place::pose(point)
        };
        let places: Vec<Place> = (0..SIDE.pow(dimension as u32)).map(at).collect();
        self.judge_all(&places).map(drop)
    }

    /// Steps along the axes from the best pose of a quantity, shorter ones where none is better.
    fn descend(&mut self, index: usize) -> Result<(), Box<NotHeld>> {
        let mut step = 0.5 / (SIDE - 1) as f64;
        while step > FINEST {
            let Best { value, at } = self.best[index];
            let around = (0..self.bounds.dimension()).flat_map(|axis| {
                [-1.0, 1.0].map(|sense| {
                    let (mut point, by) = (at, sense * step * self.bounds.extent(axis));
                    let (least, largest) = (self.bounds.least()[axis], self.bounds.largest()[axis]);
                    point[axis] = (point[axis] + by).clamp(least, largest);
                    Place::pose(point)
                })
            });
            let around: Vec<Place> = around.filter(|place| place.center != at).collect();
            self.judge_all(&around)?;
            if self.best[index].value >= value {
                step *= 0.5;
            }
        }
        Ok(())
    }

    /// Judges cells by centre and half sides, and keeps the least values; an error with the worst pose if the load is not held.
    fn judge_all(&mut self, places: &[Place]) -> Result<Vec<Judged>, Box<NotHeld>> {
        let asked = self.asked;
        let answers = map_all(places.len(), |place| asked.judge(&places[place]));
        self.poses += places.len() as u64;
        let (mut judged, mut failed) = (Vec::with_capacity(answers.len()), Vec::new());
        for answer in answers {
            match answer {
                Ok(one) => judged.push(one),
                Err(not_held) => failed.push(not_held),
            }
        }
        if let Some(worst) = failed.into_iter().max_by(|a, b| a.lacking.total_cmp(&b.lacking)) {
            return Err(worst);
        }
        for (one, Place { center, .. }) in judged.iter().zip(places) {
            for (best, value) in self.best.iter_mut().zip(&one.values) {
                // the first of poses that are as bad but for rounding
                if *value < best.value * (1.0 - ROUNDING) {
                    *best = Best { value: *value, at: *center };
                }
            }
        }
        Ok(judged)
    }

    /// Least bound over value of all quantities; below zero while the load may not be held.
    fn share(&self, at_least: &[f64]) -> f64 {
        let shares = at_least.iter().enumerate().map(|(index, bound)| self.share_of(index, *bound));
        shares.fold(f64::INFINITY, f64::min)
    }

    fn share_of(&self, index: usize, bound: f64) -> f64 {
        match self.best[index].value {
            _ if bound < 0.0 => -1.0,
            value if value <= 0.0 => 1.0,
            value => bound / value,
        }
    }

    fn found(&self, at_least: &[f64]) -> Vec<Found> {
        let one = |(index, best): (usize, &Best)| {
            Some(Found {
                quantity: self.asked.demands[index].quantity(),
                value: best.value,
                at_least: at_least[index].min(best.value),
                at: best.at,
                limited_by: self.asked.limited_by(index, &best.at)?,
            })
        };
        self.best.iter().enumerate().filter_map(one).collect()
    }
}

/// The two halves of a cell, cut across its longest side.
fn halves(cell: &Cell) -> [Cell; 2] {
    let longest = (0..3).max_by(|&a, &b| cell.half[a].total_cmp(&cell.half[b])).unwrap_or(0);
    [-0.5, 0.5].map(|sense| {
        let mut part = cell.clone();
        part.half[longest] *= 0.5;
        part.center[longest] += sense * cell.half[longest];
        part
    })
}
