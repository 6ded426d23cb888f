//! Circles of files: no file of a crate uses another one that leads back to it.
//!
//! Uses are read from the text: `use` trees, paths in the code, types and functions by their names. Modules that are known by another name,
//! names that a module hands on and `*` are followed to the file that defines the name; what a module only hands on is no use of its own.
//! Tests do not count, nor do methods: a call of a method is not seen as a use of the file of its `impl`.

pub(crate) mod graph;
mod known;
mod names;
mod scope;
mod tokens;

use std::path::{Path, PathBuf};

use self::graph::Graph;
use self::known::{KNOWN, Known};
use self::scope::Crate;

/// Uses of a crate's files by each other. `source` is the folder of `files`.
pub(crate) fn graph(folder: &str, source: &Path, files: &[PathBuf]) -> Graph {
    let mut read = Crate::new(folder);
    for path in files {
        let (Ok(inside), Ok(text)) = (path.strip_prefix(source), std::fs::read_to_string(path)) else { continue };
        read.add(inside, &text);
    }
    read.graph()
}

/// Complaints of a crate's circles that are not listed, and of listed uses that are part of no circle.
pub(crate) fn complaints(folder: &str, graph: &Graph) -> Vec<String> {
    let mut complaints = ended(folder, graph, KNOWN);
    complaints.extend(unknown(folder, graph, KNOWN));
    complaints
}

/// Complaints of listed uses in crates that are not there.
pub(crate) fn lost(folders: &[String]) -> Vec<String> {
    let lost = KNOWN.iter().filter(|known| !folders.iter().any(|folder| folder == known.folder));
    lost.map(|known| format!("{}: this crate of xtask/src/circles/known.rs is not there", known.folder)).collect()
}

fn ended(folder: &str, graph: &Graph, known: &[Known]) -> Vec<String> {
    let closes = |known: &&Known| graph.has(known.from, known.to) && graph.shortest(known.to, known.from).is_some();
    let ended = known.iter().filter(|known| known.folder == folder && !closes(known));
    ended
        .map(|known| {
            let (from, to, reason) = (known.from, known.to, known.reason);
            format!("{folder}: `{from}` -> `{to}` closes no circle any more ({reason}): remove it from xtask/src/circles/known.rs")
        })
        .collect()
}

