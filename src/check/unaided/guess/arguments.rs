//! The Lagrangian with its arguments, `\mathcal{L}(\theta, \dot\theta, t) = …`: the same name as without them.

/// The names of a Lagrangian in print.
const NAMES: [&str; 3] = ["\\mathcal{L}", "\\mathscr{L}", "L"];

/// The text of a display with blanks in the place of the arguments of a Lagrangian; `None` if it has none. A rate stands among the arguments, or
/// they would be a factor: L(a + b).
pub(crate) fn blanked(text: &str) -> Option<String> {
    let mut kept = text.to_owned();
    for name in NAMES {
        for (start, _) in text.match_indices(name) {
            let is_own = !text[..start].ends_with(|c: char| c.is_ascii_alphabetic() || "\\_^{".contains(c));
            if let Some((from, to)) = is_own.then(|| arguments(text, start + name.len())).flatten() {
                kept.replace_range(from..to, &" ".repeat(to - from));
            }
        }
    }
    (kept != text).then_some(kept)
}

/// The bytes of the parentheses directly after a place, if they contain arguments.
fn arguments(text: &str, after: usize) -> Option<(usize, usize)> {
    let spaces = [' ', '\n', '\t'];
    let rest = text[after..].trim_start_matches(spaces);
    let start = text.len() - rest.len();
    let inside = rest.strip_prefix("\\left").unwrap_or(rest).trim_start_matches(spaces).strip_prefix('(')?;
    let open = text.len() - inside.len();
    let mut depth = 1;
    let close = inside.find(|c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth == 0
    })?;
    let list = inside[..close].trim_end().trim_end_matches("\\right");
    let is_name = |part: &str| !part.trim().is_empty() && !part.contains(['+', '=', '^', '(', '/']);
    let is_list = list.contains("\\dot") && list.contains([',', ';']) && list.split([',', ';']).all(is_name);
    (is_list && list.is_ascii()).then_some((start, open + close + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arguments_are_blanked_and_factors_are_not() {
        for text in [
            r"\mathcal{L}(q, \dot q, t) = T - V",
            r"\mathcal L\left(\theta, \dot{\theta}\right) = T",
            r"L(x,\dot x) = T",
            r"\frac{\partial L(x, \dot x)}{\partial x} = 0",
        ] {
            let found = blanked(text).unwrap();
            assert_eq!(found.len(), text.len());
            assert!(!found.contains('('), "{found}");
        }
        for text in
            [r"L(a + b)", r"L(x)", r"x_L(x, \dot x)", r"m L(\dot x + \dot y) = 0", r"\mathcal{L} = f(q, \dot q)"]
        {
            assert_eq!(blanked(text), None, "{text}");
        }
    }
}
