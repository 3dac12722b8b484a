//! "Did you mean": the known word nearest to an unknown one.

/// The candidate fewest edits away from `word`, if it is near enough to be what was meant.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = word.chars().count();
    candidates
        .into_iter()
        .map(|candidate| (strsim::osa_distance(word, candidate), candidate))
        .min_by_key(|(steps, _)| *steps)
        .filter(|(steps, candidate)| *steps < length && *steps <= 2.max(length.max(candidate.len()) / 3))
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn a_swap_of_letters_is_one_step() {
        assert_eq!(nearest("\\Omgea", ["\\Omega", "\\omega_3"]), Some("\\Omega"));
    }

    #[test]
    fn nothing_is_suggested_for_a_word_unlike_all() {
        assert_eq!(nearest("x", ["\\Omega", "y"]), None);
    }
}
