//! From the Lagrangian to the equations of motion, the energy and the Hamiltonian.

use serde_json::json;

use super::writer::Writer;
use crate::Result;
use crate::derive::Quantity;

/// The longest formula, in characters of LaTeX, that a lecture prints where it can do without.
const LONGEST: usize = 400;

pub(super) fn write(writer: &mut Writer<'_>) -> Result<()> {
    let derivation = writer.derivation;
    let [lagrangian, energy, hamiltonian] = derivation.functions().map(|name| writer.latex(&name));
    let momenta = derivation.equations(Quantity::Momenta)?;
    let motion = derivation.equations(Quantity::EulerLagrange)?;
    let (moving, cyclic) = writer.sorted();
    let from = writer.lagrangian.clone();
    let slope = |of: &str| format!("\\frac{{\\partial {lagrangian}}}{{\\partial {of}}}");
    let mut conjugate = vec![String::new(); momenta.len()];
    let applied = (0..momenta.len()).map(|i| derivation.applied_force(i)).collect::<Result<Vec<_>>>()?;
    // What a force acts on moves, though L does not contain it.
    let (free, pushed): (Vec<usize>, Vec<usize>) = cyclic.into_iter().partition(|&i| applied[i].is_none());
    let moving: Vec<usize> = moving.into_iter().chain(pushed).collect();
    for &i in &free {
        let name = writer.latex(&derivation.coordinate(i, 0));
        let rate = writer.latex(&derivation.coordinate(i, 1));
        let (momentum, value) = (writer.latex(&derivation.momentum(i)), writer.latex(&momenta[i].right));
        writer.heading(format!("The momentum of ${name}$"));
        writer.say(format!("${lagrangian}$ is differentiated by the rate of ${name}$."));
        let line = format!("{momentum} = {} = {value}", slope(&rate));
        conjugate[i] = writer.line(&line, &[&from], &[&momenta[i].right]);
        writer.say(format!("${lagrangian}$ does not depend on ${name}$ itself, so this momentum is conserved."));
        writer.line(&format!("{} = 0", slope(&name)), &[&from], &[]);
        writer.line(&format!("{momentum} = {value} \\text{{ is constant}}"), &[&conjugate[i]], &[]);
    }
    for &i in &moving {
        let name = writer.latex(&derivation.coordinate(i, 0));
        let rate = writer.latex(&derivation.coordinate(i, 1));
        let momentum = writer.latex(&derivation.momentum(i));
        writer.heading(format!("The equation of motion of ${name}$"));
        writer.say(format!("First, ${lagrangian}$ is differentiated by the rate of ${name}$."));
        let line = format!("{momentum} = {} = {}", slope(&rate), writer.latex(&momenta[i].right));
        conjugate[i] = writer.line(&line, &[&from], &[&momenta[i].right]);
        writer.say("Then this momentum is differentiated by the time.");
        let value = derivation.momentum_rate(i)?;
        let line = format!("\\frac{{d}}{{dt}} {} = {}", slope(&rate), writer.latex(&value));
        let momentum_rate = writer.line(&line, &[&conjugate[i]], &[&value]);
        writer.say(format!("The other side is the derivative of ${lagrangian}$ by ${name}$."));
        let value = derivation.force(i)?;
        let force = writer.line(&format!("{} = {}", slope(&name), writer.latex(&value)), &[&from], &[&value]);
        match &applied[i] {
            None => writer.say("The two are equal. With the accelerations on the left, this is"),
            Some(beside) => {
                let beside = writer.latex(beside);
                writer.claim("forces", &derivation_name(writer, i), json!(beside));
                writer.say(format!(
                    "The force ${beside}$ along ${name}$ is given beside ${lagrangian}$. The rate of the momentum is \
                     the sum of this derivative and this force. With the accelerations on the left, this is"
                ));
            }
        }
        let equation = &motion[i];
        let line = format!("{} = {}", writer.latex(&equation.left), writer.latex(&equation.right));
        writer.line(&line, &[&momentum_rate, &force], &[&equation.right]);
    }
    writer.heading("The energy");
    let names: Vec<String> = derivation_sum(writer, &slope);
    let value = derivation.equations(Quantity::Energy)?.remove(0).right;
    let latex = writer.latex(&value);
    writer.claim("means", &energy, json!("energy"));
    writer.say("The energy is the sum of momenta times rates, minus the Lagrangian.");
    let sum = names.join(" + ");
    let number = writer.line(&format!("{energy} = {sum} - {lagrangian} = {latex}"), &[&from], &[&value]);
    if applied.iter().any(Option::is_some) {
        writer.say("The given forces change the energy.");
    } else if writer.system.depends_on_time() {
        writer.say(format!("${lagrangian}$ depends on the time, so the energy is not conserved."));
    } else {
        writer.say(format!("${lagrangian}$ does not depend on the time, so the energy is conserved."));
        writer.line(&format!("{energy} = {latex} \\text{{ is constant}}"), &[&number], &[]);
    }
    if let Ok(found) = derivation.equations(Quantity::Hamiltonian)
        && let Some(found) = found.into_iter().next()
        && writer.latex(&found.right).len() < LONGEST
    {
        writer.claim("means", &hamiltonian, json!("Hamiltonian"));
        writer.say("As a function of coordinates and momenta it is the Hamiltonian.");
        let all: Vec<&str> = conjugate.iter().map(String::as_str).chain([number.as_str()]).collect();
        writer.line(&format!("{hamiltonian} = {}", writer.latex(&found.right)), &all, &[&found.right]);
    }
    Ok(())
}

/// The name of a coordinate as the system has it.
fn derivation_name(writer: &Writer<'_>, i: usize) -> String {
    writer.system.coordinates().get(i).cloned().unwrap_or_default()
}

/// q̇ ∂L/∂q̇ of each coordinate.
fn derivation_sum(writer: &Writer<'_>, slope: &dyn Fn(&str) -> String) -> Vec<String> {
    let rate = |i: usize| writer.latex(&writer.derivation.coordinate(i, 1));
    (0..writer.system.coordinates().len()).map(|i| format!("{} {}", rate(i), slope(&rate(i)))).collect()
}
