//! "Did you mean …?": the nearest of the words that would have been right.

/// Longer words are not worth comparing, and the comparison is quadratic.
const LONGEST: usize = 60;

/// The candidate nearest to `word`, if it is near enough to be a slip of the pen.
///
/// ```
/// use onshell::notes::did_you_mean;
/// assert_eq!(did_you_mean("asume", ["assume", "where"]), Some("assume"));
/// assert_eq!(did_you_mean("colour", ["assume", "where"]), None);
/// ```
pub fn did_you_mean<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = word.chars().count();
    if length > LONGEST {
        return None;
    }
    let (distance, best) = candidates
        .into_iter()
        .filter(|candidate| candidate.chars().count() <= LONGEST)
        .map(|candidate| (distance(word, candidate), candidate))
        .min_by_key(|(distance, _)| *distance)?;
    (distance <= (length / 3).max(1)).then_some(best)
}

/// Edits from `a` to `b`: insert, delete, replace, swap two neighbours; case and word separators cost nothing.
pub(super) fn distance(a: &str, b: &str) -> usize {
    let fold = |s: &str| -> Vec<char> {
        s.chars().map(|c| if matches!(c, '_' | '-') { ' ' } else { c }).flat_map(char::to_lowercase).collect()
    };
    let (a, b) = (fold(a), fold(b));
    let mut before = vec![0; b.len() + 1];
    let mut above: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i; b.len() + 1];
        for j in 1..=b.len() {
            let replaced = above[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            row[j] = replaced.min(above[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                row[j] = row[j].min(before[j - 2] + 1);
            }
        }
        before = std::mem::replace(&mut above, row);
    }
    above[b.len()]
}
