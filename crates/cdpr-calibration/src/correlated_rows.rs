//! Rows of consecutive samples that depend on each other: their correlation times, and what parameters they determine.

use nalgebra::DMatrix;

use super::autocorrelation::correlation_time;
use super::norms::Norms;
use super::residual::rows::GroupRows;

/// Number of independent rows below which a correlation time, and with it a standard deviation, is uncertain by more than a quarter.
pub(super) const FEW_ROWS: f64 = 8.0;

/// Correlation times of a group's rows, one for each row of a sample; outliers count as little as for the parameters.
pub(super) fn times(group: &GroupRows, norms: &Norms) -> Vec<f64> {
    let time = |series: &Vec<f64>| {
        let mut series = series.clone();
        norms.weigh(&mut series);
        correlation_time(&series)
    };
    group.series.iter().map(time).collect()
}

/// The second largest, or the only one: of several rows of a sample chance correlates one now and then, hardly two, and noise of a pose is in as many
/// rows as it has components, whatever the noise of tensions in the others.
pub(super) fn typical(times: &[f64]) -> f64 {
    let mut times = times.to_vec();
    times.sort_by(|a, b| b.total_cmp(a));
    times[1.min(times.len() - 1)]
}

/// Jᵀ C J of the rows in units of their noise, C the correlation of each row's series: a first-order autoregression with its correlation time.
/// C = F Fᵀ, F the innovations of that process, so that FᵀJ is a recursion from the last row on and only half of its products are to be formed; a
/// kind of row costs only the columns that it depends on, as lengths of a cable do not depend on the parameters of the others.
pub(super) fn information(group: &GroupRows, times: &[f64]) -> DMatrix<f64> {
    let (columns, kinds) = (group.weighted_rows.ncols(), times.len());
    let samples = group.weighted_rows.nrows() / kinds.max(1);
    let mut information = DMatrix::zeros(columns, columns);
    for (kind, time) in times.iter().enumerate() {
        let correlation = (time - 1.0) / (time + 1.0);
        let rows = group.weighted_rows.rows_with_step(kind, samples, kinds - 1);
        let touched: Vec<usize> = (0..columns).filter(|&column| rows.column(column).amax() != 0.0).collect();
        let mut filtered = rows.select_columns(&touched);
        let innovation = (1.0 - correlation * correlation).sqrt();
        for mut column in filtered.column_iter_mut() {
            // Σ ρᵏ of this row and the rows k behind
            let mut sum = 0.0;
            for entry in column.iter_mut().skip(1).rev() {
                sum = *entry + correlation * sum;
                *entry = innovation * sum;
            }
            column[0] += correlation * sum;
        }
        for (to, &row) in touched.iter().enumerate() {
            for (from, &column) in touched.iter().enumerate().take(to + 1) {
                information[(row, column)] += filtered.column(to).dot(&filtered.column(from));
            }
        }
    }
    information.fill_upper_triangle_with_lower_triangle();
    information
}

/// Warning about residuals that repeat each other, of several cables by up to so much.
pub(super) fn words(time: f64, samples: usize, are_several: bool) -> String {
    let up_to = if are_several { "up to " } else { "" };
    let few = match samples as f64 / time < FEW_ROWS {
        true => ", but so few hardly tell them: record longer",
        false => "",
    };
    format!(
        "residuals of consecutive samples repeat each other (correlation time {up_to}{time:.0} samples, so that the {samples} rows are worth {:.0} independent \
         ones where the pose changes slowly): standard deviations account for it{few}",
        samples as f64 / time
    )
}
