//! Units: what nobody declared is inferred, and the term that does not fit is named before any number is computed.

use std::path::Path;
use std::sync::Arc;

use onshell::check::document::units::conflicts;
use onshell::check::model::Model;
use onshell::formula::symbols::{Kind, Name, Symbols};
use onshell::formula::units::{Affine, Dimension, UnitCheck, parse};
use onshell::formula::{Expr, Node};
use onshell::latex::{Macros, names, read_display};
use onshell::notes::Claims;
use onshell::source::{Source, Span};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

/// The claims of a document about the heavy symmetric top, to be completed.
fn top() -> Json {
    json!({
        "system": "heavy_top",
        "coordinates": { r"\theta": "(0, \\pi)", r"\phi, \psi": "angle" },
        "constants": { r"M, g, R, \lambda_1, \lambda_3": "> 0" },
        "means": { "L": "Lagrangian", "T": "kinetic energy", "U": "potential energy", "H": "Hamiltonian" },
        "define": { r"\Omega": r"\dot\phi", r"\omega_3": r"p_\psi/\lambda_3" },
    })
}

/// The term that does not fit, as printed, and what is said of it, for each conflict in these displays.
fn terms(claims: &Json, units: &[(&str, &str)], displays: &[&str]) -> Vec<(String, String)> {
    let claims = Arc::new(Source::new("claims.json", {
        let mut claims = claims.clone();
        claims["notes"] = json!("notes.md");
        claims.to_string()
    }));
    let claims = Claims::parse(claims, Path::new("claims.json")).unwrap();
    let mut model = Model::new(&claims, Macros::default(), &Registry::standard()).unwrap();
    // What the claims file defines is read where the document is.
    for (name, formula) in &claims.define {
        let display = format!("{} = {}", name.value, formula.value);
        for introduced in read_display(&display, &mut model.symbols, &Macros::default()).introduced {
            model.define(introduced.symbol, introduced.formula);
        }
    }
    let mut readings = Vec::new();
    for display in displays {
        let reading = read_display(display, &mut model.symbols, &Macros::default());
        for statement in &reading.statements {
            assert!(statement.is_ok(), "{display}: {statement:?}");
        }
        for introduced in &reading.introduced {
            model.define(introduced.symbol, introduced.formula.clone());
        }
        readings.push(reading);
    }
    let declared: Vec<_> = units
        .iter()
        .map(|(name, unit)| (model.symbols.find(&names::parse(name).unwrap().0).unwrap().0, parse(unit).unwrap()))
        .collect();
    let found = conflicts(&model, &declared, &readings);
    found.into_iter().map(|c| (displays[c.display][c.span.range()].to_owned(), c.message)).collect()
}

#[track_caller]
fn fits(claims: &Json, units: &[(&str, &str)], displays: &[&str]) {
    assert_eq!(terms(claims, units, displays), []);
}

/// The one term that does not fit, whose message has these words.
#[track_caller]
fn names_the_term(claims: &Json, units: &[(&str, &str)], displays: &[&str], term: &str, words: &[&str]) {
    match terms(claims, units, displays).as_slice() {
        [(found, message)] => {
            assert_eq!(found, term, "{message}");
            for word in words {
                assert!(message.contains(word), "“{word}” is in not in: {message}");
            }
        }
        other => panic!("{displays:?}: not one conflict: {other:?}"),
    }
}

/// All that is declared of the top: the momenta, the energies and the rates are inferred.
const TOP: [(&str, &str); 5] =
    [(r"\lambda_1", "kg m^2"), (r"\lambda_3", "kg m^2"), ("M", "kg"), ("g", "m/s^2"), ("R", "m")];

const LAGRANGIAN: &str = r"L = T - U = \frac12 \left( \lambda_1 (\dot\theta^2 + (\dot\phi \sin\theta)^2) + \lambda_3 (\dot\psi + \dot\phi\cos\theta)^2 \right) - MgR\cos\theta";
const MOMENTUM: &str = r"\frac{d}{dt} \left( \lambda_3 (\dot\psi + \dot\phi\cos\theta) \right) = 0 \Rightarrow p_\psi = \lambda_3 (\dot\psi + \dot\phi \cos\theta)";
const MOTION: &str = r"\lambda_1 \ddot\theta = \lambda_1 \dot\phi^2 \sin\theta\cos\theta - \dot\phi \sin\theta \, p_\psi + MgR \sin\theta";
const STEADY: &str = r"\lambda_1 \Omega^2 \cos\theta - \lambda_3 \Omega \omega_3 + MgR = 0";
const RATES: &str = r"\Omega_\pm = \frac{\lambda_3\omega_3 \pm \sqrt{(\lambda_3\omega_3)^2 - 4MgR\lambda_1\cos\theta}}{2\lambda_1\cos\theta}";
const FAST: &str = r"\Omega_+ \approx \frac{\lambda_3\omega_3}{\lambda_1\cos\theta}";
const HAMILTONIAN: &str = r"H = p_\theta\dot\theta + p_\psi\dot\psi + p_\phi\dot\phi - L = \frac{p_\theta^2}{2\lambda_1} + \frac{p_\psi^2}{2\lambda_3} + \frac{(p_\phi - p_\psi\cos\theta)^2}{2\lambda_1\sin^2\theta} + MgR\cos\theta";

