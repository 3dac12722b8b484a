//! "Did you mean": the known word nearest to an unknown one.

/// The most characters of a word that is compared; the comparison is quadratic.
const LONGEST: usize = 60;

/// The candidate nearest to `word`, if it is near enough to be a spelling mistake.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = word.chars().count();
    if length > LONGEST {
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

#[cfg(test)]
mod tests {
    use super::nearest;

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
