//! The names of momenta, where no declaration says what they are: p for the only coordinate, p_1 and p_2 for x_1 and x_2.
//!
//! Beside a Lagrangian they are other names for p_x, p_{x_1}, …, unless a display defines them, as `p = m \dot x` does, or
//! the notes have the long names too. Where the notes print a Hamiltonian instead, its momenta are variables of their own.

use crate::formula::symbols::Name;
use crate::formula::{Kind, SymbolId, text};
use crate::latex::name_search::mentions;
use crate::latex::{names, pairs_by_name};
use crate::notes::Notes;
use crate::notes::claims::{Claims, Range};

use crate::check::model::Model;
use crate::check::model::builder::plain;
use crate::check::model::meaning::{Meaning, Variable};

/// Gives the momenta of the document their names.
pub(crate) fn infer(claims: &Claims, notes: &Notes, model: &mut Model) {
    if model.printed_hamiltonian.is_some() {
        return of_a_hamiltonian(claims, notes, model);
    }
    let coordinates: Vec<SymbolId> = model.coordinates.iter().map(|coordinate| coordinate.symbol).collect();
    for (q, name) in short_names(&coordinates, model) {
        let known = model.symbols.canonical.iter().find(|(coordinate, _)| *coordinate == q);
        let Some(momentum) = known.and_then(|(_, names)| names.first().copied()) else { continue };
        let latex = name.to_string();
        let uses_the_long_name = notes.equations.iter().any(|display| has_name(&display.text, &model.name(momentum)));
        if uses_the_long_name || !is_used(&latex, notes, model) || is_taken(&latex, claims, notes) {
            continue;
        }
        let Some(meaning) = model.meaning(momentum).cloned() else { continue };
        let Some(id) = model.symbols.add(name, Kind::Scalar) else { continue };
        let entry = model.symbols.entry_mut(id);
        (entry.varies, entry.derived, entry.momentum) = (true, true, true);
        model.mean(id, meaning);
        pair(q, id, model);
    }
}

/// Declares the momenta of the Hamiltonian that the notes print, and makes its coordinates free functions of the time, which
/// Hamilton's equations move.
fn of_a_hamiltonian(claims: &Claims, notes: &Notes, model: &mut Model) {
    if model.coordinates.is_empty() {
        model.symbols.canonical = pairs_by_name(&model.symbols);
    }
    model.let_coordinates_vary();
    let coordinates: Vec<SymbolId> = model.symbols.canonical.iter().map(|(q, _)| *q).collect();
    let short = short_names(&coordinates, model);
    for q in coordinates {
        let is_known = |(coordinate, names): &(SymbolId, Vec<SymbolId>)| *coordinate == q && !names.is_empty();
        if model.symbols.canonical.iter().any(is_known) {
            continue;
        }
        let long = names::parse(&format!("p_{{{}}}", model.name(q))).map(|(name, _)| name);
        let brief = short.iter().find(|(other, _)| *other == q).map(|(_, name)| name.clone());
        let brief = brief.filter(|name| is_used(&name.to_string(), notes, model));
        let is_defined =
            |name: &Name| claims.define.iter().any(|(other, _)| plain(&other.value) == plain(&name.to_string()));
        let brief = brief.filter(|name| !is_defined(name));
        let is_long = long.as_ref().is_some_and(|long| {
            brief.is_none() || notes.equations.iter().any(|display| has_name(&display.text, &long.to_string()))
        });
        let Some(name) = (if is_long { long } else { brief }) else { continue };
        let id = match model.symbols.find(&name) {
            Some((id, _)) => id,
            None => {
                let Some(id) = model.symbols.add(name, Kind::Scalar) else { continue };
                model.symbols.entry_mut(id).varies = true;
                model.mean(id, Meaning::Varying(model.varying.len()));
                model.varying.push(Variable::number(id, Range::Any));
                id
            }
        };
        model.symbols.entry_mut(id).momentum = true;
        pair(q, id, model);
    }
    // A momentum that is declared as a coordinate is none.
    let momenta: Vec<SymbolId> = model.symbols.canonical.iter().flat_map(|(_, names)| names.clone()).collect();
    model.symbols.canonical.retain(|(q, _)| !momenta.contains(q));
}

/// Notes that a symbol is the momentum of a coordinate.
fn pair(q: SymbolId, id: SymbolId, model: &mut Model) {
    let of = text::plain(&model.name(q));
    model.inferred.push(format!("{} is the momentum of {of}", text::plain(&model.name(id))));
    if let Some((_, names)) = model.symbols.canonical.iter_mut().find(|(coordinate, _)| *coordinate == q) {
        names.push(id);
    }
}

/// The letter p with the subscript of each coordinate, where these tell the coordinates apart.
fn short_names(coordinates: &[SymbolId], model: &Model) -> Vec<(SymbolId, Name)> {
    let name = |q: &SymbolId| Name { subscript: model.symbols.entry(*q).name.subscript.clone(), ..Name::plain("p") };
    let names: Vec<(SymbolId, Name)> = coordinates.iter().map(|q| (*q, name(q))).collect();
    let is_alone = |(_, name): &(SymbolId, Name)| names.iter().filter(|(_, other)| other == name).count() == 1;
    names.iter().filter(|found| is_alone(found)).cloned().collect()
}

fn is_used(latex: &str, notes: &Notes, model: &Model) -> bool {
    notes.equations.iter().any(|display| mentions(&display.text, latex, &model.macros))
}

/// Whether the claims file or a display defines a name.
fn is_taken(latex: &str, claims: &Claims, notes: &Notes) -> bool {
    claims.define.iter().any(|(other, _)| plain(&other.value) == plain(latex))
        || notes.equations.iter().any(|display| defines(&display.text, latex))
}

/// Whether a text contains a name as one is typed: `p_x`, `p_{x}`.
fn has_name(text: &str, latex: &str) -> bool {
    let without = |text: &str| text.chars().filter(|c| !matches!(c, '{' | '}' | ' ')).collect::<String>();
    without(text).contains(&without(latex))
}

/// Whether a display says by an equation of its own what a name is: it stands alone as a member of a chain.
fn defines(display: &str, latex: &str) -> bool {
    let text: String = display.chars().filter(|c| !c.is_whitespace() && *c != '&').collect();
    let name = plain(latex);
    let members = text.split(['=', '≡', ',', ';']).flat_map(|part| part.split("\\equiv"));
    let members = members.flat_map(|part| part.split("\\qquad")).flat_map(|part| part.split("\\quad"));
    // A part of a bracket `\{q, p\}` is no member.
    let is_whole =
        |member: &&str| !member.contains("\\{") && member.matches('{').count() == member.matches('}').count();
    members.map(|member| member.trim_end_matches(['.', '\\'])).filter(is_whole).any(|member| plain(member) == name)
}
