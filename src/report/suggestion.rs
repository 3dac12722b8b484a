//! What would make an equation pass: edits of the notes, as differences of lines.

use annotate_snippets::{Element, Group, Level};

use crate::check::{Document, Equation, Fit, Misfit, Repair, Shared, Slip, Verdict};
use crate::phrases;
use crate::source::{Source, Span};

use super::excerpt::{Excerpt, Mark, alone};
use super::style::Style;
use super::wrap::{shortened, titled, wrap};

/// The columns that a quoted piece of the notes has in a title.
const QUOTED: usize = 40;

/// Everything that is suggested for an equation, a block each.
pub(super) fn all(document: &Document, item: &Equation, style: Style) -> Vec<String> {
    let source = &document.source;
    let parts = item.parts.iter().filter(|part| !part.ok && part.finding.follows_from.is_none());
    let mut findings: Vec<_> = parts.map(|part| &part.finding).collect();
    if findings.is_empty() {
        findings.push(&item.finding);
    }
    let fits = findings.iter().filter_map(|finding| finding.fit.as_ref()).map(|fit| self::fit(fit, source, style));
    // Where only this display is called wrong, the edit is shown for it.
    let is_blamed = |shared: &Shared| shared.of == item.id && !shared.mends.contains(&item.id);
    let repairs = item.repairs.iter().enumerate().map(|(at, repair)| match &repair.shared {
        // An edit that corrects several equations is shown once.
        Some(shared) if shared.mends.first() != Some(&item.id) && !is_blamed(shared) => corrected_too(shared, style),
        _ => self::repair(repair, at == 0, source, style),
    });
    let elsewhere = (!item.elsewhere.is_empty()).then(|| self::elsewhere(&item.id, &item.elsewhere, style));
    let mut all: Vec<String> = fits.chain(repairs).chain(elsewhere).collect();
    // Several edits of one display are told of once.
    all.dedup();
    all
}

/// An edit that would make an equation pass, shown on its lines; `first` is the likeliest of several.
pub fn repair(repair: &Repair, first: bool, source: &Source, style: Style) -> String {
    let quoted = |text: &str| {
        let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
        // A control character would reach the terminal.
        shortened(&line.replace(char::is_control, "?"), QUOTED)
    };
    let (old, new) = (quoted(source.slice(repair.span)), quoted(&repair.replacement));
    let change = match (old.as_str(), new.as_str()) {
        // A factor is put in with the space that parts it from the next.
        ("", new) if repair.slip == Slip::Factor => {
            let factor = new.trim().trim_start_matches(r"\,").trim_end_matches(r"\,").trim();
            format!("to multiply by “{factor}”")
        }
        ("", new) => format!("to add “{new}”"),
        (old, "") => format!("to leave out “{old}”"),
        (old, new) => format!("“{new}” in place of “{old}”"),
    };
    let asked = if first { "did you mean" } else { "or did you mean" };
    let then = match (&repair.shared, repair.step) {
        (Some(Shared { of, mends }), _) if mends.contains(of) => {
            let hold = if mends.len() == 1 { "holds" } else { "hold" };
            format!("With this edit of ({of}), {} {hold}", phrases::displays(mends, "and"))
        }
        (Some(Shared { of, mends }), _) => match mends.as_slice() {
            [one] if !is_adjective(repair.verdict) => {
                format!("With this edit of ({of}), ({one}) passes")
            }
            [one] => format!("With this edit of ({of}), ({one}) is {}", repair.verdict),
            _ => format!("With this edit of ({of}), {} hold", phrases::displays(mends, "and")),
        },
        (None, true) => "Then this step passes, but a later step of the chain still fails".to_owned(),
        (None, false) if repair.verdict == Verdict::Assumed => "Then the dimensions fit".to_owned(),
        (None, false) if !is_adjective(repair.verdict) => "Then this equation passes".to_owned(),
        (None, false) => format!("Then the equation is {}", repair.verdict),
    };
    let title = Level::HELP.secondary_title(titled("help", "", &format!("{asked} {change}? {then}"), style));
    Excerpt::of(source, repair.span).replaced(title, repair.span, &repair.replacement, style)
}

/// Whether the word of a verdict says what an equation is: "it is certified", and not "it is law".
fn is_adjective(verdict: Verdict) -> bool {
    !matches!(verdict, Verdict::Definition | Verdict::Law)
}

/// The terms that must change for an equation to hold, all at once, shown on their lines.
fn fit(fit: &Fit, source: &Source, style: Style) -> String {
    let title = match fit.terms.len() {
        0 => "the equation passes with more terms on its right side",
        1 => "the equation passes if this term is changed",
        _ => "the equation passes if all of these terms are changed",
    };
    let title = Level::HELP.secondary_title(titled("help", "", title, style));
    let label = |misfit: &Misfit| match misfit.coefficient.numerator {
        0 => "this term does not belong".to_owned(),
        -1 if misfit.coefficient.denominator == 1 => "should have the other sign".to_owned(),
        _ => format!("should be multiplied by {}", misfit.coefficient),
    };
    let missing: Vec<&str> = fit.missing.iter().map(|term| term.text.as_str()).collect();
    let missing = (!missing.is_empty()).then(|| format!("add on the right side: {}", missing.join(" and ")));
    let note = |text: String| Level::NOTE.message(wrap("", &text, 2, style.inside(16).width)).into();
    let mut notes: Vec<Element<'_>> = missing.map(note).into_iter().collect();
    let all = fit.terms.iter().map(|misfit| misfit.span).reduce(Span::to);
    match all.map(|all| (Excerpt::of(source, all), all)) {
        Some((excerpt, all)) if excerpt.has(all) => {
            let mark = |misfit: &Misfit| Mark { span: misfit.span, label: label(misfit) };
            let marks: Vec<Mark> = fit.terms.iter().map(mark).collect();
            excerpt.with_marks(title, &marks, notes, style)
        }
        _ => {
            let places = fit.terms.iter().map(|misfit| {
                let (line, column) = source.line_column(misfit.span.start);
                note(format!("the term at {}:{line}:{column}: {}", source.path_at(misfit.span.start), label(misfit)))
            });
            notes.extend(places);
            alone(title.elements(notes), style)
        }
    }
}

/// That an edit which is shown for another equation makes this one pass too.
fn corrected_too(shared: &Shared, style: Style) -> String {
    let at = match shared.mends.first() {
        Some(first) if *first != shared.of => format!(" that is shown for ({first})"),
        _ => String::new(),
    };
    let title = format!("the edit of ({}){at} corrects this too", shared.of);
    alone(Group::with_title(Level::HELP.secondary_title(titled("help", "", &title, style))), style)
}

/// Where the mistake of an equation may be instead.
fn elsewhere(id: &str, displays: &[String], style: Style) -> String {
    let title = match displays {
        [own] if own == id => {
            "no passing equation uses the name that this equation defines, so the mistake may be on either side"
                .to_owned()
        }
        displays => {
            let listed = phrases::displays(displays, "or");
            format!("no passing equation uses {listed}, so the mistake may be in {listed}")
        }
    };
    alone(Group::with_title(Level::NOTE.secondary_title(titled("note", "", &title, style))), style)
}
