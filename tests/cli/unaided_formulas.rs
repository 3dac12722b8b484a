//! Notes without a claims file that differentiate or integrate names whose formulas are printed, though nothing defines these.

use crate::support::verdicts;

fn found(name: &str, notes: &str) -> Vec<String> {
    verdicts(&format!("unaided-formula-{name}"), notes)
}

fn passes(verdict: &str) -> bool {
    ["certified", "verified"].contains(&verdict)
}

/// Of these notes the display at a place passes, and with a slip in it it is wrong; no other display is.
fn found_in(name: &str, notes: &str, at: usize, (printed, slip): (&str, &str)) {
    assert_eq!(notes.matches(printed).count(), 1, "{printed}");
    let right = found(name, notes);
    assert!(passes(&right[at]), "{name}: {right:?}");
    assert!(right.iter().all(|verdict| verdict != "refuted"), "{name}: {right:?}");
    let wrong = found(&format!("{name}-slip"), &notes.replace(printed, slip));
    let refuted: Vec<usize> = (0..wrong.len()).filter(|at| wrong[*at] == "refuted").collect();
    assert_eq!(refuted, [at], "{name}: {wrong:?}");
}

#[test]
fn a_field_is_the_derivative_of_an_approximate_potential() {
    let notes = r"The potential of two opposite charges, far from them:

$$ V \approx \frac{q}{4\pi\varepsilon_0}\frac{a \cos\theta}{r^2} = \frac{k \cos\theta}{r^2} $$

Its field along the radius is

$$ E_r = -\frac{\partial V}{\partial r} = \frac{2 k \cos\theta}{r^3} $$

and across it

$$ E_\theta = -\frac1r \frac{\partial V}{\partial\theta} = \frac{k \sin\theta}{r^3} $$
";
    found_in("field", notes, 1, (r"\frac{2 k \cos\theta}{r^3}", r"\frac{k \cos\theta}{r^3}"));
    found_in("field-across", notes, 2, (r"\frac{k \sin\theta}{r^3}", r"\frac{k \cos\theta}{r^3}"));
}

#[test]
fn the_pressure_that_an_equation_of_state_gives_is_differentiated_at_a_fixed_temperature() {
    let notes = r"A gas obeys

$$ \left(p + \frac{a}{v^2}\right)(v - b) = R T $$

that is

$$ p = \frac{R T}{v - b} - \frac{a}{v^2} $$

Its slope along an isotherm is

$$ \left(\frac{\partial p}{\partial v}\right)_T = -\frac{R T}{(v - b)^2} + \frac{2 a}{v^3} $$
";
    found_in("gas", notes, 2, (r"\frac{2 a}{v^3}", r"\frac{a}{v^3}"));
    // What is held does not stand in the formula of p: another derivative.
    let other = found("gas-other", &notes.replace(r"\right)_T", r"\right)_S"));
    assert_eq!(other[2], "definition", "{other:?}");
}

const CHARGING: &str = r"A battery of the emf $U$ charges a capacitor:

$$ U = R \frac{dq}{dt} + \frac{q}{C} \tag{1} $$

With $q(0)=0$ the solution is

$$ q = C U \left(1 - e^{-t/(RC)}\right) \tag{2} $$

After the time $t_h = R C \ln 2$ one half has flowed:

$$ q(t_h) = \frac12 C U \tag{3} $$

The current $I = \frac{dq}{dt}$ heats the wire by

$$ Q = \int_0^\infty R I^2\,dt = \frac12 C U^2 \tag{4} $$
";

#[test]
fn a_solution_gives_its_value_at_an_instant_and_the_integral_of_its_rate() {
    found_in("charging", CHARGING, 2, (r"q(t_h) = \frac12 C U", r"q(t_h) = \frac13 C U"));
    found_in("heat", CHARGING, 3, (r"\frac12 C U^2", r"\frac14 C U^2"));
}

#[test]
fn a_rate_beside_its_solution_is_a_claim() {
    let notes = r"In the circuit

$$ L \frac{dI}{dt} + \frac{Q}{C} = 0, \qquad I = \frac{dQ}{dt} $$

So

$$ \ddot Q + \omega^2 Q = 0 \quad\text{with}\quad \omega = \frac{1}{\sqrt{LC}} $$

The solution with $Q(0) = Q_0$ and $I(0) = 0$ is

$$ Q = Q_0 \cos\omega t, \qquad I = -\omega Q_0 \sin\omega t $$
";
    found_in("circuit", notes, 2, (r"I = -\omega Q_0 \sin\omega t", r"I = -\omega Q_0 \cos\omega t"));
}

