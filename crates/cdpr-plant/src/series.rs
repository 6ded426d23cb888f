//! Rows of numbers over time.

/// Rows over time, linear between them and constant outside.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Series {
    pub(super) times: Vec<f64>,
    pub(super) rows: Vec<Vec<f64>>,
}

/// Error in a series.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SeriesMistake {
    /// True if the times are wrong, false if the rows are.
    pub(super) is_in_times: bool,
    pub(super) message: String,
}

impl Series {
    /// Checks that times rise and that there is one row for each time; `key` is the key of the rows in their file.
    pub(super) fn check(times: &[f64], rows: usize, key: &str) -> Result<(), SeriesMistake> {
        let rises = times.windows(2).all(|pair| pair[0] < pair[1]) && times.iter().all(|time| time.is_finite());
        if times.is_empty() || !rises {
            let message = "time_s are ascending times, one at least".to_owned();
            return Err(SeriesMistake { is_in_times: true, message });
        }
        if rows != times.len() {
            let message = format!("{key} has {rows} rows, time_s {} times", times.len());
            return Err(SeriesMistake { is_in_times: false, message });
        }
        Ok(())
    }

    /// Writes the interpolated row at a time.
    pub(super) fn at(&self, time: f64, row: &mut [f64]) {
        let after = self.times.partition_point(|&other| other <= time);
        let (low, high) = (after.saturating_sub(1), after.min(self.times.len() - 1));
        let width = self.times[high] - self.times[low];
        let fraction = if width > 0.0 { (time - self.times[low]) / width } else { 0.0 };
        for (entry, (a, b)) in row.iter_mut().zip(self.rows[low].iter().zip(&self.rows[high])) {
            *entry = a + (b - a) * fraction;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_straight_between_their_times_and_constant_outside() {
        let series = Series { times: vec![1.0, 3.0], rows: vec![vec![0.0, 4.0], vec![2.0, 0.0]] };
        let at = |time: f64| {
            let mut row = [f64::NAN; 2];
            series.at(time, &mut row);
            row
        };
        assert_eq!([at(0.0), at(1.5), at(3.0), at(9.0)], [[0.0, 4.0], [0.5, 3.0], [2.0, 0.0], [2.0, 0.0]]);
        assert!(Series::check(&[0.0, 0.0], 2, "rows").unwrap_err().is_in_times);
        assert!(Series::check(&[0.0, 1.0], 3, "rows").unwrap_err().message.contains("rows has 3 rows, time_s 2 times"));
    }
}
