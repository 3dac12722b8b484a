//! What a lecture consists of: headings, sentences, and lines with numbers.

/// The name of the notes of a lecture.
pub(super) const NOTES: &str = "lecture.md";

/// A line of a lecture: an equation with its number.
#[derive(Clone, Debug)]
pub struct Line {
    /// The number that is printed.
    pub number: String,
    /// The numbers of the lines that it is compared with; none for a line that is taken for granted.
    pub from: Vec<String>,
    /// The value of the right side at the sampled state; several for a line with several statements.
    pub values: Vec<f64>,
}

/// A passage of a lecture, in order.
#[derive(Clone, Debug)]
pub enum Passage {
    /// A heading.
    Heading(String),
    /// A sentence, with formulas between dollar signs.
    Sentence(String),
    /// A line.
    Line(Line),
}
