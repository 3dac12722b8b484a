//! The report for a terminal: a line an equation, and a diagnostic for each that is not as expected.

use crate::check::kinds::definitions::SIGN_ASIDE;
use crate::check::{Document, Equation, Finding, Part, Report, Verdict};

use super::diagnostic;

/// The whole report; `verbose` adds how each statement was read and what was inferred.
pub fn report(report: &Report, verbose: bool, colour: bool) -> String {
    let mut text = String::new();
    for document in &report.documents {
        text.push_str(&self::document(document, verbose, colour));
        text.push('\n');
    }
    for document in &report.documents {
        let own = |item: &&Equation| !item.ok && item.finding.follows_from.is_none();
        for item in document.equations.iter().chain(&document.sentences).filter(own) {
            text.push_str(&unexpected(document, item, colour));
            text.push_str("\n\n");
        }
    }
    text.push_str(&summary(report));
    text.push('\n');
    text
}

fn document(document: &Document, verbose: bool, colour: bool) -> String {
    let mut text = match &document.claims {
        Some(claims) => format!("{}  (claims: {claims})\n", document.path),
        None => format!("{}  (no claims)\n", document.path),
    };
    if verbose {
        document.inferred.iter().for_each(|line| text.push_str(&format!("    {line}\n")));
    }
    let longest = document.equations.iter().chain(&document.sentences).map(|item| item.id.chars().count()).max();
    let width = longest.unwrap_or(0).min(32);
    for item in &document.equations {
        text.push_str(&line(item, width, colour));
        if verbose {
            text.push_str(&details(item, width));
        }
    }
    match document.unnumbered {
        0 => {}
        1 => text.push_str("  1 display without a number was not checked\n"),
        n => text.push_str(&format!("  {n} displays without a number were not checked\n")),
    }
    if !document.sentences.is_empty() {
        text.push_str("  sentences\n");
        for item in &document.sentences {
            text.push_str(&line(item, width, colour));
            if verbose {
                text.push_str(&details(item, width));
            }
        }
    }
    text
}

fn line(item: &Equation, width: usize, colour: bool) -> String {
    let finding = &item.finding;
    let mark = if item.ok { "✓" } else { "✗" };
    let verdict = paint(&format!("{:<10}", finding.verdict.word()), finding.verdict, item.ok, colour);
    let mut text = format!("  {mark} {:<width$}  {verdict}  ", item.id);
    match (&item.because, item.ok) {
        (Some(because), true) => text.push_str(&format!("as expected: {because}")),
        _ => text.push_str(&summary_of(finding)),
    }
    if item.parts.len() > 1 {
        text.push_str(&format!(" ({} parts)", item.parts.len()));
        // What one part leaves open is not swallowed by the others.
        let leaves_open = |part: &Part| part.finding.message.contains(SIGN_ASIDE);
        if item.ok && !finding.message.contains(SIGN_ASIDE) && item.parts.iter().any(leaves_open) {
            text.push_str(" · nothing checks the sign of a definition in it");
        }
    }
    text.push('\n');
    text
}

fn summary_of(finding: &Finding) -> String {
    let mut text = finding.message.clone();
    if finding.verdict.passes() && finding.points > 0 {
        text.push_str(&format!(" · {} states", finding.points));
        if let Some(residual) = finding.max_residual {
            text.push_str(&format!(" · residual {residual:.0e}"));
        }
        if let Some(power) = finding.false_accept_log2 {
            text.push_str(&format!(" · false with probability below 2^{:.0}", power.ceil()));
        }
    }
    text
}

fn details(item: &Equation, width: usize) -> String {
    let indent = " ".repeat(width + 6);
    let mut text = String::new();
    if item.parts.is_empty() {
        text.push_str(&format!("{indent}{}\n", item.reading));
        if let Some(reason) = &item.finding.not_certified_because {
            text.push_str(&format!("{indent}not certified because of {reason}\n"));
        }
    }
    for part in &item.parts {
        text.push_str(&format!("{indent}{}  {}\n", part.finding.verdict.word(), part.reading));
        text.push_str(&format!("{indent}  {}\n", summary_of(&part.finding)));
        if let Some(reason) = &part.finding.not_certified_because {
            text.push_str(&format!("{indent}  not certified because of {reason}\n"));
        }
    }
    if item.ok {
        for note in diagnostic::evidence(&item.finding) {
            text.push_str(&format!("{indent}{note}\n"));
        }
    }
    text
}

