//! Robot files that nobody would build: few or many cables, degenerate geometry, numbers at the ends of what is accepted.

use super::random::Random;

/// A robot file as tables of lines, so that parts of it can be left out.
#[derive(Clone)]
pub(super) struct RobotFile {
    /// Each with its heading first; the first one is the head of the file.
    pub(super) tables: Vec<Vec<String>>,
}

/// Sizes of a robot that the commands need.
#[derive(Clone, Copy)]
pub(super) struct Size {
    /// Components of a pose.
    pub(super) dof: usize,
    pub(super) translations: usize,
    pub(super) cables: usize,
    /// Groups of keys that the cables have.
    pub(super) effects: Effects,
}

/// Groups of keys of a cable.
#[derive(Clone, Copy)]
pub(super) struct Effects {
    limits: bool,
    stretch: bool,
    pulley: bool,
    drum: bool,
    sag: bool,
    recorded: bool,
    hidden: bool,
}

impl Effects {
    fn random(random: &mut Random) -> Self {
        let [limits, stretch, pulley, drum] = [0.8, 0.6, 0.4, 0.2].map(|part| random.chance(part));
        let [sag, recorded, hidden] = [0.3, 0.3, 0.3].map(|part| random.chance(part));
        Self { limits, stretch, pulley, drum, sag, recorded, hidden }
    }

    /// A model that the file supports, mostly.
    pub(super) fn model(self, random: &mut Random) -> String {
        let known = [(self.pulley, "pulley"), (self.drum, "drum"), (self.stretch, "elastic"), (self.sag, "catenary")];
        let words: Vec<&str> = known
            .into_iter()
            .filter(|&(has, _)| random.chance(if has { 0.7 } else { 0.02 }))
            .map(|(_, word)| word)
            .collect();
        if words.is_empty() { "standard".to_owned() } else { words.join("+") }
    }
}

/// Numbers at the ends of what readers accept, and those that make quotients and roots degenerate.
const EXTREMES: [&str; 10] = ["0", "1e-300", "5e-324", "1e-30", "1e-9", "1e9", "1e15", "1e20", "1e30", "1"];

/// A number as text: mostly usual, now and then extreme.
pub(super) fn number(random: &mut Random, least: f64, most: f64, wild: f64) -> String {
    match random.chance(wild) {
        // a sign only where both signs make sense
        true if least < 0.0 && random.chance(0.5) => format!("-{}", random.pick(&EXTREMES)),
        true => random.pick(&EXTREMES).to_owned(),
        false => format!("{:.3}", random.between(least, most)),
    }
}

fn list(numbers: &[String]) -> String {
    format!("[{}]", numbers.join(", "))
}

impl RobotFile {
    pub(super) fn text(&self) -> String {
        self.tables.iter().map(|lines| lines.join("\n") + "\n").collect::<Vec<_>>().join("\n")
    }

    /// A robot and its size.
    pub(super) fn random(random: &mut Random) -> (Self, Size) {
        let (pattern, dof, translations) = random.pick(&[("2T", 2, 2), ("3T", 3, 3), ("1R2T", 3, 2), ("3R3T", 6, 3)]);
        let cables = match random.below(8) {
            0 => 1 + random.below(dof),
            1 => dof + 4 + random.below(12),
            _ => dof + random.below(4),
        };
        let size = Size { dof, translations, cables, effects: Effects::random(random) };
        // half of the robots are plain but for their geometry
        let wild = random.pick(&[0.0, 0.0, 0.01, 0.04]);
        let mut tables = vec![head(random, pattern, size, wild)];
        tables.extend(sections(random, size, wild));
        let style = Style { geometry: random.below(6), centre: random.between(-2.0, 2.0), wild };
        tables.extend((0..cables).map(|index| cable(random, index, size, &style)));
        (Self { tables }, size)
    }
}

fn head(random: &mut Random, pattern: &str, size: Size, wild: f64) -> Vec<String> {
    let mut lines = vec![
        "layout_version = 1".to_owned(),
        "name = \"random\"".to_owned(),
        format!("motion_pattern = \"{pattern}\""),
    ];
    if size.translations == 2 {
        lines.push(format!("axes = \"{}\"", random.pick(&["xy", "xz", "yz"])));
    }
    if random.chance(0.7) {
        let mut gravity = vec!["0.0".to_owned(); size.translations];
        gravity[size.translations - 1] = number(random, -9.9, -9.7, wild);
        lines.push(format!("gravity_m_s2 = {}", list(&gravity)));
    }
    lines
}

