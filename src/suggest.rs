//! What to type instead: the known word nearest to an unknown one, and lines for a claims file.

/// The most characters of a word that is compared; the comparison is quadratic.
const LONGEST: usize = 60;

/// The fewest characters of a word that is compared.
const SHORTEST: usize = 3;

/// The candidate nearest to `word`, if it is near enough to be a spelling mistake.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = word.chars().count();
    // Almost any two short words are near each other, and so are any two numbers.
    let is_number = word.chars().all(|c| c.is_ascii_digit() || "().,".contains(c));
    if !(SHORTEST..=LONGEST).contains(&length) || is_number {
        return None;
    }
    candidates
        .into_iter()
        .map(|candidate| (distance(word, candidate), candidate))
        // A letter of the other case is nearer than another letter.
        .min_by_key(|(steps, candidate)| (*steps, distance(&word.to_lowercase(), &candidate.to_lowercase())))
        .filter(|(steps, _)| *steps < length && *steps <= (length / 3).max(2))
        .map(|(_, candidate)| candidate)
}

/// The number of edits from one word to the other: insert, delete, replace, or swap two neighbours.
///
/// A hyphen, an underscore and a space count as the same character. For words of more than 60 characters the result
/// is [`usize::MAX`].
pub fn distance(a: &str, b: &str) -> usize {
    if a.chars().count() > LONGEST || b.chars().count() > LONGEST {
        return usize::MAX;
    }
    strsim::osa_distance(&a.replace(['_', '-'], " "), &b.replace(['_', '-'], " "))
}

/// A text as it stands in a claims file: in quotes, with its backslashes doubled.
pub fn in_json(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// The advice to declare a name, as LaTeX, with the line to write; `dots` is how many overdots it has in the notes.
pub fn declaration(name: &str, dots: u8) -> String {
    let is_vector = ["\\vec", "\\mathbf", "\\boldsymbol", "\\bm"].iter().any(|arrow| name.contains(arrow));
    let role = if dots > 0 || is_vector { "varies with time" } else { "constants" };
    let add = format!("add {}: \"any\" under \"{role}\" in the claims file", in_json(name));
    match name {
        _ if name.contains("\\hat") => format!(
            "if {name} is the direction of a vector, add {}: \"any\" under \"constants\" in the claims file; \
             operators of quantum mechanics are not supported",
            in_json(&name.replacen("\\hat", "\\vec", 1))
        ),
        "i" | "\\mathrm{i}" => format!(
            "if {name} is √−1, add {}: \"imaginary unit\" under \"constants\" in the claims file; if it is a real \
             number, {add}",
            in_json(name)
        ),
        _ if OPERATORS.iter().any(|word| name == format!("\\mathrm{{{word}}}")) => format!(
            "the operator {name} is not supported; leave the equation out with \"skip\" in the claims file, or, if \
             {name} is a quantity, {add}"
        ),
        _ if name.starts_with("\\delta") && name.contains("\\int") => {
            "the variation δ of an integral is not supported; leave the equation out with \"skip\" in a claims file"
                .to_owned()
        }
        _ => add,
    }
}

/// Operators with a name of several letters.
const OPERATORS: [&str; 4] = ["div", "grad", "rot", "curl"];

/// The advice where a name is that of no system: those there are, and how to add one.
#[cfg(feature = "notes")]
pub fn systems<'a>(names: impl Iterator<Item = &'a str>) -> String {
    format!(
        "the systems are {}; for another one, write its Lagrangian, L = …, in the notes, and \"means\": {{ \"L\": \
         \"Lagrangian\" }} in place of \"system\"",
        names.collect::<Vec<_>>().join(", ")
    )
}

/// The advice to declare a name before a parenthesis with names: as a function of them, or as a factor.
#[cfg(feature = "notes")]
pub fn function(name: &str, arguments: &[String]) -> String {
    let arguments = arguments.join(", ");
    format!(
        "if {name} is a function of {arguments}, add {}: {} under \"functions\" in the claims file; if it is a factor, \
         remove the parentheses and declare it under \"constants\"",
        in_json(name),
        in_json(&format!("of {arguments}"))
    )
}

#[cfg(test)]
mod tests {
    use super::{declaration, function, in_json, nearest};

    #[test]
    fn a_declaration_is_a_line_of_json() {
        assert_eq!(in_json("\\theta"), "\"\\\\theta\"");
        assert_eq!(declaration("\\omega_0", 0), r#"add "\\omega_0": "any" under "constants" in the claims file"#);
        assert!(declaration("x", 1).contains("\"varies with time\""));
        assert!(declaration("\\vec r", 0).contains("\"varies with time\""));
        assert!(declaration("i", 0).contains("imaginary unit"));
        assert!(!declaration("i_1", 0).contains("complex"));
        // What has a hat cannot be declared as a number.
        assert!(declaration("\\hat{n}", 0).contains(r#"add "\\vec{n}": "any" under "constants""#));
        assert!(function("f", &["x".to_owned()]).contains(r#"add "f": "of x" under "functions""#));
    }

    #[test]
    fn nothing_is_suggested_for_a_number_or_a_word_of_two_letters() {
        assert_eq!(nearest("9", ["1", "19"]), None);
        assert_eq!(nearest("6.74", ["6.73"]), None);
        assert_eq!(nearest("xy", ["xz", "x"]), None);
        // A swap of letters in a longer word is still one.
        assert_eq!(nearest("xzy", ["xyz"]), Some("xyz"));
    }

    #[test]
    fn a_spelling_mistake_is_near_and_another_word_is_not() {
        assert_eq!(nearest("asume", ["assume", "where"]), Some("assume"));
        assert_eq!(nearest("colour", ["assume", "where"]), None);
    }

    #[test]
    fn a_swap_of_letters_is_one_step() {
        assert_eq!(nearest("\\Omgea", ["\\Omega", "\\omega_3"]), Some("\\Omega"));
        assert_eq!(nearest("\\omega_z", ["\\omega_0", "\\Omega_z"]), Some("\\Omega_z"));
    }

    #[test]
    fn nothing_is_suggested_for_a_word_unlike_all() {
        assert_eq!(nearest("x", ["\\Omega", "y"]), None);
    }
}
