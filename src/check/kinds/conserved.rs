//! The claim that a quantity is constant along the motion.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Node, Relation, SymbolId, text};

use crate::check::judge::at_states::AtStates;
use crate::check::judge::conclusion::conclude;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::model::free_symbols;
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::sample::outcome::run;
use crate::check::search::family_sizes;
use crate::check::state::counterexample::values_of_motion;
use crate::check::vacuity::forced_value;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::phrases::listed;

/// Checks that a formula is constant on shell, and not for any motion. Hypotheses hold at all times here, except those about
/// families.
///
/// # Errors
/// When the system's mass matrix is singular.
pub fn check(expr: &Expr, context: &Context<'_>) -> Result<Finding> {
    let rate = Expr::new(Node::TimeDerivative(1, Box::new(expr.clone())), expr.span);
    Ok(context.for_every_function(judged(expr, context)?, &[&rate]))
}

fn judged(expr: &Expr, context: &Context<'_>) -> Result<Finding> {
    let has_motion = context.model.has_motion();
    if !has_motion && !context.hypotheses.iter().any(is_about_rates) {
        // A pressure or a volume has no equation of motion, but a law or a hypothesis may say how it changes.
        let model = context.model;
        let is_varying =
            |id: &SymbolId| matches!(model.meaning(*id), Some(Meaning::Varying(_) | Meaning::Coordinate(_)));
        let varying = free_symbols::drawn(&[expr], model).into_iter().filter(is_varying);
        let names: Vec<String> = varying.map(|id| text::plain(&model.name(id))).collect();
        let change = if names.len() == 1 { "changes" } else { "change" };
        let what = match names.is_empty() {
            true => "nothing determines the motion".to_owned(),
            false => format!("nothing says how {} {change}", listed(&names, "and")),
        };
        let message = format!(
            "{what}; name a \"system\" or \"laws\", or say which name is the Lagrangian: \"means\": {{ \"L\": \"Lagrangian\" }}"
        );
        return Ok(context.finding(Code::NoMotion, Verdict::Undecided, message));
    }
    if let Some(finding) = context.unclear(&[expr]) {
        return Ok(finding);
    }
    // With a hypothesis about one instant, any quantity would pass that is stationary at a turning point. Hypotheses
    // about families, and about constants only, are kept.
    let symbols = &context.model.symbols;
    let varies = |symbol: &SymbolId| !matches!(context.model.meaning(*symbol), Some(Meaning::Constant(_)));
    let at_all_times = |hypothesis: &Hypothesis| {
        let drawn = free_symbols::drawn(&[&hypothesis.lhs, &hypothesis.rhs], context.model);
        let single = drawn.iter().all(|symbol| symbols.entry(*symbol).slots.is_empty());
        Hypothesis { throughout: hypothesis.throughout || single && drawn.iter().any(varies), ..hypothesis.clone() }
    };
    let hypotheses: Vec<Hypothesis> = context.hypotheses.iter().map(at_all_times).collect();
    let context = &Context { hypotheses: &hypotheses, ..*context };
    let rate = Expr::new(Node::TimeDerivative(1, Box::new(expr.clone())), expr.span);
    let zero = Expr::integer(0, expr.span);
    let free = crate::formula::shape::bind(expr.clone(), &context.model.symbols).map(|(_, found)| found.free);
    let link = Link { lhs: rate, relation: Relation::Equal, rhs: zero, free: free.unwrap_or_default() };
    // Where only hypotheses say how something moves, they are the motion.
    let free = Context { hypotheses: if has_motion { context.hypotheses } else { &[] }, ..*context };
    let off_shell = free.ensemble(free.mode(false, &[&link.lhs]), false, context.options.points)?;
    // Hypotheses that contradict each other leave no state, at which anything would be constant.
    if off_shell.states.is_empty() {
        return Ok(context.no_state(&off_shell));
    }
    match run(&link, &off_shell.states) {
        Err(reason) => return Ok(context.unavailable(&reason)),
        Ok(outcome) if outcome.failure.is_none() => {
            return Ok(context.finding(
                Code::AlwaysConstant,
                Verdict::Undecided,
                "this is constant for any motion, so the claim tests nothing; correct the formula, or remove the claim",
            ));
        }
        Ok(_) => {}
    }
    let on_shell = Context { on_shell: has_motion.then_some(true), ..*context };
    let mode = on_shell.mode(has_motion, &[&link.lhs]);
    let ensemble = on_shell.ensemble(mode, false, context.options.points)?;
    if ensemble.states.is_empty() {
        return Ok(context.no_state(&ensemble));
    }
    // Hypotheses such as a \dot x = b \dot x hold at rest too, where anything is constant.
    let rests = |(id, _): &(SymbolId, u8)| {
        let symbol = Expr::new(Node::Symbol { id: *id, indices: Vec::new(), dots: 1 }, expr.span);
        let link = Link { lhs: symbol, ..link.clone() };
        run(&link, &ensemble.states).is_ok_and(|outcome| outcome.failure.is_none())
    };
    if !has_motion && expr.symbols().iter().all(rests) {
        let message = "the hypotheses hold only at rest, where anything is constant; correct the hypotheses";
        return Ok(context.finding(Code::NoMotion, Verdict::Undecided, message));
    }
    let states = AtStates::new(&link, &ensemble.states);
    let outcome = match states.run(&ensemble.projection) {
        Ok(outcome) => outcome,
        Err(reason) => return Ok(context.unavailable(&reason)),
    };
    let mut finding = conclude(&states, &on_shell, &ensemble, &outcome);
    if let (Verdict::Verified, Some(symbol)) =
        (finding.verdict, forced_value::of_formulas(&[expr], &on_shell, &ensemble))
    {
        return Ok(context.finding(Code::ForcedValue, Verdict::Undecided, forced_value::message(symbol, context)));
    }
    if let (Some((_, at)), Some(found)) = (&outcome.failure, &mut finding.counterexample) {
        found.state = values_of_motion(expr, &ensemble.states[*at]);
    }
    finding.message = match finding.verdict {
        Verdict::Verified => {
            finding.message = "constant on shell".to_owned();
            return family_sizes::certified(&link, &on_shell, &ensemble, finding);
        }
        Verdict::Refuted => {
            finding.code = Code::NotConserved;
            not_constant(expr, &finding, context)
        }
        _ => finding.message,
    };
    Ok(finding)
}

/// Whether a hypothesis that holds at all times says how something moves.
fn is_about_rates(hypothesis: &Hypothesis) -> bool {
    let has_rate = |side: &Expr| {
        let mut found = false;
        side.walk(&mut |part| {
            found |= matches!(part.node, Node::TimeDerivative(..) | Node::Symbol { dots: 1.., .. });
        });
        found
    };
    hypothesis.throughout && (has_rate(&hypothesis.lhs) || has_rate(&hypothesis.rhs))
}

/// The message that a quantity changes, with its rate at the counterexample.
fn not_constant(quantity: &Expr, finding: &Finding, context: &Context<'_>) -> String {
    let name = text::formula(quantity, &context.model.symbols);
    let (quoted, rate) = match &quantity.node {
        Node::Symbol { .. } => (name.clone(), format!("d{name}/dt")),
        _ => (format!("“{name}”"), format!("d/dt({name})")),
    };
    let Some(found) = &finding.counterexample else { return format!("{quoted} is not constant") };
    let entry = found.entry.as_ref().map_or_else(String::new, |entry| format!(" ({entry})"));
    format!("{quoted} is not constant: {rate} = {}{entry} at the counterexample", text::number(found.lhs, 5))
}