fn sections(random: &mut Random, size: Size, wild: f64) -> Vec<Vec<String>> {
    let vector = |random: &mut Random, least, most| {
        let numbers: Vec<String> = (0..size.translations).map(|_| number(random, least, most, wild)).collect();
        list(&numbers)
    };
    let mut tables = Vec::new();
    let mut platform = vec!["[platform]".to_owned()];
    if random.chance(0.8) {
        platform.push(format!("mass_kg = {}", number(random, 1.0, 300.0, wild)));
        platform.push(format!("center_of_mass_m = {}", vector(random, -0.2, 0.2)));
    }
    tables.push(platform);
    if random.chance(0.8) {
        let mut home = vec!["[home_pose]".to_owned(), format!("position_m = {}", vector(random, -1.0, 1.0))];
        if size.dof == 3 && size.translations == 2 {
            home.push(format!("angle_rad = {}", number(random, -1.0, 1.0, wild)));
        }
        if size.dof == 6 {
            home.push("rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]".to_owned());
        }
        tables.push(home);
    }
    if random.chance(0.3) {
        let lines = vec!["[external_wrench]".to_owned(), format!("force_N = {}", vector(random, -500.0, 500.0))];
        tables.push(lines);
    }
    if random.chance(0.4) {
        let corners = [vector(random, -3.0, -1.0), vector(random, 1.0, 3.0)];
        tables.push(vec![
            "[workspace]".to_owned(),
            format!("position_min_m = {}", corners[0]),
            format!("position_max_m = {}", corners[1]),
        ]);
    }
    tables
}

/// Common traits of the cables of one robot.
struct Style {
    /// Places of the anchors: around, in one plane, on a line, in one of two points, symmetric, or anywhere.
    geometry: usize,
    centre: f64,
    /// Part of the numbers that are extreme.
    wild: f64,
}

impl Style {
    fn frame_anchor(&self, random: &mut Random, index: usize, size: Size) -> Vec<String> {
        let corner = |axis: usize| if (index >> axis).is_multiple_of(2) { -4.0 } else { 4.0 };
        (0..size.translations)
            .map(|axis| match self.geometry {
                0 => format!("{:.3}", corner(axis) + random.between(-0.5, 0.5)),
                1 if axis + 1 == size.translations => format!("{:.3}", 3.0 + self.centre),
                2 if axis > 0 => "2.5".to_owned(),
                3 if axis == 0 => format!("{:.3}", self.centre + (index % 2) as f64),
                3 => format!("{:.3}", self.centre),
                4 => format!("{:.1}", corner(axis)),
                _ => number(random, -6.0, 6.0, self.wild),
            })
            .collect()
    }
}

fn cable(random: &mut Random, index: usize, size: Size, style: &Style) -> Vec<String> {
    let mut lines = vec!["[[cable]]".to_owned(), format!("name = \"{}\"", index + 1)];
    lines.push(format!("frame_anchor_m = {}", list(&style.frame_anchor(random, index, size))));
    let wild = style.wild;
    let is_point = size.dof == size.translations || random.chance(0.05);
    let platform: Vec<String> = (0..size.translations)
        .map(|_| if is_point { "0.0".to_owned() } else { number(random, -0.5, 0.5, wild) })
        .collect();
    lines.push(format!("platform_anchor_m = {}", list(&platform)));
    let mut add = |key: &str, least: f64, most: f64, random: &mut Random| {
        lines.push(format!("{key} = {}", number(random, least, most, wild)));
    };
    let Effects { limits, stretch, pulley, drum, sag, recorded, hidden } = size.effects;
    if limits {
        add("tension_min_N", 0.0, 200.0, random);
        add("tension_max_N", 300.0, 9000.0, random);
    }
    if stretch {
        add("axial_stiffness_EA_N", 1e4, 1e6, random);
    }
    if hidden {
        add("hidden_length_m", 0.0, 5.0, random);
    }
    if sag {
        add("linear_density_kg_per_m", 0.01, 0.5, random);
    }
    if recorded {
        add("length_scale", 0.99, 1.01, random);
        add("length_offset_m", -0.1, 0.1, random);
    }
    if pulley {
        add("pulley_radius_m", 0.01, 0.2, random);
    }
    if drum {
        add("drum_radius_m", 0.05, 0.2, random);
        add("drum_pitch_m", 0.001, 0.02, random);
        add("drum_start_length_m", 1.0, 9.0, random);
        lines.push("drum_guided = true".to_owned());
    }
    if pulley && size.translations == 3 {
        lines.push("pulley_swivel_axis = [0.0, 0.0, 1.0]".to_owned());
    }
    lines
}