fn unexpected(document: &Document, item: &Equation, colour: bool) -> String {
    // Each part that is not as expected speaks for itself; a whole that was expected to fail speaks alone.
    let own = item.parts.iter().filter(|part| !part.ok && part.finding.follows_from.is_none());
    let findings: Vec<&Finding> = own.map(|part| &part.finding).collect();
    let findings = if findings.is_empty() { vec![&item.finding] } else { findings };
    let shown = findings.into_iter().map(|finding| {
        let title = match (&item.because, finding.verdict.passes()) {
            (Some(because), true) => format!("({}) passes, and was expected not to: {because}", item.id),
            (Some(because), false) => {
                format!("({}) is {}: {}; expected otherwise: {because}", item.id, finding.verdict, finding.message)
            }
            (None, _) => format!("({}) is {}: {}", item.id, finding.verdict, finding.message),
        };
        let label = match finding.verdict {
            Verdict::Refuted => "this does not hold",
            Verdict::Unreadable => "this",
            _ => "",
        };
        let verdict = diagnostic::verdict(&title, label, &document.source, finding, colour);
        let fit = finding.fit.as_ref().map(|fit| diagnostic::fit(fit, &document.source, colour));
        std::iter::once(verdict).chain(fit).collect::<Vec<_>>().join("\n\n")
    });
    let repairs = item.repairs.iter().enumerate();
    let repairs = repairs.map(|(at, repair)| match &repair.shared {
        // Shown once.
        Some(shared) if shared.mends.first() != Some(&item.id) => diagnostic::mended_as_well(shared, colour),
        _ => diagnostic::repair(repair, at == 0, &document.source, colour),
    });
    let elsewhere = (!item.elsewhere.is_empty()).then(|| diagnostic::elsewhere(&item.id, &item.elsewhere, colour));
    shown.chain(repairs).chain(elsewhere).collect::<Vec<_>>().join("\n\n")
}

fn summary(report: &Report) -> String {
    let equations: usize = report.documents.iter().map(|document| document.equations.len()).sum();
    let sentences: usize = report.documents.iter().map(|document| document.sentences.len()).sum();
    let counts: Vec<String> =
        report.counts().into_iter().map(|(verdict, count)| format!("{count} {verdict}")).collect();
    let verdict = match (report.unexpected(), report.items().next()) {
        (_, None) => "nothing was checked".to_owned(),
        (0, _) => "all as expected".to_owned(),
        (1, _) => "1 is not as expected".to_owned(),
        (n, _) => format!("{n} are not as expected"),
    };
    let inherited = report.items().filter(|item| !item.ok && item.finding.follows_from.is_some()).count();
    let verdict = match inherited {
        0 => verdict,
        1 => format!("{verdict}, 1 because it follows from another"),
        n => format!("{verdict}, {n} because they follow from another"),
    };
    let plural = |n: usize, word: &str| if n == 1 { format!("1 {word}") } else { format!("{n} {word}s") };
    let (equations, sentences) = (plural(equations, "equation"), plural(sentences, "sentence"));
    let counts = if counts.is_empty() { String::new() } else { format!(": {}", counts.join(", ")) };
    format!("{equations}, {sentences}{counts} — {verdict}")
}

fn paint(text: &str, verdict: Verdict, ok: bool, colour: bool) -> String {
    let code = match (ok, verdict.passes()) {
        (true, true) => "32",
        (true, false) => "33",
        (false, _) => "31",
    };
    if colour { format!("\u{1b}[{code}m{text}\u{1b}[0m") } else { text.to_owned() }
}
