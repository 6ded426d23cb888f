//! Robots and their files.

use cdpr_model::reading::Keyword;
use cdpr_model::robot::caspr::Finding;

use super::adapters::keys;

keys! {
    /// Element of another program's model that the robot lacks wholly or in part.
    FindingKeys as "ImportFinding" of Finding {
        /// Lost part of the element.
        loss.name(),
        /// Name of the XML element.
        element,
        /// Its name in the model, if it has one.
        name,
        /// The file.
        file,
        /// Line in the file, from 1.
        line,
        /// Lost part, with the reason.
        why,
    }
}