/// The display with one slip in it.
fn slip(display: &str, printed: &str, read: &str) -> String {
    assert!(display.contains(printed), "{printed} is not in {display}");
    display.replacen(printed, read, 1)
}

#[test]
fn the_equations_of_the_top_are_consistent() {
    let all = [LAGRANGIAN, MOMENTUM, MOTION, STEADY, RATES, FAST, HAMILTONIAN];
    fits(&top(), &TOP, &all);
    // Each by itself too; (6.76) speaks of what (6.75) introduces.
    all.iter().filter(|alone| **alone != FAST).for_each(|alone| fits(&top(), &TOP, &[*alone]));
}

#[test]
fn a_lost_factor_a_lost_dot_a_lost_power_are_each_named() {
    for (display, printed, read, term, unit) in [
        (LAGRANGIAN, "MgR", "Mg", r"Mg\cos\theta", "kg m s⁻²"),
        (LAGRANGIAN, r"\lambda_3 (", "(", r"(\dot\psi + \dot\phi\cos\theta)^2", "s⁻²"),
        (LAGRANGIAN, r"(\dot\theta^2 ", r"(\theta^2 ", r"(\dot\phi \sin\theta)^2", "dimensionless"),
        (LAGRANGIAN, r"\cos\theta)^2", r"\cos\theta)", r"\lambda_3 (\dot\psi + \dot\phi\cos\theta)", "kg m² s⁻¹"),
        (MOTION, "MgR", "Mg", r"Mg \sin\theta", "kg m s⁻²"),
        (MOTION, r"\ddot\theta", r"\dot\theta", r"\lambda_1 \dot\theta", "kg m² s⁻¹"),
        (MOTION, r"\dot\phi^2", r"\dot\phi", r"\lambda_1 \dot\phi \sin\theta\cos\theta", "kg m² s⁻¹"),
        (STEADY, "MgR", "MR", "MR", "kg m"),
        (STEADY, r"\Omega^2", r"\Omega", r"\lambda_1 \Omega \cos\theta", "kg m² s⁻¹"),
        (HAMILTONIAN, r"{p_\psi^2}", r"{p_\psi}", r"\frac{p_\psi}{2\lambda_3}", "s⁻¹"),
        (HAMILTONIAN, "MgR", "MgR^2", r"MgR^2\cos\theta", "kg m³ s⁻²"),
        (HAMILTONIAN, r"p_\phi\dot\phi", r"p_\phi\phi", r"p_\phi\phi", "kg m² s⁻¹"),
    ] {
        // The momenta are known from (6.72) and the definition of the rate of spin.
        let momenta = r"p_\phi = \lambda_1 \dot\phi\sin^2\theta + \cos\theta\,p_\psi";
        let wrong = slip(display, printed, read);
        names_the_term(&top(), &TOP, &[MOMENTUM, momenta, &wrong], term, &[unit, "they cannot"]);
    }
}

#[test]
fn the_message_says_what_cannot_be_done() {
    let say = |display: &str, words: &str| {
        let found = terms(&top(), &TOP, &[display]);
        assert!(found.len() == 1 && found[0].1.contains(words), "{found:?}");
    };
    say(r"M R + g = 0", "“M·R” is in kg m and “g” is in m s⁻², so they cannot be added");
    say(r"M R = g", "“M·R” is in kg m and “g” is in m s⁻², so they cannot be equal");
    say(r"R < g", "“R” is in m and “g” is in m s⁻², so they cannot be compared");
    say(r"M = g R + R g", "they cannot stand in one equation");
    say(r"\sin R = 0", "“R” is in m, but the argument of sin must be dimensionless");
    say(r"2^M > 1", "“M” is in kg, but an exponent must be dimensionless");
    say(r"R^\theta = 1", "“R” is in m, but the base of a power whose exponent is not a number must be dimensionless");
    say(r"R = 3", "“3” is dimensionless");
    fits(
        &top(),
        &TOP,
        &[r"R = 0", r"M R + 0 = 0", r"\sin\frac{R \dot\theta^2}{g} = 0", r"2^{\theta} > 1", r"R \propto g"],
    );
}

