//! The effective potential of what is not cyclic, and steady precession.

use serde_json::json;

use super::writer::Writer;
use crate::Result;
use crate::derive::Precession;

/// The name of the condition in the claims file.
const STEADY: &str = "steady precession";

pub(super) fn write(writer: &mut Writer<'_>) -> Result<()> {
    let (moving, cyclic) = writer.sorted();
    let applied = (0..moving.len() + cyclic.len()).map(|i| writer.derivation.applied_force(i));
    if applied.collect::<Result<Vec<_>>>()?.iter().any(Option::is_some) {
        return Ok(());
    }
    if moving.is_empty() || cyclic.is_empty() {
        return Ok(());
    }
    if let Ok(potential) = writer.derivation.effective_potential(&cyclic) {
        writer.heading("The effective potential");
        let momenta: Vec<String> =
            cyclic.iter().map(|&i| format!("${}$", writer.latex(&writer.derivation.momentum(i)))).collect();
        writer.claim("means", "U_{eff}", json!("effective potential"));
        let which = match momenta.len() {
            1 => "the value of the conserved momentum",
            _ => "the values of the conserved momenta",
        };
        let momenta = momenta.join(" and ");
        let given = format!("With {which} {momenta} fixed and the other coordinates at rest, the energy is");
        writer.say(given);
        let from = writer.lagrangian.clone();
        writer.line(&format!("U_{{eff}} = {}", writer.latex(&potential)), &[&from], &[&potential]);
    }
    if let (&[rest], &[one, other]) = (moving.as_slice(), cyclic.as_slice()) {
        for (turns, spins) in [(one, other), (other, one)] {
            if let Ok(Some(found)) = writer.derivation.precession(rest, turns, spins) {
                steady(writer, &found);
                break;
            }
        }
    }
    Ok(())
}

fn steady(writer: &mut Writer<'_>, found: &Precession) {
    let derivation = writer.derivation;
    let omega = writer.free(&["\\Omega", "\\nu"]);
    let [rest, turns] = [found.rest, found.turns].map(|i| writer.latex(&derivation.coordinate(i, 0)));
    let [rest_rate, turning_rate] = [found.rest, found.turns].map(|i| writer.latex(&derivation.coordinate(i, 1)));
    let spin = writer.latex(&derivation.momentum(found.spins));
    let inserted = |latex: String| latex.replace(&turning_rate, &omega);
    writer.claim("define", &omega, json!(turning_rate));
    writer.claim("conditions", STEADY, json!(format!("{rest_rate} = 0")));
    writer.heading("Steady precession");
    writer.say(format!(
        "In steady precession ${rest}$ stays as it is, and ${turns}$ turns at a constant rate ${omega} = {turning_rate}$. The \
         equation of motion of ${rest}$, with ${spin}$ for the spin, becomes a quadratic equation for ${omega}$."
    ));
    let [square, linear, constant] = found.quadratic.each_ref().map(|term| inserted(writer.latex(term)));
    let plus = |term: &str| match term.strip_prefix('-') {
        Some(opposite) => format!(" - {}", opposite.trim_start()),
        None => format!(" + {term}"),
    };
    let from = writer.lagrangian.clone();
    let quadratic = format!("{square}{}{} = 0", plus(&linear), plus(&constant));
    let equation = writer.line(&quadratic, &[&from], &[]);
    writer.claim("equations", &equation, json!({ "throughout": STEADY }));
    let [minus_b, discriminant, twice_a] = found.root.each_ref().map(|part| writer.latex(part));
    writer.say("It has two solutions, a fast and a slow precession.");
    let roots = format!("{omega}_{{\\pm}} = \\frac{{{minus_b} \\pm \\sqrt{{{discriminant}}}}}{{{twice_a}}}");
    let solved = writer.line(&roots, &[&equation], &[]);
    writer.claim("equations", &solved, json!({ "solves": equation, "for": omega }));
    let [fast, slow] = found.far.each_ref().map(|rate| writer.latex(rate));
    writer.say("For a fast top they simplify.");
    let latex = format!("{omega}_{{+}} \\approx {fast} , \\quad {omega}_{{-}} \\approx {slow}");
    let limit = writer.line(&latex, &[&solved], &[]);
    writer.claim("equations", &limit, json!({ "limit": format!("{spin} \\to \\infty") }));
}
