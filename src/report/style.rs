//! How text is drawn: its width in columns, and whether it has colours.

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

/// The width where no terminal says another, in columns.
const USUAL_WIDTH: usize = 80;

/// The narrowest that text is wrapped to, in columns: below this a report cannot be read.
const NARROWEST: usize = 40;

/// How text is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Style {
    /// No line is wider than so many columns, but for a path or a name that has no place to break.
    pub width: usize,
    /// Whether the text has colours, as ANSI escape sequences.
    pub colour: bool,
}

impl Style {
    /// 80 columns without colours, as in a file.
    pub const PLAIN: Style = Style { width: USUAL_WIDTH, colour: false };

    /// A style of so many columns, at least 40.
    pub fn new(width: usize, colour: bool) -> Style {
        Style { width: width.max(NARROWEST), colour }
    }

    /// A style of so many columns fewer, for text that stands inside of other text.
    pub(super) fn inside(self, columns: usize) -> Style {
        Style::new(self.width.saturating_sub(columns), self.colour)
    }

    /// A text in a colour.
    pub(super) fn paint(self, text: &str, colour: Colour) -> String {
        let code = match colour {
            Colour::Red => 31,
            Colour::Green => 32,
            Colour::Yellow => 33,
        };
        if self.colour { format!("\u{1b}[{code}m{text}\u{1b}[0m") } else { text.to_owned() }
    }
}

/// A colour of a word in a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Colour {
    /// Something is wrong.
    Red,
    /// Something passes.
    Green,
    /// Something does not pass, as expected.
    Yellow,
}

/// How many columns a text takes. Combining marks and the escape sequences of colours take none.
pub(super) fn columns(text: &str) -> usize {
    let mut columns = 0;
    let mut rest = text;
    while let Some(escape) = rest.find("\u{1b}[") {
        columns += rest[..escape].width();
        let after = &rest[escape..];
        rest = after.find('m').map_or("", |end| &after[end + 1..]);
    }
    columns + rest.width()
}

/// How many columns a character takes in a line of source; a tab is shown as four spaces.
pub(super) fn columns_of(c: char) -> usize {
    match c {
        '\t' => 4,
        '\r' => 0,
        c => c.width().unwrap_or(1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_and_colours_take_no_column() {
        assert_eq!(columns("θ\u{307} = 1"), 5);
        assert_eq!(columns(&Style::new(80, true).paint("refuted", Colour::Red)), 7);
        assert_eq!(columns("力学"), 4);
    }

    #[test]
    fn a_width_that_cannot_be_read_is_not_used() {
        assert_eq!(Style::new(3, false).width, NARROWEST);
        assert_eq!(Style::new(120, false).width, 120);
        assert_eq!(Style::PLAIN.inside(10).width, 70);
    }
}
