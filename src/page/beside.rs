//! What stands beside the notes: the derived terms beside the printed ones, both sides of a wrong equation as curves, the
//! pictures of the system, and its derivation.

use maud::{Markup, PreEscaped, html};

use super::typeset;
use super::{Exhibit, derivation};
use crate::check::{Equation, Verdict};
use crate::formula::text::plain;
use crate::latex::Macros;
use crate::lecture::{Beside, Sides};
use crate::notes::Display;
use crate::plot::{Picture, two_sides};

/// The pictures of a system as a section.
pub(super) fn pictures(exhibit: &Exhibit) -> Markup {
    figures(&exhibit.pictures)
}

/// Pictures as a section; nothing if there are none.
pub(super) fn figures(pictures: &[Picture]) -> Markup {
    html! {
        @if !pictures.is_empty() {
            section {
                h2 { "Pictures of the system" }
                @for picture in pictures { (figure(&picture.svg, &picture.caption)) }
            }
        }
    }
}

fn figure(svg: &str, caption: &str) -> Markup {
    html! { figure class="picture" { (PreEscaped(svg)) figcaption { (caption) } } }
}

/// What follows the text of a document: pictures, and the derivation of its system. A page with everything has both
/// once, at its end.
pub(super) fn after(exhibit: &Exhibit, anchor: Option<&str>, prefix: &str, single: bool) -> Markup {
    html! {
        @if !single || exhibit.lecture.is_none() { (pictures(exhibit)) }
        @if let Some((lecture, anchor)) = exhibit.lecture.as_ref().zip(anchor) {
            section {
                h2 { "The derivation, step by step" }
                @let address = if single { format!("#{anchor}") } else { format!("{anchor}.html") };
                p {
                    "The program derived the equations of this system line by line. It certified each line against \
                     the lines "
                    "before it: " a href=(address) { (derivation::title(lecture)) } "."
                }
                @if !single {
                    details {
                        summary { "All " (lecture.lines().count()) " lines" }
                        (derivation::passages(lecture, &format!("{prefix}derived-")))
                    }
                }
            }
        }
    }
}

/// The printed equation beside the derived one, term by term.
pub(super) fn lineup(
    item: &Equation,
    display: Option<&Display>,
    beside: Option<&Beside>,
    definitions: &[String],
) -> Markup {
    let found =
        display.zip(beside).and_then(|(display, beside)| beside.lineup(&display.text, &Macros::default(), definitions));
    let Some(found) = found.filter(|found| !(found.is_the_same() && found.rows.len() < 2)) else { return html! {} };
    // What holds under a hypothesis, or is an erratum, may differ from the general equation and be right.
    if item.finding.verdict.passes() && !found.is_the_same() {
        return html! {};
    }
    let formula = |latex: &Option<String>| match latex {
        Some(latex) => typeset::inline(latex, &[]),
        None => html! { span class="hint" { "nothing" } },
    };
    html! {
        div class="wide" tabindex="0" role="group" aria-label="Printed and derived terms" {
            table class="lineup" {
                caption { "The terms of " (typeset::inline(&found.left, &[])) ", printed and derived" }
                thead { tr { th scope="col" { "printed" } th scope="col" { "derived" } th scope="col" { "in words" } } }
                tbody {
                    @for row in &found.rows {
                        @let is_same = row.printed.is_some() && row.derived.is_some() && row.factor.is_none();
                        tr class=[(!is_same).then_some("differs")] {
                            td { (formula(&row.printed)) }
                            td { (formula(&row.derived)) }
                            td {
                                @match (&row.printed, &row.derived, &row.factor) {
                                    (_, _, Some(factor)) if factor == "-1" => "✗ printed with the other sign",
                                    (_, _, Some(factor)) => { "✗ printed with the factor " (factor.replace('-', "−")) },
                                    (Some(_), Some(_), None) => "✓ the same",
                                    (Some(_), None, None) => "✗ not derived",
                                    (None, ..) => "✗ missing",
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

/// Both sides of a wrong equation as curves.
pub(super) fn sides(
    item: &Equation,
    display: Option<&Display>,
    beside: Option<&Beside>,
    definitions: &[String],
) -> Markup {
    let Some(display) = display.filter(|_| item.finding.verdict == Verdict::Refuted) else { return html! {} };
    let of_system = beside.and_then(|beside| beside.sides(&display.text, &Macros::default(), definitions));
    let of_numbers = || {
        let found = item.finding.counterexample.as_ref()?;
        Sides::of_counterexample(&display.text, (&Macros::default(), definitions), &found.state, (found.lhs, found.rhs))
    };
    let Some(found) = of_system.or_else(of_numbers) else { return html! {} };
    let name = plain(&found.variable);
    match two_sides(&name, found.left, found.right, found.at) {
        Ok(svg) => figure(
            &svg,
            &format!(
                "The two sides of ({}) as functions of {name}. The rings show the sampled state; all other symbols \
                 keep the values that they have there. Of all variables, {name} separates the two sides most.",
                item.id
            ),
        ),
        Err(_) => html! {},
    }
}