fn unknown(folder: &str, graph: &Graph, known: &[Known]) -> Vec<String> {
    let mut rest = graph.clone();
    for known in known.iter().filter(|known| known.folder == folder) {
        rest.remove(known.from, known.to);
    }
    let told = |circle: Vec<String>| {
        let way = circle.iter().filter_map(|file| rest.shortest(file, file)).min_by_key(Vec::len).unwrap_or_default();
        let steps: Vec<String> =
            way.iter().map(|one| format!("{}:{} uses {} (`{}`)", one.from, one.line, one.to, one.path)).collect();
        format!(
            "{folder}: {} files use each other in a circle: {}\n    {}",
            circle.len(),
            circle.join(", "),
            steps.join("\n    ")
        )
    };
    rest.circles().into_iter().map(told).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graph_of(files: &[(&str, &str)]) -> Graph {
        let mut read = Crate::new("crates/cdpr-plant");
        files.iter().for_each(|(name, text)| read.add(Path::new(name), text));
        read.graph()
    }

    fn found(files: &[(&str, &str)]) -> Vec<Vec<String>> {
        graph_of(files).circles()
    }

    #[test]
    fn two_files_that_use_each_other_are_a_circle() {
        let drum = ("winch/drum.rs", "use super::layers::Layer;\npub struct Drum(Layer);\n");
        let layers = ("winch/layers.rs", "use super::drum::Drum;\npub struct Layer;\nfn f(drum: &Drum) {}\n");
        assert_eq!(found(&[drum, layers]), [["winch/drum.rs", "winch/layers.rs"]]);
        let alone = ("winch/layers.rs", "pub struct Layer;\n// use super::drum::Drum;\n");
        assert!(found(&[drum, alone]).is_empty());
    }

    #[test]
    fn a_module_known_by_its_name_or_another_one_is_followed() {
        let report = ("objective/report.rs", "use crate::fit::estimate;\npub fn fit() { estimate() }\n");
        let objective = ("objective.rs", "mod report;\npub(crate) use self::report::fit;\n");
        let of = |text| found(&[report, objective, ("fit.rs", text)]).concat();
        let circle = ["fit.rs", "objective/report.rs"];
        assert_eq!(of("use super::objective;\npub fn estimate() { objective::fit() }\n"), circle);
        assert_eq!(of("use crate::objective as o;\npub fn estimate() { o::fit() }\n"), circle);
        assert_eq!(of("use crate::objective::report as r;\npub fn estimate() { let f = r::fit; }\n"), circle);
        assert_eq!(of("pub fn estimate() { use crate::objective; objective::fit() }\n"), circle);
        assert!(
            of("use super::objective;\npub fn estimate() {}\n").is_empty(),
            "a module alone is no use of its items"
        );
    }

    #[test]
    fn names_that_a_module_hands_on_are_those_of_the_file_that_defines_them() {
        let module = ("mesh/mod.rs", "mod field;\nmod writing;\npub use field::{Field, Unit as Measure};\n");
        let field = ("mesh/field.rs", "pub struct Field;\npub struct Unit;\n");
        let writing = ("mesh/writing.rs", "use super::{Field, Measure};\npub fn write(field: &Field) {}\n");
        assert!(found(&[module, field, writing]).is_empty());
        let back = (
            "mesh/field.rs",
            "use crate::mesh::writing;\npub struct Field;\npub struct Unit;\nfn f() { writing::write() }\n",
        );
        assert_eq!(found(&[module, back, writing]).len(), 1);
    }

    #[test]
    fn a_chain_of_modules_that_hand_a_name_on_is_followed_to_its_end() {
        let root = ("lib.rs", "mod laws;\nmod drum;\npub use laws::Law;\n");
        let laws = ("laws/mod.rs", "mod all;\npub(crate) use all::*;\n");
        let all = ("laws/all.rs", "pub(super) use super::hooke::Hooke as Law;\n");
        let hooke = ("laws/hooke.rs", "use crate::drum;\npub struct Hooke;\nfn f() { drum::turn() }\n");
        let drum = ("drum.rs", "use crate::Law;\npub fn turn() {}\n");
        assert_eq!(found(&[root, laws, all, hooke, drum]), [["drum.rs", "laws/hooke.rs"]]);
        let by_all = ("drum.rs", "use crate::laws::*;\npub fn turn() { Law::new(); }\n");
        assert_eq!(found(&[root, laws, all, hooke, by_all]), [["drum.rs", "laws/hooke.rs"]]);
        let by_crate = ("drum.rs", "pub fn turn() { cdpr_plant::Law::new(); }\n");
        assert_eq!(found(&[root, laws, all, hooke, by_crate]), [["drum.rs", "laws/hooke.rs"]]);
        let itself = ("laws/all.rs", "pub use crate::Law;\n");
        assert!(found(&[root, laws, itself, drum]).is_empty(), "names that lead nowhere end");
    }

    #[test]
    fn a_module_that_hands_a_name_on_and_uses_it_is_a_user() {
        let module = ("grid.rs", "mod cells;\npub use cells::{Cells, count};\npub struct Grid(Cells);\n");
        let cells = ("grid/cells.rs", "use super::Grid;\npub struct Cells;\npub fn count(grid: &Grid) {}\n");
        assert_eq!(found(&[module, cells]), [["grid.rs", "grid/cells.rs"]]);
        let calling = ("grid.rs", "mod cells;\npub use cells::count;\npub struct Grid;\nfn f() { count(&Grid) }\n");
        assert_eq!(found(&[calling, cells]).len(), 1);
        let only = ("grid.rs", "mod cells;\npub use cells::{Cells, count};\npub struct Grid;\n");
        assert!(found(&[only, cells]).is_empty());
    }

    #[test]
    fn methods_of_the_same_name_do_not_hide_what_a_module_hands_on() {
        let module =
            ("mesh.rs", "mod write;\npub use write::write;\npub struct Mesh;\nimpl Mesh { fn write(&self) {} }\n");
        let write = ("mesh/write.rs", "use crate::page::Page;\npub fn write(page: &Page) {}\n");
        let page = ("page.rs", "use crate::mesh;\npub struct Page;\nfn f(page: &Page) { mesh::write(page) }\n");
        assert_eq!(found(&[module, write, page]), [["mesh/write.rs", "page.rs"]]);
    }

    #[test]
    fn a_function_with_the_name_of_a_module_has_no_names_inside() {
        let module = ("winch.rs", "mod drum;\nmod numbers;\nuse drum::Drum;\nfn numbers(drum: Drum) {}\n");
        let drum = ("winch/drum.rs", "use super::numbers::Numbers;\npub struct Drum(Numbers);\n");
        let numbers = ("winch/numbers.rs", "pub struct Numbers;\n");
        assert!(found(&[module, drum, numbers]).is_empty());
    }

    #[test]
    fn a_module_that_calls_a_child_which_uses_it_is_a_circle() {
        let module = ("solve/mod.rs", "mod descend;\npub struct Rules;\npub fn f() { descend::descend(&Rules) }\n");
        let child = ("solve/descend.rs", "use super::Rules;\npub fn descend(rules: &Rules) {}\n");
        assert_eq!(found(&[module, child]).len(), 1);
        let apart = ("solve/mod.rs", "mod descend;\nmod rules;\npub use descend::descend;\npub use rules::Rules;\n");
        assert!(found(&[apart, child, ("solve/rules.rs", "pub struct Rules;\n")]).is_empty());
    }

    #[test]
    fn tests_and_strings_do_not_count_and_other_folders_do() {
        let one = ("cable/law.rs", "pub struct Law;\nconst CODE: &str = \"crate::model::Model\";\n");
        let other = ("model/model.rs", "use crate::cable::law::Law;\npub struct Model;\n");
        let module = ("cable.rs", "pub mod law;\n#[cfg(test)]\nmod laws_judged;\n");
        let models = ("model.rs", "pub mod model;\n");
        let tests = ("cable/laws_judged.rs", "use super::law::Law;\nuse crate::model::model::Model;\nfn f() {}\n");
        assert!(found(&[one, other, module, models, tests]).is_empty());
        let back = ("cable/law.rs", "use crate::model::model::Model;\npub struct Law(Model);\n");
        assert_eq!(found(&[back, other, module, models, tests]).len(), 1);
    }

    #[test]
    fn a_listed_use_passes_until_its_circle_is_gone_and_a_new_circle_shows_its_uses() {
        let drum = ("drum.rs", "use super::layers::Layer;\npub struct Drum(Layer);\n");
        let layers = ("layers.rs", "use super::drum::Drum;\npub struct Layer;\nfn f(drum: &Drum) {}\n");
        let circle = graph_of(&[drum, layers]);
        let folder = "crates/cdpr-plant";
        let known = [Known { folder, from: "layers.rs", to: "drum.rs", reason: "rebuilt next" }];
        assert!(unknown(folder, &circle, &known).is_empty() && ended(folder, &circle, &known).is_empty());
        assert_eq!(
            unknown(folder, &circle, &[]),
            ["crates/cdpr-plant: 2 files use each other in a circle: drum.rs, layers.rs\n    \
              drum.rs:1 uses layers.rs (`super::layers::Layer`)\n    layers.rs:1 uses drum.rs (`super::drum::Drum`)"]
        );
        let mended = graph_of(&[drum, ("layers.rs", "pub struct Layer;\n")]);
        assert!(ended(folder, &mended, &known)[0].contains("closes no circle any more (rebuilt next)"));
        let straight = graph_of(&[("drum.rs", "pub struct Drum;\n"), layers]);
        assert_eq!(ended(folder, &straight, &known).len(), 1, "a use that leads nowhere back");
    }
}