#[test]
fn a_wave_moves_with_its_own_velocity() {
    let notes = r"On a string

$$ \mu \frac{\partial^2 y}{\partial t^2} = F \frac{\partial^2 y}{\partial x^2} $$

runs the wave

$$ y = A \sin(k x - \omega t) $$

and its points have the velocity

$$ \frac{\partial y}{\partial t} = -\omega A \cos(k x - \omega t) $$
";
    found_in("wave", notes, 2, (r"-\omega A \cos", r"\omega A \cos"));
}

/// A formula whose constant part is taken away has an integral to infinity; with the constant it has none.
#[test]
fn what_cools_down_loses_a_finite_heat() {
    let notes = r"Newton's law of cooling,

$$ \frac{dT}{dt} = -k (T - T_a) $$

With $T(0) = T_0$ we have

$$ T = T_a + (T_0 - T_a) e^{-k t} $$

The rate at the beginning is

$$ \dot T(0) = -k (T_0 - T_a) $$

and the heat that is lost in all

$$ Q = C \int_0^\infty k (T - T_a)\,dt = C (T_0 - T_a) $$
";
    found_in(
        "rate",
        notes,
        2,
        (
            r"-k (T_0 - T_a) $$

and",
            "-k (T_0 + T_a) $$\n\nand",
        ),
    );
    found_in("cooling", notes, 3, (r"= C (T_0 - T_a)", r"= 2 C (T_0 - T_a)"));
    assert!(!passes(&found("cooling-all", &notes.replace(r"k (T - T_a)\,dt", r"k T\,dt"))[3]));
}

/// In two cases a name has two formulas, and nothing says of which the derivative is taken.
#[test]
fn a_name_with_two_formulas_has_no_derivative() {
    let ball = |outside: &str, field: &str| {
        let notes = format!(
            "The energy of a charge is\n\n$$ U = q V $$\n\nInside the ball the potential is\n\n\
             $$ V = \\frac{{k r^2}}{{2}} $$\n\n{outside}The field is\n\n\
             $$ E_r = -\\frac{{\\partial V}}{{\\partial r}} = {field} $$\n"
        );
        found("ball", &notes).pop().expect("a verdict")
    };
    assert!(passes(&ball("", "-k r")));
    assert_eq!(ball("", "-2 k r"), "refuted");
    for field in ["-k r", "-2 k r"] {
        assert_eq!(ball("and outside\n\n$$ V = \\frac{c}{r} $$\n\n", field), "undecided", "{field}");
    }
}

/// An integral whose integrand is a name with a formula is computed, and a slip in its value is found.
#[test]
fn the_value_of_an_integral_is_no_triviality() {
    let sphere = |value: &str| found("sphere", &format!(r"$$ \int_0^R 4\pi r^2\,dr = {value} $$"));
    assert!(passes(&sphere(r"\frac43\pi R^3")[0]));
    assert_eq!(sphere(r"\frac43\pi R^2"), ["refuted"]);
    assert_eq!(sphere(r"\frac34\pi R^3"), ["refuted"]);
}

#[test]
fn what_cannot_be_computed_is_taken_for_granted_and_defines_nothing() {
    for notes in [
        r"$$ \sum_{n=1}^\infty \frac{1}{n^2} = \frac{\pi^2}{8} $$",
        r"$$ \lim_{x \to 0} \frac{\sin x}{x} = 2 $$",
        r"$$ \int \cos^2 x\,dx = \frac x2 + \frac{\sin 2x}{2} + C $$",
    ] {
        assert_eq!(found("computed", notes), ["assumed"], "{notes}");
    }
    // must-fail case: a name is defined.
    assert_eq!(found("computed-not", r"$$ S = \frac{\pi^2}{8} a $$"), ["definition"]);
}

/// Relations of several coordinates at once are no formulas of a curve.
#[test]
fn what_follows_from_nothing_stays_so_beside_a_formula() {
    let notes = "$$ x + y = 1 $$\n\n$$ y = x^2 $$\n\n$$ x^2 + y^2 = r^2 $$\n\n$$ ds^2 = dx^2 + dy^2 $$\n";
    assert!(found("line", notes).iter().all(|verdict| verdict != "refuted"));
}

#[test]
fn a_logarithm_with_its_base_is_read() {
    let sum = |sign: &str| found("log", &format!(r"$$ \log_{{10}}(a b) = \log_{{10}}(a) {sign} \log_{{10}}(b) $$"));
    assert!(passes(&sum("+")[0]), "{:?}", sum("+"));
    assert_eq!(sum("-"), ["refuted"]);
    // Without a base nobody knows which logarithm it is.
    assert_eq!(found("log-none", r"$$ \log(a b) = \log(a) - \log(b) $$"), ["definition"]);
}
