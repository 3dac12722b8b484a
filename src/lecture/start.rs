//! From the parts of a system to its Lagrangian.

use serde_json::json;

use super::writer::Writer;
use crate::Result;
use crate::derive::{BodyFormulas, ParticleFormulas, Quantity};
use crate::formula::{Expr, Node};

pub(super) fn write(writer: &mut Writer<'_>) -> Result<()> {
    let particles = writer.derivation.particles()?;
    let body = writer.derivation.body()?;
    let energies = writer.derivation.energies()?;
    let [name, ..] = writer.derivation.functions();
    let name = writer.latex(&name);
    writer.claim("means", &name, json!("Lagrangian"));
    let lagrangian = writer.derivation.equations(Quantity::Lagrangian)?.remove(0).right;
    let (kinetic, potential) = (writer.free(&["T", "K"]), writer.free(&["U", "V"]));
    let Some([of_motion, of_place]) = energies else {
        writer.heading("The Lagrangian");
        writer.say("The Lagrangian is given, and everything below follows from it.");
        writer.lagrangian = writer.given(&format!("{name} = {}", writer.latex(&lagrangian)), &[&lagrangian]);
        return Ok(());
    };
    writer.claim("means", &kinetic, json!("kinetic energy"));
    let from = match (particles.is_empty(), body) {
        (false, _) => Some(of_particles(writer, &particles, &kinetic)),
        (true, Some(body)) => of_body(writer, &body, &kinetic),
        (true, None) => None,
    };
    let energy = format!("{kinetic} = {}", writer.latex(&of_motion));
    match &from {
        Some(from) => {
            writer.say("In the coordinates and their rates this is");
            writer.line(&energy, &[from], &[&of_motion]);
        }
        None => {
            writer.heading("The Lagrangian");
            writer.say("The kinetic energy is");
            writer.given(&energy, &[&of_motion]);
        }
    }
    if matches!(&of_place.node, Node::Number(digits) if digits == "0") {
        writer.say("There is no potential energy, so the Lagrangian is the kinetic energy.");
        writer.lagrangian = writer.given(&format!("{name} = {kinetic}"), &[&lagrangian]);
        return Ok(());
    }
    writer.claim("means", &potential, json!("potential energy"));
    writer.say("The potential energy is");
    writer.given(&format!("{potential} = {}", writer.latex(&of_place)), &[&of_place]);
    writer.say("The Lagrangian is the difference of the two.");
    let definition = writer.given(&format!("{name} = {kinetic} - {potential}"), &[&lagrangian]);
    writer.say("Written out, it is");
    let written = format!("{name} = {}", writer.latex(&lagrangian));
    writer.lagrangian = writer.line(&written, &[&definition], &[&lagrangian]);
    Ok(())
}

/// Places, velocities and the kinetic energy; gives the number of the last.
fn of_particles(writer: &mut Writer<'_>, particles: &[ParticleFormulas], kinetic: &str) -> String {
    let letters: Vec<String> = [["x", "X"], ["y", "Y"], ["z", "Z"]].iter().map(|choice| writer.free(choice)).collect();
    let name = |k: usize, axis: usize| match particles.len() {
        1 => letters[axis].clone(),
        _ => format!("{}_{{{}}}", letters[axis], k + 1),
    };
    let axes = |particle: &ParticleFormulas| (0..3).filter(|&axis| particle.place[axis].is_some()).collect::<Vec<_>>();
    writer.heading("Places and velocities");
    writer.say(match particles.len() {
        1 => "The place of the point mass in Cartesian coordinates is",
        _ => "The places of the point masses in Cartesian coordinates are",
    });
    let mut places = Vec::new();
    for (k, particle) in particles.iter().enumerate() {
        let present: Vec<&Expr> = particle.place.iter().flatten().collect();
        let statement = |&axis: &usize| {
            let value = particle.place[axis].as_ref().map(|place| writer.latex(place));
            format!("{} = {}", name(k, axis), value.unwrap_or_default())
        };
        let statements: Vec<String> = axes(particle).iter().map(statement).collect();
        places.push(writer.given(&statements.join(" , \\quad "), &present));
    }
    writer.say("Their rates of change are the components of the velocity.");
    let mut rates = Vec::new();
    for (k, particle) in particles.iter().enumerate() {
        let own = axes(particle);
        let present: Vec<&Expr> = own.iter().map(|&axis| &particle.velocity[axis]).collect();
        let statement =
            |&axis: &usize| format!("\\dot{{{}}} = {}", name(k, axis), writer.latex(&particle.velocity[axis]));
        let statements: Vec<String> = own.iter().map(statement).collect();
        rates.push(writer.line(&statements.join(" , \\quad "), &[&places[k]], &present));
    }
    writer.heading("Energies and the Lagrangian");
    writer.say("The kinetic energy is half the mass times the square of the velocity.");
    let term = |(k, particle): (usize, &ParticleFormulas)| {
        let squares: Vec<String> = axes(particle).iter().map(|&axis| format!("\\dot{{{}}}^2", name(k, axis))).collect();
        format!("\\frac{{1}}{{2}} {} \\left({}\\right)", writer.factor(&particle.mass), squares.join(" + "))
    };
    let terms: Vec<String> = particles.iter().enumerate().map(term).collect();
    writer.given(&format!("{kinetic} = {}", terms.join(" + ")), &[])
}

