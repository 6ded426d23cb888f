//! Positions of planar robots, in columns named after the plane's axes.

use super::content::Columns;
use super::rows::{CsvFile, Row, plain};
use crate::measurement::columns::Quantity;
use crate::measurement::position_columns;
use crate::reading::ReadError;

/// First and second component in older files, which named both `x` and `y` in any plane.
const FORMER: [usize; 2] = [0, 1];

impl CsvFile<'_> {
    /// The columns with positions by the components of the robot's plane; unchanged for spatial robots.
    ///
    /// Files that name both components `x` and `y` in another plane are read too.
    pub(super) fn in_plane(
        &self,
        header: &Row<'_>,
        mut columns: Columns,
        notices: &mut Vec<String>,
    ) -> Result<Columns, ReadError> {
        if !self.robot.motion_pattern.is_planar() {
            return Ok(columns);
        }
        let own = self.robot.plane.indices();
        let named = [0, 1, 2].map(|axis| columns.remove(&Quantity::Position(axis)));
        let has = |axes: [usize; 2]| axes.iter().all(|&axis| named[axis].is_some());
        let is_former = !has(own) && has(FORMER);
        let taken = if is_former { FORMER } else { own };
        for (component, &axis) in taken.iter().enumerate() {
            columns.extend(named[axis].map(|column| (Quantity::Position(component), column)));
        }
        let file_name = self.file_name;
        let names = position_columns(self.robot, "m").join(", ");
        if is_former {
            let axes = self.robot.plane.axes();
            notices.push(format!(
                "{file_name}: x and y are taken for the plane {axes} of the robot; name the columns {names}"
            ));
        }
        let across = (0..3).find(|axis| !own.contains(axis)).and_then(|axis| named[axis]);
        let Some((index, _)) = across.filter(|_| has(own)) else { return Ok(columns) };
        let name = plain(&header.record[index]).into_owned();
        if own == FORMER {
            notices.push(format!("{file_name}: ignored column `{name}`, across the robot's plane"));
            return Ok(columns);
        }
        let message =
            format!("three coordinates, but the robot's are {names}: in older files `{name}` is one of the two");
        let help = format!("remove the column `{name}` if it is across the robot's plane");
        Err(self.at(header, index, "csv::repeated-column", message).with_help(help))
    }
}
