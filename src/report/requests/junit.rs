//! JUnit XML, as GitLab and Jenkins read it: a suite for each document, a case for each equation.

use std::fmt::Write;

use crate::Error;
use crate::check::Report;

use super::problem;

/// The test suites.
pub fn report(report: &Report, errors: &[Error]) -> String {
    let (tests, failures) = (report.items().count(), report.unexpected());
    let total = tests + errors.len();
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites tests=\"{total}\" failures=\"{failures}\" errors=\"{}\">\n",
        errors.len()
    );
    let mut put = |line: String| {
        // Writing to a string does not fail.
        let _ = writeln!(text, "{line}");
    };
    for document in &report.documents {
        let items = || document.equations.iter().chain(&document.sentences);
        let failed = items().filter(|item| !item.ok).count();
        let path = escaped(&document.path);
        put(format!("  <testsuite name=\"{path}\" tests=\"{}\" failures=\"{failed}\" errors=\"0\">", items().count()));
        for item in items() {
            let problem = problem::problem(document, item);
            let place = problem.place.map(|place| (escaped(&place.file.path), place.line_column().0));
            let (file, line) = place.unwrap_or((path.clone(), item.line));
            let case = format!(
                "    <testcase classname=\"{path}\" name=\"({})\" file=\"{file}\" line=\"{line}\"",
                escaped(&item.id)
            );
            if item.ok {
                put(format!("{case}/>"));
                continue;
            }
            let message = escaped(&problem.message);
            put(format!(
                "{case}>\n      <failure type=\"{}\" message=\"{message}\">{file}:{line}: {message}</failure>\n    </testcase>",
                problem.code
            ));
        }
        put("  </testsuite>".to_owned());
    }
    if !errors.is_empty() {
        put(format!("  <testsuite name=\"onshell\" tests=\"{0}\" failures=\"0\" errors=\"{0}\">", errors.len()));
        for error in errors {
            let (message, whole) = (escaped(error.message()), escaped(&error.to_string()));
            put(format!(
                "    <testcase classname=\"onshell\" name=\"{message}\">\n      <error type=\"{}\" message=\"{message}\">{whole}</error>\n    </testcase>",
                error.code()
            ));
        }
        put("  </testsuite>".to_owned());
    }
    text + "</testsuites>\n"
}

/// Text in XML: what is markup is a reference, and a character that XML does not allow is a question mark.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\n' => escaped.push_str("&#10;"),
            '\t' => escaped.push(' '),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => escaped.push('?'),
            c => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::escaped;

    #[test]
    fn what_is_markup_in_xml_is_a_reference() {
        assert_eq!(escaped("a < b & \"c\"\u{1b}\n"), "a &lt; b &amp; &quot;c&quot;?&#10;");
    }
}