fn letters() -> Json {
    json!({ "constants": { "a, b, c": "> 0" }, "varies with time": { "x, y, z, w": "any" } })
}

#[test]
fn what_is_inferred_in_one_equation_is_used_in_the_next() {
    let units = [("x", "m"), ("a", "kg")];
    let chain = [r"y = \dot x", r"z = a y^2", r"z = w y"];
    fits(&letters(), &units, &[chain[0], chain[1], chain[2], r"w = a y"]);
    names_the_term(&letters(), &units, &[chain[0], chain[1], chain[2], r"w = a x"], "a x", &["kg m s⁻¹", "kg m"]);
    // Backwards as well: elimination does not mind the order.
    fits(&letters(), &units, &[chain[2], chain[1], chain[0], r"w = a y"]);
    assert!(!terms(&letters(), &units, &[chain[2], chain[1], chain[0], r"w = a x"]).is_empty());
    // Two unknowns that only two equations together settle: b c is m and b/c is m³.
    let two = [r"b c = x", r"\frac{b}{c} = x^3"];
    fits(&letters(), &units, &[two[0], two[1], r"b = x^2"]);
    names_the_term(&letters(), &units, &[two[0], two[1], r"b = x"], "x", &["“b” is in m²"]);
    // Nothing is said of what nothing is known of.
    fits(&letters(), &units, &[r"b c = z"]);
}

#[test]
fn terms_that_agree_in_pairs_and_not_together_do_not_agree() {
    let mut symbols = Symbols::new();
    let [_, x] = ["u", "x"].map(|name| symbols.add(Name::plain(name), Kind::Scalar).unwrap());
    let mut messages = |display: &str| -> Vec<String> {
        let reading = read_display(display, &mut symbols, &Macros::default());
        let mut survey = UnitCheck::new(&symbols);
        survey.inference.require_equal(&Affine::of(x), &Affine::known(Dimension::LENGTH)).unwrap();
        survey.statement(reading.statements[0].as_ref().unwrap()).into_iter().map(|found| found.message).collect()
    };
    // u is dimensionless by itself, or the root of a length: never both.
    assert_eq!(messages("u + u^2 = 0"), [""; 0]);
    assert_eq!(messages("u^2 + x = 0"), [""; 0]);
    assert_eq!(messages("u + u^2 + x = 0"), ["“u” is dimensionless and “x” is in m, so they cannot be added"]);
    // A sum within a sum is told by itself.
    assert_eq!(messages("(x + 1) x = 0"), ["“x” is in m and “1” is dimensionless, so they cannot be added"]);
    assert_eq!(messages(r"u (x^2 + x) = \sin x").len(), 2);
}

#[test]
fn a_root_halves_the_exponents() {
    let units = [("x", "m"), ("a", "m/s^2")];
    fits(&letters(), &units, &[r"\dot x = \sqrt{2 a x}", r"\dot x = (2 a x)^{1/2}", r"y = x^{\frac12}", r"y^2 = x"]);
    names_the_term(&letters(), &units, &[r"\dot x = \sqrt{2 a}"], r"\sqrt{2 a}", &["m^(1/2) s⁻¹"]);
    names_the_term(&letters(), &units, &[r"y = x^{1/2}", r"y = x"], "x", &["“y” is in m^(1/2)"]);
    fits(&letters(), &units, &[r"x = \sqrt[3]{x^3}"]);
    assert_eq!(terms(&letters(), &units, &[r"x = \sqrt[3]{x^2}"]).len(), 1);
}

#[test]
fn exponents_that_leave_the_numbers_conclude_nothing() {
    let tower = "((((x^{999999999999})^{999999999999})^{999999999999})^{999999999999}) = x";
    fits(&letters(), &[("x", "m")], &[tower]);
}

