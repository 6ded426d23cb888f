//! Robots and their files.

use cdpr_model::reading::Keyword;
use cdpr_model::robot::caspr::Finding;

use super::adapters::keys;

keys! {
    /// Element of another program's model that the robot lacks wholly or in part.
    FindingKeys of Finding { loss.name(), element, name, file, line, why }
}
