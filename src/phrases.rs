//! Phrases in a row, as a sentence lists them.

/// Phrases with commas between them, and a word before the last: "x, y and z".
pub(crate) fn listed<P: AsRef<str>>(phrases: &[P], last: &str) -> String {
    let phrases: Vec<&str> = phrases.iter().map(AsRef::as_ref).collect();
    match phrases.as_slice() {
        [others @ .., end] if !others.is_empty() => format!("{} {last} {end}", others.join(", ")),
        phrases => phrases.concat(),
    }
}

/// Displays by their numbers: "(1), (2) and (3)".
pub(crate) fn displays<I: AsRef<str>>(ids: &[I], last: &str) -> String {
    let ids: Vec<String> = ids.iter().map(|id| format!("({})", id.as_ref())).collect();
    listed(&ids, last)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_phrase_has_a_word_before_it() {
        assert_eq!(displays(&["1", "2", "3"], "and"), "(1), (2) and (3)");
        assert_eq!(displays(&["1", "2"], "or"), "(1) or (2)");
        assert_eq!((displays(&["1"], "and"), listed::<&str>(&[], "and")), ("(1)".to_owned(), String::new()));
    }
}
