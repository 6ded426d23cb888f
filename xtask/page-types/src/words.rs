//! Names and descriptions of Python from those of a schema.

/// Units that keys end with, and how descriptions write them; a unit stands before all that are its end.
const UNITS: &[(&str, &str)] = &[
    ("m_per_unit", "m per unit"),
    ("rad_per_unit", "rad per unit"),
    ("N_per_unit", "N per unit"),
    ("m2_per_unit", "m² per unit"),
    ("m3_per_unit", "m³ per unit"),
    ("N_per_m", "N/m"),
    ("m_per_s", "m/s"),
    ("per_s", "1/s"),
    ("per_m", "1/m"),
    ("per_N", "1/N"),
    ("rad_s2", "rad/s²"),
    ("rad_s", "rad/s"),
    ("m_s2", "m/s²"),
    ("m_s", "m/s"),
    ("N_Nm", "N, N·m"),
    ("Nm", "N·m"),
    ("m2", "m²"),
    ("m3", "m³"),
    ("Hz", "Hz"),
    ("kg", "kg"),
    ("ns", "ns"),
    ("us", "µs"),
    ("rad", "rad"),
    ("J", "J"),
    ("N", "N"),
    ("m", "m"),
    ("s", "s"),
];

/// Words of Python that no attribute can have.
const KEYWORDS: &[&str] = &[
    "and", "as", "assert", "async", "await", "break", "class", "continue", "def", "del", "elif", "else", "except",
    "finally", "for", "from", "global", "if", "import", "in", "is", "lambda", "nonlocal", "not", "or", "pass", "raise",
    "return", "try", "while", "with", "yield",
];

/// A key without its unit, and the unit in words.
fn parted(key: &str) -> (&str, Option<&'static str>) {
    let found = UNITS.iter().find_map(|(ending, unit)| {
        let name = key.strip_suffix(ending)?.strip_suffix('_')?;
        Some((name, *unit))
    });
    found.map_or((key, None), |(name, unit)| (name, Some(unit)))
}

/// Attribute of a key.
pub(crate) struct Attribute {
    pub(crate) name: String,
    /// The unit that the name does not tell.
    pub(crate) unit: Option<&'static str>,
}

/// Attributes of the keys of a class: without units, unless two of them would have the same name.
pub(crate) fn attributes(keys: &[&str]) -> Vec<Attribute> {
    let short: Vec<_> = keys.iter().map(|key| parted(key)).collect();
    let attribute = |(key, (name, unit)): (&&str, &(&str, Option<&'static str>))| {
        let is_free = short.iter().filter(|(other, _)| other == name).count() == 1;
        let (name, unit) = if is_free { (*name, *unit) } else { (*key, None) };
        let end = if KEYWORDS.contains(&name) { "_" } else { "" };
        Attribute { name: format!("{name}{end}"), unit }
    };
    keys.iter().zip(&short).map(attribute).collect()
}

/// A description for readers of Python, with the unit if it does not say it.
pub(crate) fn described(text: &str, unit: Option<&str>) -> String {
    let text = without_markup(text);
    match unit.filter(|unit| !says(&text, unit)) {
        None => text,
        Some(unit) => format!("{} ({unit}).", text.trim_end_matches('.')),
    }
}

/// Whether parentheses in a text say the unit.
fn says(text: &str, unit: &str) -> bool {
    let groups = text.split('(').skip(1).filter_map(|rest| rest.split(')').next());
    groups.into_iter().any(|group| group == unit || group.split([';', ',']).any(|part| part.trim() == unit))
}

/// One line without escapes of Markdown; what is null in JSON is `None`.
fn without_markup(text: &str) -> String {
    let plain = text.replace("\\[", "[").replace("\\]", "]").replace('\\', "\\\\");
    let word = |word: &str| {
        let bare = word.trim_end_matches([',', '.', ';', ':']);
        match bare {
            "null" | "Null" => word.replacen(bare, "`None`", 1),
            _ => word.to_owned(),
        }
    };
    plain.split_whitespace().map(word).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(keys: &[&str]) -> Vec<String> {
        attributes(keys).into_iter().map(|attribute| attribute.name).collect()
    }

    #[test]
    fn units_are_left_out_unless_names_would_be_the_same() {
        let keys = ["position_error_m", "volume_m3", "tensions_N", "axial_stiffness_EA_N", "time_s", "rate_m_per_s"];
        let expected = ["position_error", "volume", "tensions", "axial_stiffness_EA", "time", "rate"];
        assert_eq!(names(&keys), expected);
        assert_eq!(names(&["position_m", "position_rad"]), ["position_m", "position_rad"]);
        assert_eq!(names(&["payload", "payload_kg", "with", "max"]), ["payload", "payload_kg", "with_", "max"]);
    }

    #[test]
    fn a_description_says_its_unit_once_and_none_for_null() {
        assert_eq!(described("Length.", Some("m")), "Length (m).");
        assert_eq!(described("Length (m); null without one.", Some("m")), "Length (m); `None` without one.");
        assert_eq!(described("Wrench \\[a\\] (N, N·m).", Some("N, N·m")), "Wrench [a] (N, N·m).");
    }
}
