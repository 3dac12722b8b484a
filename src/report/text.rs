//! The report of a check, for people: failures in full, passes counted, and a summary in the last line.

use std::collections::BTreeMap;

use crate::check::{Document, Equation, Finding, Report, Verdict};
use crate::code::Code;

use super::code;
use super::diagnostic;
use super::excerpt::Excerpt;
use super::style::{Colour, Style, columns};
use super::wrap::wrap;

/// A list has so many columns for the numbers of equations. A longer name of a sentence moves the rest of its line.
const WIDEST_NUMBER: usize = 12;

/// The column that the lists of a report begin at.
const INDENT: usize = 2;

/// The whole report; `verbose` lists every equation, how it was read, and what was inferred.
pub fn report(report: &Report, verbose: bool, style: Style) -> String {
    let mut text = String::new();
    // A page of a folder that is not about equations has nothing to tell.
    let has_equations = |document: &&Document| items(document).next().is_some() || document.unnumbered > 0;
    let is_alone = report.documents.len() == 1;
    for document in report.documents.iter().filter(|document| verbose || is_alone || has_equations(document)) {
        let shown = if verbose { listed(document, style) } else { counted(document, style) };
        text.push_str(&shown);
    }
    if !verbose && !report.documents.is_empty() {
        text.push('\n');
    }
    let mut codes: Vec<(&'static str, Verdict, usize)> = Vec::new();
    for document in &report.documents {
        let own = |item: &&Equation| !item.ok && item.finding.follows_from.is_none();
        for item in items(document).filter(own) {
            text.push_str(&diagnostic::unexpected(document, item, style));
            text.push_str("\n\n");
            let (code, verdict) = (code::of_item(item), code::first_unexpected(item).verdict);
            match codes.iter_mut().find(|(known, ..)| *known == code) {
                Some((_, worst, count)) => {
                    *count += 1;
                    if verdict.severity() > worst.severity() {
                        *worst = verdict;
                    }
                }
                None => codes.push((code, verdict, 1)),
            }
        }
    }
    for document in report.documents.iter().filter(|document| !document.is_guessed) {
        for item in items(document).filter(|item| item.ok && item.because.is_none()) {
            text.extend(diagnostic::warning(document, item, style).map(|warning| warning + "\n\n"));
        }
    }
    text.push_str(&wrap("", &summary(report), INDENT, style.width));
    text.push('\n');
    if !verbose && let Some(line) = left_open(report) {
        text.push_str(&(wrap("", &line, INDENT, style.width) + "\n"));
    }
    text.push_str(&codes_hint(codes, style));
    text
}

/// How often each code of what is not as expected occurs, and how to look up the first: that of the worst verdict.
fn codes_hint(mut codes: Vec<(&'static str, Verdict, usize)>, style: Style) -> String {
    codes.sort_by_key(|(_, verdict, count)| std::cmp::Reverse((verdict.severity(), *count)));
    let Some((first, ..)) = codes.first() else { return String::new() };
    let counts: Vec<String> = codes.iter().map(|(code, _, count)| format!("{count}\u{a0}{code}")).collect();
    let listed = match codes.len() {
        1 => String::new(),
        _ => wrap("", &format!("Codes: {}", counts.join(", ")), INDENT, style.width) + "\n",
    };
    listed + &code_hint(first, style)
}

/// The line that says how to look up a code.
pub fn code_hint(code: &str, style: Style) -> String {
    wrap("", &format!("For more information about a code, try: onshell\u{a0}explain\u{a0}{code}"), 0, style.width)
        + "\n"
}

/// Equations, and then sentences.
fn items(document: &Document) -> impl Iterator<Item = &Equation> {
    document.equations.iter().chain(&document.sentences)
}

/// Whether it is no failure only because nothing tests the definition.
fn is_untested(item: &Equation) -> bool {
    item.ok && item.because.is_none() && item.finding.verdict == Verdict::Undecided
}

/// Whether it was not decided or not read, and nothing says that this was expected.
fn is_open(item: &Equation) -> bool {
    let verdict = item.finding.verdict;
    let is_open = matches!(verdict, Verdict::Undecided | Verdict::Unreadable | Verdict::Unclaimed);
    item.ok && item.because.is_none() && is_open && !is_untested(item)
}

/// A document in one line; below it what is wrong because something else is, and what is not well-formed.
fn counted(document: &Document, style: Style) -> String {
    // What is as it should be comes first, and then the best verdict.
    let mut counts: BTreeMap<(bool, bool, usize), (Verdict, usize)> = BTreeMap::new();
    for item in items(document) {
        let verdict = item.finding.verdict;
        counts.entry((!item.ok, is_untested(item), verdict.severity())).or_insert((verdict, 0)).1 += 1;
    }
    let mut told: Vec<String> = Vec::new();
    for ((wrong, is_untested, _), (verdict, count)) in counts {
        let ok = !wrong;
        let expectation = match (ok, verdict.passes()) {
            _ if is_untested => " with a warning",
            (true, true) | (false, false) => "",
            (true, false) => " as expected",
            (false, true) => " against expectation",
        };
        let count = self::count(count, verdict) + &expectation.replace(' ', "\u{a0}");
        told.push(style.paint(&count, colour(verdict, ok)));
    }
    if document.is_guessed && !told.is_empty() {
        told = unaided_counts(&items(document).collect::<Vec<_>>());
    }
    if told.is_empty() && document.unnumbered == 0 {
        told.push(
            "nothing to check: no displayed equation was found, and formulas in a sentence are not checked".to_owned(),
        );
    } else if told.is_empty() {
        told.push("nothing to check".to_owned());
    }
    let unnumbered = unnumbered(document).map(|line| format!("; {line}")).unwrap_or_default();
    let line = format!("{}{unnumbered}", told.join(", "));
    let mut text = wrap(&format!("{}: ", document.path), &line, INDENT, style.width) + "\n";
    let width = number_width(document);
    let follows = |item: &&Equation| !item.ok && item.finding.follows_from.is_some();
    let is_malformed = |item: &&Equation| is_open(item) && item.finding.code == Code::Syntax;
    for item in items(document).filter(|item| follows(item) || is_malformed(item)) {
        text.push_str(&self::line(item, width, style));
    }
    text
}

/// A document with a line for each equation and sentence, how it was read, and what was inferred.
fn listed(document: &Document, style: Style) -> String {
    let claims = match &document.claims {
        Some(claims) => format!("(claims: {claims})"),
        None => "(no claims file)".to_owned(),
    };
    let mut text = wrap(&format!("{}  ", document.path), &claims, INDENT, style.width) + "\n";
    let mut tell = |line: &str| text.push_str(&(wrap("    ", line, 6, style.width) + "\n"));
    document.inferred.iter().for_each(|line| tell(line));
    let width = number_width(document);
    for item in &document.equations {
        text.push_str(&line(item, width, style));
        text.push_str(&details(document, item, style));
    }
    if let Some(line) = unnumbered(document) {
        text.push_str(&(wrap("  ", &line, 4, style.width) + "\n"));
    }
    if !document.sentences.is_empty() {
        text.push_str("  sentences\n");
        for item in &document.sentences {
            text.push_str(&line(item, width, style));
            text.push_str(&details(document, item, style));
        }
    }
    text.push('\n');
    text
}

/// How many have a verdict.
fn count(count: usize, verdict: Verdict) -> String {
    let plural = match verdict {
        Verdict::Domain => return format!("{count}\u{a0}with a restricted domain"),
        Verdict::Definition | Verdict::Law if count != 1 => "s",
        _ => "",
    };
    format!("{count}\u{a0}{verdict}{plural}")
}

/// What became of the displays of notes without a claims file.
fn unaided_counts(items: &[&Equation]) -> Vec<String> {
    let of = |wanted: fn(Verdict) -> bool, one: &str, many: &str| {
        let count = items.iter().filter(|item| wanted(item.finding.verdict)).count();
        (count > 0).then(|| format!("{count}\u{a0}{}", if count == 1 { one } else { many }))
    };
    [
        of(Verdict::holds, "follows", "follow"),
        of(|verdict| matches!(verdict, Verdict::Definition | Verdict::Law), "introduced", "introduced"),
        of(|verdict| verdict == Verdict::Assumed, "taken for granted", "taken for granted"),
        of(|verdict| verdict == Verdict::Refuted, "wrong", "wrong"),
        of(|verdict| verdict == Verdict::Undecided, "not decided", "not decided"),
        of(|verdict| matches!(verdict, Verdict::Unreadable | Verdict::Unclaimed), "not read", "not read"),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// How many displays without a claims file were not decided or not read, and how to see which.
fn left_open(report: &Report) -> Option<String> {
    let open: Vec<&Equation> =
        report.documents.iter().filter(|one| one.is_guessed).flat_map(items).filter(|item| is_open(item)).collect();
    let count = |wanted: fn(&Verdict) -> bool| open.iter().filter(|item| wanted(&item.finding.verdict)).count();
    let undecided = count(|verdict| *verdict == Verdict::Undecided);
    let said = |count: usize, what: &str| {
        let (display, was) = if count == 1 { ("display", "was") } else { ("displays", "were") };
        (count > 0).then(|| format!("{count} {display} {was} not {what}"))
    };
    let said: Vec<String> =
        [said(open.len() - undecided, "read"), said(undecided, "decided")].into_iter().flatten().collect();
    let them = if open.len() == 1 { "see why" } else { "list them" };
    (!said.is_empty()).then(|| format!("{}; {them} with --verbose", said.join(" and ")))
}

/// How a display without a number is checked.
const TO_NAME: &str = "number it with \\tag, or name it under \"equations\" by a part of its LaTeX in backticks";

/// The displays that were not checked.
fn unnumbered(document: &Document) -> Option<String> {
    match document.unnumbered {
        0 => None,
        1 => Some(format!("1 display without a number was not checked; {TO_NAME}")),
        n => Some(format!("{n} displays without a number were not checked; {TO_NAME}")),
    }
}

/// How wide the numbers of a document are.
fn number_width(document: &Document) -> usize {
    items(document).map(|item| columns(&item.id)).max().unwrap_or(0).min(WIDEST_NUMBER)
}

fn line(item: &Equation, width: usize, style: Style) -> String {
    let finding = &item.finding;
    // What is taken for granted was not checked.
    let mark = match item.ok {
        true if finding.verdict == Verdict::Assumed || is_untested(item) => "·",
        // Nothing was found wrong in it, and it was not tested either.
        true if is_open(item) => "?",
        true => "✓",
        false => "✗",
    };
    let verdict = style.paint(&format!("{:<10}", finding.verdict.word()), colour(finding.verdict, item.ok));
    let mut text = match (&item.because, item.ok) {
        (Some(because), true) => format!("as expected: {because}"),
        _ => summary_of(finding),
    };
    if item.parts.len() > 1 {
        text.push_str(&format!(" ({}\u{a0}parts)", item.parts.len()));
        // What one part leaves open is said of the whole.
        let leaves_open = |finding: &Finding| finding.code == Code::DefinitionUpToSign;
        if item.ok && !leaves_open(finding) && item.parts.iter().any(|part| leaves_open(&part.finding)) {
            text.push_str(" · no other equation checks the sign of a definition in it");
        }
    }
    let first = format!("  {mark} {}{}  {verdict}  ", item.id, " ".repeat(width.saturating_sub(columns(&item.id))));
    wrap(&first, &text, 8, style.width) + "\n"
}

/// A message, with the figures of what passes.
fn summary_of(finding: &Finding) -> String {
    let mut text = finding.message.clone();
    if finding.verdict.passes() && finding.points > 0 {
        text.push_str(&format!(" ·\u{a0}{}\u{a0}states", finding.points));
        if let Some(residual) = finding.max_residual {
            text.push_str(&format!(" ·\u{a0}residual\u{a0}{residual:.0e}"));
        }
        if let Some(power) = finding.false_accept_log2 {
            text.push_str(&format!(" ·\u{a0}false with probability below 2^{:.0}", power.ceil()));
        }
    }
    text
}

/// How an equation and its parts were read.
fn details(document: &Document, item: &Equation, style: Style) -> String {
    let indent = 6;
    let mut text = String::new();
    let mut tell = |inside: usize, line: &str| {
        let first = " ".repeat(indent + inside);
        text.push_str(&(wrap(&first, line, indent + inside + 2, style.width) + "\n"));
    };
    if let Some(numbers) = document.automatic_numbers.get(&item.id) {
        let numbers: Vec<String> = numbers.iter().map(|number| format!("({number})")).collect();
        let what = if numbers.len() == 1 { "number" } else { "numbers" };
        tell(0, &format!("the {what} in the typeset document: {}", numbers.join(", ")));
    }
    if item.parts.is_empty() {
        // What could not be read has no reading.
        if !item.reading.is_empty() {
            tell(0, &item.reading);
        }
        if let Some(reason) = &item.finding.not_certified_because {
            tell(0, &format!("not certified: exact arithmetic does not decide {reason}"));
        }
    }
    for part in &item.parts {
        let unread = if part.reading.is_empty() { &part.latex } else { &part.reading };
        tell(0, &format!("{}:\u{a0} {unread}", part.finding.verdict.word()));
        tell(2, &summary_of(&part.finding));
        if let Some(reason) = &part.finding.not_certified_because {
            tell(2, &format!("not certified: exact arithmetic does not decide {reason}"));
        }
    }
    if item.ok {
        diagnostic::evidence(&item.finding).iter().for_each(|note| tell(0, note));
    }
    // What is not read and not shown below as an error is shown here, with a mark under the place.
    if item.ok && item.finding.verdict == Verdict::Unreadable {
        let width = style.width.saturating_sub(indent);
        for line in Excerpt::of(&document.source, item.finding.span).beneath(width) {
            text.push_str(&format!("{}{line}\n", " ".repeat(indent)));
        }
    }
    text
}

fn summary(report: &Report) -> String {
    if !report.documents.is_empty() && report.documents.iter().all(|document| document.is_guessed) {
        let counts = unaided_counts(&report.items().collect::<Vec<_>>());
        let displays = report.items().count();
        let plural = if displays == 1 { "" } else { "s" };
        let counts = if counts.is_empty() { "nothing was checked".to_owned() } else { counts.join(", ") };
        let basis = match report.documents.iter().all(|document| document.claims.is_none()) {
            true => "without a claims file",
            false => "with guesses in the claims file",
        };
        return format!("{displays} display{plural}, {basis}: {counts}");
    }
    let equations: usize = report.documents.iter().map(|document| document.equations.len()).sum();
    let sentences: usize = report.documents.iter().map(|document| document.sentences.len()).sum();
    let counts = report.counts();
    let counts = Verdict::ALL.iter().filter_map(|verdict| Some((verdict, *counts.get(verdict.word())?)));
    let counts: Vec<String> = counts.map(|(verdict, count)| self::count(count, *verdict)).collect();
    let verdict = match (report.unexpected(), report.items().next()) {
        (_, None) => "nothing was checked".to_owned(),
        (0, _) => match report
            .documents
            .iter()
            .filter(|one| !one.is_guessed)
            .flat_map(items)
            .filter(|item| is_untested(item))
            .count()
        {
            0 => "all as expected".to_owned(),
            1 => "none is wrong, and 1 definition was not tested".to_owned(),
            n => format!("none is wrong, and {n} definitions were not tested"),
        },
        (1, _) => "1 is not as expected".to_owned(),
        (n, _) => format!("{n} are not as expected"),
    };
    let inherited = report.items().filter(|item| !item.ok && item.finding.follows_from.is_some()).count();
    let verdict = match inherited {
        0 => verdict,
        1 => format!("{verdict}, 1 because of a mistake in another"),
        n => format!("{verdict}, {n} because of a mistake in another"),
    };
    let plural = |n: usize, word: &str| if n == 1 { format!("1 {word}") } else { format!("{n} {word}s") };
    let (equations, sentences) = (plural(equations, "equation"), plural(sentences, "sentence"));
    let counts = if counts.is_empty() { String::new() } else { format!(": {}", counts.join(", ")) };
    format!("{equations}, {sentences}{counts} — {verdict}")
}

fn colour(verdict: Verdict, ok: bool) -> Colour {
    match (ok, verdict.passes()) {
        (true, true) => Colour::Green,
        (true, false) => Colour::Yellow,
        (false, _) => Colour::Red,
    }
}
