//! What is around the answers: lists, schemas, explanations, files of templates, mistakes of callers.

use crate::group::Group;

/// Groups.
pub(crate) fn groups() -> Vec<Group> {
    vec![lists(), mistakes()]
}

fn lists() -> Group {
    Group::new("lists")
        .call("robots")
        .call("robots cogiro")
        .call("new")
        .call("new planar-wide-grid --out book")
        .calls("schema %", &["robot", "study", "scenario", "sweep", "measurement"])
        .call("explain")
        .calls("explain %", &["csv::ragged-row", "ragged-row", "no-such-code"])
        .calls("completions %", &["bash", "zsh", "fish", "elvish", "powershell"])
        .call("man")
}

fn mistakes() -> Group {
    Group::new("mistakes")
        .write(
            "broken.toml",
            "layout_version = 1\nname = \"broken\"\nmotion_pattern = \"2T\"\n[[cable]]\nframe_anchor_m = [0, nan]\n",
        )
        .write("ragged.csv", "x_m,y_m,cable_length_m_1,cable_length_m_2\n0,1,2\n")
        .write("unit.csv", "x_furlong,y_m\n0,1\n")
        .call("check broken.toml")
        .call("check nowhere.toml")
        .call("ik planar-example --pose 0.5")
        .call("ik planar-example --pose -6,8")
        .call("ik planar-example")
        .call("fk planar-example --lengths 1,2")
        .call("fk planar-example --lengths 1,1,1,1")
        .call("tension planar-example --pose 0,5.2 --min 5000 --max 10")
        .call("tension planar-example --pose 0,5.2 --method no-such")
        .calls("evaluate planar-example %", &["ragged.csv", "unit.csv", "nowhere.csv"])
        .call("accuracy broken.toml")
        .call("accuracy {studies}/planar-wide-grid.toml --tension-method none-such")
        .call("reachable {studies}/planar-wide-grid.toml --step -1")
        .call("nonsense")
}