#[test]
fn the_planet_obeys_the_unit_of_newtons_constant() {
    let planet = json!({
        "system": "kepler",
        "coordinates": { "r": "> 0", r"\phi": "angle" },
        "constants": { "m, G, M": "> 0", r"a, e_0": "> 0" },
    });
    let units = [("G", "m^3 kg^-1 s^-2"), ("M, m", "kg")];
    let units = [units[0], ("M", units[1].1), ("m", "kg")];
    let radial = r"\ddot r - r \dot\phi^2 = -\frac{GM}{r^2}";
    fits(
        &planet,
        &units,
        &[radial, r"p_\phi = m r^2 \dot\phi", r"\dot\phi^2 a^3 = G M", r"r = \frac{a(1 - e_0^2)}{1 + e_0\cos\phi}"],
    );
    // That r is a length is inferred from G.
    names_the_term(
        &planet,
        &units,
        &[radial, r"\frac{\dot r^2}{2} = \frac{GM}{r^2}"],
        r"\frac{GM}{r^2}",
        &["m² s⁻²", "m s⁻²"],
    );
    names_the_term(&planet, &units, &[radial, r"\sin r = 1"], "r", &["“r” is in m, but the argument of sin"]);
    assert_eq!(terms(&planet, &units, &[radial, r"\dot\phi^2 a^2 = G M", r"a = r"]).len(), 1);
}

#[test]
fn a_matrix_of_rotation_has_no_unit_and_a_family_has_one() {
    let body = json!({
        "system": "free_rigid_body",
        "coordinates": { r"\theta": "(0, \\pi)", r"\phi, \psi": "angle" },
        "constants": { r"\lambda_1, \lambda_2, \lambda_3": "> 0", "h": "> 0" },
        "indices": { "a, b, c": "1..3" },
        "rotations": { r"\mathbf{R}_z": "of the axes" },
        "means": { r"\mathbf{R}": "rotation matrix", r"\vec\omega": "angular velocity", r"\omega_a": "angular velocity",
                   r"\hat e_a": "body axes" },
    });
    let units = [(r"\lambda_1", "kg m^2"), ("h", "m")];
    fits(
        &body,
        &units,
        &[r"\mathbf{R} = \mathbf{R}_z(\psi)", r"\dot{\hat e}_a = \vec\omega \times \hat e_a", r"\omega_1 = \dot\theta"],
    );
    names_the_term(&body, &units, &[r"\mathbf{R} = h \mathbf{R}_z(\psi)"], r"h \mathbf{R}_z(\psi)", &["is in m,"]);
    names_the_term(&body, &units, &[r"\mathbf{R}_z(h) = 1"], "h", &["the angle of a rotation"]);
    names_the_term(
        &body,
        &units,
        &[r"\omega_1 = \dot\theta", r"\omega_2 = \ddot\theta"],
        r"\ddot\theta",
        &["s⁻¹", "s⁻²"],
    );
    let turning = r"\dot{\hat e}_a = \vec\omega \times \hat e_a";
    names_the_term(&body, &units, &[turning, r"\vec\omega \cdot \hat e_1 = h"], "h", &["s⁻¹", "“h” is in m"]);
    let entries = |corner: &str| {
        format!(r"\mathbf{{R}} = \begin{{pmatrix}} 1 & 0 & 0 \\ 0 & {corner} & 0 \\ 0 & 0 & 1 \end{{pmatrix}}")
    };
    fits(&body, &units, &[&entries(r"\frac hh")]);
    names_the_term(&body, &units, &[&entries("h")], "h", &["they cannot be entries of one matrix"]);
}

#[test]
fn an_integral_multiplies_by_its_region() {
    let mut symbols = Symbols::new();
    let [region, density, mass] = ["V", r"\rho", "m"].map(|name| symbols.add(Name::plain(name), Kind::Scalar).unwrap());
    let span = Span::default();
    let symbol = |id| Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, span);
    let integral = Expr::new(Node::Integral(region, Box::new(symbol(density))), span);
    let mut survey = UnitCheck::new(&symbols);
    for (id, unit) in [(region, "m^3"), (density, "kg/m^3")] {
        survey.inference.require_equal(&Affine::of(id), &Affine::known(parse(unit).unwrap())).unwrap();
    }
    let found = survey.dimension(&integral).unwrap().unwrap();
    assert!(survey.inference.clone().require_equal(&found, &Affine::known(parse("kg").unwrap())).is_ok());
    assert!(survey.inference.clone().require_equal(&found, &Affine::known(parse("kg/m").unwrap())).is_err());
    // And so the mass that is equal to it is found.
    survey.inference.require_equal(&Affine::of(mass), &found).unwrap();
    assert_eq!(survey.words(&Affine::of(mass)), "kg");
}
