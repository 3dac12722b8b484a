//! How wide the terminal is, and whether it has colours.

use std::io::IsTerminal;

use terminal_size::{Width, terminal_size_of};

use crate::report::Style;

use super::outcome::Screen;

/// The widest that a report is drawn on a terminal of its own accord, in columns: longer lines of text are hard to read.
const WIDEST: usize = 120;

/// How standard output and standard error are drawn.
///
/// The variable `COLUMNS`, where it is set, says how wide; else a terminal is as wide as it is, at most 120 columns, and a
/// file or a pipe 80. `NO_COLOR` turns off colours, which only terminals have.
pub(super) fn screen() -> Screen {
    let columns = std::env::var("COLUMNS").ok();
    let no_colour = std::env::var("NO_COLOR").is_ok_and(|value| !value.is_empty());
    let style = |is_terminal: bool, size: Option<(Width, terminal_size::Height)>| {
        let own = size.filter(|_| is_terminal).map(|(Width(columns), _)| usize::from(columns));
        Style::new(width(columns.as_deref(), own), is_terminal && !no_colour)
    };
    let (out, err) = (std::io::stdout(), std::io::stderr());
    Screen {
        out: style(out.is_terminal(), terminal_size_of(&out)),
        err: style(err.is_terminal(), terminal_size_of(&err)),
    }
}

/// The width that is asked for, or that of the terminal, or the usual one.
fn width(asked: Option<&str>, terminal: Option<usize>) -> usize {
    let asked = asked.and_then(|columns| columns.trim().parse::<usize>().ok()).filter(|columns| *columns > 0);
    asked.or(terminal.map(|columns| columns.min(WIDEST))).unwrap_or(Style::PLAIN.width)
}

#[cfg(test)]
mod tests {
    use super::width;

    #[test]
    fn a_width_that_is_asked_for_goes_before_that_of_the_terminal() {
        assert_eq!(width(Some("150"), Some(100)), 150);
        assert_eq!(width(None, Some(100)), 100);
        assert_eq!(width(None, Some(300)), 120);
        assert_eq!(width(None, None), 80);
        for nothing in ["", "0", "wide", "-3"] {
            assert_eq!(width(Some(nothing), None), 80, "{nothing}");
        }
    }
}
