//! Units in upright text, and those in parentheses below a slash, `\text{W/(m K)}`.

/// Commands for upright text.
const UPRIGHT: [&str; 4] = ["\\text{", "\\mathrm{", "\\textrm{", "\\mbox{"];

/// Whether a place is inside upright text, where a unit stands.
pub(super) fn is_upright(text: &str, at: usize) -> bool {
    let before = &text[..at];
    let last = UPRIGHT.iter().filter_map(|command| before.rfind(command).map(|start| start + command.len())).max();
    last.is_some_and(|start| !before[start..].contains('}'))
}

/// A text of the same length in which each unit below a slash has a slash of its own: `\text{W/(m K)}` is `\text{W/ m/K }`.
pub(in crate::check::mark) fn with_single_units(text: &str) -> String {
    let mut new = text.to_owned();
    for (start, _) in text.match_indices("/(") {
        let open = start + 1;
        let Some(length) = text[open..].find(')') else { continue };
        let inside = &text[open + 1..open + length];
        let is_unit = |c: char| c.is_ascii_alphabetic() || c == ' ' || c == '~';
        let signs = ["\\,", "\\cdot", "$", "\\;"];
        let plain = signs.iter().fold(inside.to_owned(), |text, sign| text.replace(sign, " "));
        if !is_upright(text, start) || !plain.chars().all(is_unit) {
            continue;
        }
        let units: Vec<&str> = plain.split([' ', '~']).filter(|unit| !unit.is_empty()).collect();
        let divided = units.join("/");
        if !units.is_empty() && divided.len() <= inside.len() {
            new.replace_range(open..=open + length, &format!(" {divided:<width$} ", width = inside.len()));
        }
    }
    new
}

#[cfg(test)]
mod tests {
    use super::with_single_units;

    #[test]
    fn units_in_parentheses_below_a_slash_are_divided_one_by_one() {
        assert_eq!(with_single_units(r"0.5\,\text{W/(m K)}"), r"0.5\,\text{W/ m/K }");
        assert_eq!(with_single_units(r"\mathrm{J/(kg\,K)}"), r"\mathrm{J/ kg/K  }");
        // The twins: a product of letters, no parenthesis, and words.
        for text in [r"g/(l m)", r"\text{W/m}", r"\text{see (a b)}"] {
            assert_eq!(with_single_units(text), text);
        }
    }
}
