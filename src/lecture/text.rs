//! A lecture on a terminal: sentences, and each line with its certificate and its value at the sampled state.

use super::{Lecture, Line, Passage};
use crate::check::{Equation, Verdict};
use crate::formula::text::{number, plain};
use crate::report::wrap;

/// The lecture, no wider than `width`.
pub fn text(lecture: &Lecture, width: usize) -> String {
    let mut out = String::new();
    for passage in &lecture.passages {
        match passage {
            Passage::Heading(title) => {
                let title = spelled(title);
                let rule = "-".repeat(title.chars().count());
                out.push_str(&format!("\n{title}\n{rule}\n\n"));
            }
            Passage::Sentence(sentence) => out.push_str(&format!("{}\n\n", wrap("", &spelled(sentence), 0, width))),
            Passage::Line(line) => {
                if let Some(equation) = lecture.equation(line) {
                    out.push_str(&shown(line, equation, width));
                }
            }
        }
    }
    out.push_str(&format!("\n{}\n", wrap("", &format!("The sampled state: {}", drawn(lecture)), 2, width)));
    let granted = lecture.document.equations.iter().filter(|item| item.finding.verdict == Verdict::Definition).count();
    let certified = lecture.document.equations.iter().filter(|item| item.finding.verdict == Verdict::Certified).count();
    let all = lecture.document.equations.len();
    out.push_str(&format!("{all} lines: {granted} taken for granted, {certified} certified"));
    let rest = all - granted - certified;
    out.push_str(&if rest > 0 { format!(", {rest} with another verdict\n") } else { "\n".to_owned() });
    out.trim_start().to_owned()
}

/// The sampled state: `θ = 0.440, m = 1.36`.
pub fn drawn(lecture: &Lecture) -> String {
    let each = |(name, value): &(String, f64)| format!("{name} = {}", number(*value, 3));
    lecture.sample.drawn.iter().map(each).collect::<Vec<_>>().join(", ")
}

fn shown(line: &Line, equation: &Equation, width: usize) -> String {
    let label = format!("({}) ", line.number);
    let indent = " ".repeat(label.len());
    let reading = match equation.parts.len() {
        0 => equation.reading.clone(),
        _ => {
            let mut parts: Vec<&str> = Vec::new();
            for part in &equation.parts {
                // that E = … is constant has a part of its own
                if !parts.iter().any(|known| known.ends_with(part.reading.as_str())) {
                    parts.push(&part.reading);
                }
            }
            parts.join(",  ")
        }
    };
    let mut out = format!("{}\n", wrap(&label, &reading, label.len() + 2, width));
    out.push_str(&format!("{}\n\n", wrap(&indent, &evidence(line, equation), indent.len() + 2, width)));
    out
}

/// What a line rests on, its bound, and its value: `certified from (3), false with probability below 2^-170 · value 1.2`.
pub fn evidence(line: &Line, equation: &Equation) -> String {
    let finding = &equation.finding;
    let mut parts = Vec::new();
    if finding.verdict == Verdict::Definition {
        parts.push("taken for granted".to_owned());
    } else {
        let from: Vec<String> = line.from.iter().map(|number| format!("({number})")).collect();
        parts.push(format!("{} from {}", finding.verdict, from.join(", ")));
        match (finding.false_accept_log2, &finding.not_certified_because) {
            (Some(power), _) => parts.push(format!("false with probability below 2^{:.0}", power.ceil())),
            (None, Some(reason)) => parts.push(format!("not certified: exact arithmetic does not decide {reason}")),
            (None, None) if !equation.ok => parts.push(finding.message.clone()),
            (None, None) => {}
        }
    }
    if !line.values.is_empty() {
        let values: Vec<String> = line.values.iter().map(|value| number(*value, 6)).collect();
        parts.push(format!("value {}", values.join(", ")));
    }
    parts.join(" · ")
}

/// A sentence with its formulas in plain text.
fn spelled(sentence: &str) -> String {
    let part = |(at, part): (usize, &str)| if at % 2 == 1 { formula(part) } else { part.to_owned() };
    sentence.split('$').enumerate().map(part).collect()
}

/// A short formula in plain text.
fn formula(latex: &str) -> String {
    match crate::Formula::read(latex) {
        Ok(formula) => formula.to_string(),
        Err(_) => plain(latex),
    }
}
