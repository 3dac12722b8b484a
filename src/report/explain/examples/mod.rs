//! An example of each verdict, of each outcome of a mutant and of each code: files, and the command that reports it.
//!
//! The files are printed in full, so that a reader can copy and change them. A test in `tests/cli/explain.rs` copies them
//! from the output and runs the command.
//!
//! Offers `of`, the example of a word. Knows nothing but texts.

mod example;
mod failing;
mod files;
mod passing;
mod reading;
mod undecided;
mod verdicts;

pub(super) use example::Example;

use crate::report::style::Style;
use crate::report::wrap;

impl Example {
    /// All examples.
    pub fn all() -> impl Iterator<Item = &'static Example> {
        use {
            failing::FAILING, files::FILES, passing::PASSING, reading::READING, undecided::UNDECIDED,
            verdicts::VERDICTS,
        };
        [VERDICTS, READING, FILES, FAILING, UNDECIDED, PASSING].into_iter().flatten()
    }

    /// The example of a word.
    pub fn of(word: &str) -> Option<&'static Example> {
        Example::all().find(|example| example.word == word)
    }

    /// The example as it is printed: what is run, and the files, each with an indent of four.
    pub fn text(&self, style: Style) -> String {
        let Example { word, command, files } = self;
        let place = if files.is_empty() { "without such a file" } else { "with these files" };
        let lead = format!("Example: {word} is reported by `{command}` {place}");
        let mut text = format!("\n{}{}\n", wrap("", &lead, 0, style.width), if files.is_empty() { "." } else { ":" });
        for (name, content) in *files {
            text.push_str(&format!("\n{name}\n\n"));
            for line in content.lines() {
                text.push_str(format!("    {line}").trim_end());
                text.push('\n');
            }
        }
        text
    }
}
