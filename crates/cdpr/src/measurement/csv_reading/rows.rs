//! A measurement file, and one row of it.

use std::collections::BTreeMap;

use csv::ByteRecord;

use crate::measurement::columns::Quantity;
use crate::robot::Robot;

/// Columns of a file by quantity: their index and factor to SI.
pub(super) type Columns = BTreeMap<Quantity, (usize, f64)>;

/// A file as it is read.
pub(super) struct CsvFile<'a> {
    pub(super) text: &'a str,
    pub(super) file_name: &'a str,
    pub(super) robot: &'a Robot,
}

/// One data row with its place in the file.
pub(super) struct Row<'a> {
    pub(super) record: &'a ByteRecord,
    pub(super) header: &'a ByteRecord,
    pub(super) line: usize,
}
