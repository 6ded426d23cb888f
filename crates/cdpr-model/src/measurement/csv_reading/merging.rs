//! Two logs on one clock: the recordings of the winches, and the poses of a tracker.

use super::content::Content;
use super::rows::CsvFile;
use super::{MeasurementFile, Reading, Table};
use crate::measurement::columns::meaning;
use crate::measurement::pose_track::PoseTrack;
use crate::reading::ReadError;
use crate::robot::Robot;

impl MeasurementFile<'_> {
    /// The samples of a log of winches with the poses of a tracker's log, interpolated at the times of the former.
    ///
    /// Both have a column of time on the same clock. Rows in a gap of the tracker's log longer than `longest_gap` (s;
    /// by default three of its typical intervals) have no pose and are left out.
    pub fn merged_with(
        &self,
        track: &MeasurementFile<'_>,
        robot: &Robot,
        longest_gap: Option<f64>,
    ) -> Result<Reading, ReadError> {
        let tracked = track.with_content(Content::Track, robot, |file| {
            let mut table = file.table()?;
            let too_far = std::mem::take(&mut table.too_far);
            table.samples = file.without_too_far(table.samples, too_far, &mut table.skipped)?;
            Ok((table, file.column_names()))
        })?;
        self.with_content(Content::Log, robot, |file| file.with_poses_of(track, tracked, longest_gap))
    }
}

impl CsvFile<'_> {
    /// Samples with the poses of a tracker's log.
    fn with_poses_of(
        &self,
        track: &MeasurementFile<'_>,
        (tracked, names): (Table, Vec<String>),
        longest_gap: Option<f64>,
    ) -> Result<Reading, ReadError> {
        self.check_mapped_in_one_of(&names, track.name)?;
        let mut table = self.table()?;
        let mut poses = PoseTrack::new(tracked.samples.time.as_deref().unwrap_or_default(), &tracked.samples.poses);
        poses.longest_gap = longest_gap.unwrap_or(poses.longest_gap);
        let times = table.samples.time.clone().unwrap_or_default();
        let found: Vec<_> = times.iter().map(|&time| poses.at(time)).collect();
        let kept: Vec<usize> = (0..times.len()).filter(|&row| found[row].is_some()).collect();
        if kept.is_empty() {
            return Err(self.no_common_time(&times, &poses, track.name));
        }
        let mut place = vec![None; times.len()];
        kept.iter().enumerate().for_each(|(new, &old)| place[old] = Some(new));
        table.too_far.rows = table.too_far.rows.iter().filter_map(|&sample| place[sample]).collect();
        table.samples = table.samples.subset(&kept);
        table.samples.poses = found.into_iter().flatten().collect();
        let lost = times.len() - kept.len();
        let mut words =
            format!("{}: {} rows have the poses of {}, interpolated by time", self.file_name, kept.len(), track.name);
        if lost > 0 {
            words += &format!("; {lost} rows are left out: no pose, or a gap of more than {:.3} s", poses.longest_gap);
        }
        let tracker_rows = tracked.samples.len() + tracked.skipped.count();
        table.notices.extend(tracked.notices);
        table.notices.extend(tracked.skipped.words(track.name, tracker_rows));
        table.notices.push(words);
        self.judged(table)
    }

    /// Names of the file's columns.
    fn column_names(&self) -> Vec<String> {
        self.layout.fields().iter().map(|name| name.trim().trim_matches('"').to_owned()).collect()
    }

    /// Refuses an entry of the name map for a column that neither file has.
    fn check_mapped_in_one_of(&self, others: &[String], other_name: &str) -> Result<(), ReadError> {
        let own = self.column_names();
        let is_known = |column: &String| own.contains(column) || others.contains(column);
        let missing = self.options.columns.iter().find(|(name, column)| meaning(name).is_ok() && !is_known(column));
        let Some((name, column)) = missing else { return Ok(()) };
        let message =
            format!("columns: there is no column `{column}`, which is to be `{name}`, in this file or in {other_name}");
        let help = format!("this file has {}; {other_name} has {}", own.join(", "), others.join(", "));
        Err(self.header_error("csv::columns", message).with_help(help))
    }

    fn no_common_time(&self, times: &[f64], poses: &PoseTrack, track_name: &str) -> ReadError {
        let (first, last) =
            times.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), t| (low.min(*t), high.max(*t)));
        let (start, end) = poses.span().unwrap_or((f64::NAN, f64::NAN));
        let message = format!(
            "no row has a pose: the rows are from {first} s to {last} s, the poses of {track_name} from {start} s to {end} s"
        );
        self.error("csv::merge", message)
            .with_help("both files need times of the same clock; add the difference of the clocks to one of them")
    }
}
