//! Workflow commands of GitHub Actions: a line for each problem, which the site shows beside the lines of a pull request.

use crate::Error;
use crate::check::Report;

use super::problem;

/// The commands.
pub fn report(report: &Report, errors: &[Error]) -> String {
    let mut text = String::new();
    for problem in problem::all(report, errors) {
        let place = problem.place.map(|place| {
            let ((line, column), (end_line, end_column)) = (place.line_column(), place.end_line_column());
            // Columns are shown only if both ends are on one line.
            let end = if line == end_line { format!(",endColumn={end_column}") } else { String::new() };
            format!("file={},line={line},endLine={end_line},col={column}{end},", property(&place.file.path))
        });
        let help = problem.help.map(|help| format!("\n{help}")).unwrap_or_default();
        let message = format!("{}{help}", problem.message);
        text += &format!(
            "::error {}title={}::{}\n",
            place.unwrap_or_default(),
            property(problem.code.word()),
            data(&message)
        );
    }
    text
}

/// A message, in which a line end would end the command.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// The value of a property, in which commas and colons have a meaning too.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_a_meaning_in_a_command_is_escaped() {
        assert_eq!(data("50 %: a,\r\nb"), "50 %25: a,%0D%0Ab");
        assert_eq!(property("a,b: %"), "a%2Cb%3A %25");
    }
}