/// The axes of a body, its angular velocity and its kinetic energy; gives the number of the last.
fn of_body(writer: &mut Writer<'_>, body: &BodyFormulas, kinetic: &str) -> Option<String> {
    const SPACE: [&str; 3] = ["\\hat x", "\\hat y", "\\hat z"];
    let moments = body.moments.as_ref()?;
    let vector = |writer: &Writer<'_>, components: &[Expr; 3]| {
        let mut sum = String::new();
        for (component, axis) in components.iter().zip(SPACE) {
            let text = match &component.node {
                Node::Number(digits) if digits == "0" => continue,
                Node::Sum(terms) if terms.len() > 1 => format!("\\left({}\\right)", writer.latex(component)),
                _ => writer.latex(component),
            };
            let text = match text.strip_prefix('-') {
                Some(opposite) if !sum.is_empty() => format!(" - {}", opposite.trim_start()),
                _ if sum.is_empty() => text,
                _ => format!(" + {text}"),
            };
            sum.push_str(&format!("{text} \\, {axis}"));
        }
        sum
    };
    writer.claim("axes", &SPACE.join(", "), json!("fixed"));
    writer.heading("The axes of the body");
    writer.say(
        "The body is turned by its three angles: the first turn about the third axis, the second about the second axis as \
         it now lies, the third about the third axis as it now lies. The product of the three turns gives the axes of the \
         body along axes at rest.",
    );
    let mut axes = Vec::new();
    for (a, components) in body.axes.iter().enumerate() {
        axes.push(writer.given(&format!("\\vec e_{} = {}", a + 1, vector(writer, components)), &[]));
    }
    writer.heading("Angular velocity");
    writer.say(
        "The angular velocity is the vector that turns each axis: the rate of an axis is the vector product of the two. So it \
         is half the sum of the products of each axis with its rate.",
    );
    let sum: Vec<String> = (1..=3).map(|a| format!("\\vec e_{a} \\times \\dot{{\\vec e}}_{a}")).collect();
    let definition = writer.given(&format!("\\vec\\omega = \\frac{{1}}{{2}} \\left({}\\right)", sum.join(" + ")), &[]);
    let from: Vec<&str> = axes.iter().map(String::as_str).chain([definition.as_str()]).collect();
    writer.say("Differentiating the axes gives its components along the axes at rest.");
    let along = format!("\\vec\\omega = {}", vector(writer, &body.space));
    writer.line(&along, &from, &body.space.iter().collect::<Vec<_>>());
    writer.say("Along the axes of the body its components are the products with these.");
    let products: Vec<String> = (1..=3).map(|a| format!("\\omega_{a} = \\vec\\omega \\cdot \\vec e_{a}")).collect();
    let products = writer.given(&products.join(" , \\quad "), &[]);
    let mut rates = Vec::new();
    for (a, component) in body.along.iter().enumerate() {
        let latex = format!("\\omega_{} = {}", a + 1, writer.latex(component));
        rates.push(writer.line(&latex, &[&definition, &products], &[component]));
    }
    writer.heading("Energies and the Lagrangian");
    writer.say("With the principal moments of the body, the kinetic energy is a sum of squares.");
    let terms: Vec<String> =
        moments.iter().zip(1..).map(|(moment, a)| format!("{} \\omega_{a}^2", writer.factor(moment))).collect();
    Some(writer.given(&format!("{kinetic} = \\frac{{1}}{{2}} \\left({}\\right)", terms.join(" + ")), &[]))
}
