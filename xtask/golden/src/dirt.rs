//! Inputs made by seed: robots whose anchors deviate, measurements spoilt in one way.

/// A way to spoil measurements.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Dirt {
    /// One length in twenty is off by up to 0.1 m.
    Outliers,
    /// The position of one row in the middle is off by 0.2 m.
    DisplacedRow,
    /// All lengths of cable 2 are 30 mm longer.
    Offset,
    /// All lengths of cable 1 are 2 % longer.
    Scale,
    /// Lengths in millimetres under names in metres.
    WrongUnit,
    /// The lengths of cables 1 and 2 under each other's name.
    SwappedCables,
    /// One row in three is not there.
    MissingRows,
    /// Some cells are empty.
    Gaps,
    /// All rows are there twice.
    Twice,
    /// The first rows alone, so many.
    First(usize),
    /// Positions are off by up to 10 mm.
    NoisyPositions,
    /// No poses.
    NoPoses,
    /// No tensions.
    NoTensions,
}

/// A table of measurements as text.
struct Table {
    names: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    fn of(text: &str) -> Self {
        let cells = |line: &str| line.split(',').map(str::to_owned).collect();
        let mut lines = text.lines();
        Self { names: lines.next().map(cells).unwrap_or_default(), rows: lines.map(cells).collect() }
    }

    fn text(&self) -> String {
        let lines = [&self.names].into_iter().chain(&self.rows).map(|cells| cells.join(",") + "\n");
        lines.collect()
    }

    fn columns(&self, start: &str) -> Vec<usize> {
        (0..self.names.len()).filter(|&column| self.names[column].starts_with(start)).collect()
    }

    fn positions(&self) -> Vec<usize> {
        let is_position = |&column: &usize| ["x_m", "y_m", "z_m"].contains(&self.names[column].as_str());
        (0..self.names.len()).filter(is_position).collect()
    }

    fn change(&mut self, row: usize, column: usize, change: impl Fn(f64) -> f64) {
        let cell = &mut self.rows[row][column];
        if let Ok(number) = cell.parse() {
            *cell = format!("{:.9}", change(number));
        }
    }

    fn change_column(&mut self, column: usize, change: impl Fn(f64) -> f64) {
        (0..self.rows.len()).for_each(|row| self.change(row, column, &change));
    }

    fn drop_columns(&mut self, drop: impl Fn(&str) -> bool) {
        let kept: Vec<bool> = self.names.iter().map(|name| !drop(name)).collect();
        let keep = |cells: &mut Vec<String>| {
            let mut kept = kept.iter();
            cells.retain(|_| kept.next().copied().unwrap_or(true));
        };
        keep(&mut self.names);
        self.rows.iter_mut().for_each(keep);
    }

    fn keep_rows(&mut self, keep: impl Fn(usize) -> bool) {
        let mut index = 0..;
        self.rows.retain(|_| index.next().is_some_and(&keep));
    }
}

impl Dirt {
    /// Measurements (CSV) spoilt.
    pub(crate) fn on(self, text: &str, seed: u64) -> String {
        let mut table = Table::of(text);
        let mut random = Random(seed);
        let (lengths, middle) = (table.columns("cable_length_m"), table.rows.len() / 2);
        match self {
            Self::Outliers => {
                for (row, column) in
                    (0..table.rows.len()).flat_map(|row| lengths.iter().map(move |&column| (row, column)))
                {
                    let (hit, by) = (random.unit() < 0.05, random.between(-0.1, 0.1));
                    table.change(row, column, |length| if hit { length + by } else { length });
                }
            }
            Self::DisplacedRow => table.change(middle, 0, |position| position + 0.2),
            Self::Offset => table.change_column(lengths[1], |length| length + 0.03),
            Self::Scale => table.change_column(lengths[0], |length| 1.02 * length),
            Self::WrongUnit => lengths.iter().for_each(|&column| table.change_column(column, |length| 1e3 * length)),
            Self::SwappedCables => table.rows.iter_mut().for_each(|row| row.swap(lengths[0], lengths[1])),
            Self::MissingRows => table.keep_rows(|row| row % 3 != 1),
            Self::Gaps => [middle, middle + 2].iter().for_each(|&row| table.rows[row][lengths[0]].clear()),
            Self::Twice => table.rows.extend_from_within(..),
            Self::First(count) => table.rows.truncate(count),
            Self::NoisyPositions => {
                for (row, column) in (0..table.rows.len())
                    .flat_map(|row| table.positions().into_iter().map(move |column| (row, column)))
                    .collect::<Vec<_>>()
                {
                    let by = random.between(-0.01, 0.01);
                    table.change(row, column, |position| position + by);
                }
            }
            Self::NoPoses => {
                table.drop_columns(|name| ["x_m", "y_m", "z_m", "qx", "qy", "qz", "qw", "angle_rad"].contains(&name))
            }
            Self::NoTensions => table.drop_columns(|name| name.starts_with("tension_N")),
        }
        table.text()
    }
}

/// A robot file whose anchors deviate by up to so many metres along each axis.
pub(crate) fn deviating(text: &str, metres: f64, seed: u64) -> String {
    let mut random = Random(seed);
    let line = |line: &str| {
        let is_anchor = line.starts_with("frame_anchor_m") || line.starts_with("platform_anchor_m");
        let Some((start, list)) = line.split_once('[').filter(|_| is_anchor) else { return format!("{line}\n") };
        let Some((list, end)) = list.split_once(']') else { return format!("{line}\n") };
        let numbers: Vec<String> = list
            .split(',')
            .filter_map(|number| number.trim().parse::<f64>().ok())
            .map(|number| format!("{:.6}", number + random.between(-metres, metres)))
            .collect();
        format!("{start}[{}]{end}\n", numbers.join(", "))
    };
    text.lines().map(line).collect()
}

/// Random numbers that are the same for the same seed (SplitMix64).
struct Random(u64);

impl Random {
    /// 0 to 1.
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.unit()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DATA: &str = "x_m,y_m,cable_length_m_1,cable_length_m_2\n0,1,2,3\n1,1,2,4\n2,1,2,5\n3,1,2,6\n4,1,2,7\n";

    #[test]
    fn a_row_is_displaced_and_no_other() {
        let spoilt = Dirt::DisplacedRow.on(DATA, 1);
        assert_eq!(spoilt.replace("2.200000000", "2"), DATA);
    }

    #[test]
    fn the_same_seed_gives_the_same_dirt() {
        assert_eq!(Dirt::NoisyPositions.on(DATA, 7), Dirt::NoisyPositions.on(DATA, 7));
        assert_ne!(Dirt::NoisyPositions.on(DATA, 7), Dirt::NoisyPositions.on(DATA, 8));
    }

    #[test]
    fn columns_and_rows_are_left_out() {
        assert!(Dirt::NoPoses.on(DATA, 1).starts_with("cable_length_m_1,cable_length_m_2\n2,3\n"));
        assert_eq!(Dirt::First(2).on(DATA, 1).lines().count(), 3);
        assert_eq!(Dirt::MissingRows.on(DATA, 1).lines().count(), 1 + 3);
        assert!(Dirt::SwappedCables.on(DATA, 1).contains("0,1,3,2"));
    }

    #[test]
    fn only_anchors_deviate() {
        let robot = "mass_kg = 1.0\nframe_anchor_m = [1.0, 2.0] # here\n";
        let deviating = deviating(robot, 0.01, 3);
        assert!(deviating.starts_with("mass_kg = 1.0\nframe_anchor_m = [") && deviating.ends_with("] # here\n"));
        assert!(!deviating.contains("1.000000, 2.000000"));
    }
}
