//! Notes without a claims file whose words reject a formula, restore a unit, or give a value at another instant.

use crate::support::verdicts;

fn found(name: &str, notes: &str) -> Vec<String> {
    verdicts(&format!("unaided-rejected-{name}"), notes)
}

const PENDULUM: &str = r"Students often write

$$ T = 2\pi\sqrt{\frac{g}{l}} $$

for the period. This cannot be. We get

$$ \omega = \sqrt{\frac{g}{l}} $$

$$ T = \frac{2\pi}{\omega} = 2\pi\sqrt{\frac{l}{g}} $$
";

/// What the author calls wrong is no premise and no slip.
#[test]
fn a_formula_that_the_words_reject_is_neither_judged_nor_used() {
    let verdicts = found("pendulum", PENDULUM);
    assert_eq!(verdicts[0], "undecided");
    assert!(["certified", "verified"].contains(&verdicts[2].as_str()), "{verdicts:?}");
    // Without these words the two periods contradict each other.
    let plain = PENDULUM.replace("Students often write", "The period is").replace("This cannot be. We get", "We get");
    assert_ne!(found("pendulum-plain", &plain), verdicts);
    // A slip in what is not rejected is found.
    let wrong = PENDULUM.replace(r"= 2\pi\sqrt{\frac{l}{g}} $$", r"= 2\pi\sqrt{\frac{g}{l}} $$");
    assert!(!["certified", "verified"].contains(&found("pendulum-slip", &wrong)[2].as_str()));
}

/// A value at one instant is no identity: where both of its names stand in a display, this is about every instant.
#[test]
fn a_value_at_an_instant_does_not_hold_at_others() {
    let orbit = |law: &str| {
        format!(
            "$$ L = m r^2\\dot\\varphi $$\n\nWith $r = R$ and $\\dot\\varphi = \\omega_0$ at the beginning, \
             $L = mR^2\\omega_0$, so\n\n$$ \\dot\\varphi = {law} $$\n"
        )
    };
    let passes = |verdict: &str| ["certified", "verified"].contains(&verdict);
    assert!(passes(&found("orbit", &orbit(r"\omega_0\frac{R^2}{r^2}"))[1]));
    assert!(!passes(&found("orbit-slip", &orbit(r"\omega_0\frac{R}{r}"))[1]));
}

/// Where the notes set c to 1, an equation with c is in other units than those before it.
#[test]
fn what_restores_a_unit_is_not_called_wrong() {
    let notes = |set: &str| {
        format!(
            "{set} The energy is\n\n$$ E = \\gamma m, \\qquad p = \\gamma m v $$\n\nThen\n\n$$ \\frac{{pc}}{{E}} = \\frac vc $$\n"
        )
    };
    assert_ne!(found("units", &notes("We set $c = 1$ from here on."))[1], "refuted");
    assert_eq!(found("no-units", &notes("We begin."))[1], "refuted");
}

/// Small numbers may be plain numbers; a time may not.
#[test]
fn a_name_that_may_be_a_plain_number_makes_no_conflict_of_dimensions() {
    let notes = "The two small numbers are $\\alpha$ and $\\beta$.\n\n$$ F = \\alpha P $$\n\n$$ G = \\beta P $$\n\n\
                 $$ V = V_0(1+\\alpha)(1+\\beta) $$\n\n$$ \\alpha + \\beta = \\delta $$\n";
    assert!(found("small", notes).iter().all(|verdict| verdict != "refuted"));
    let polar = r"$$ T = \frac12 m(\dot x^2 + \dot y^2) $$

In polar coordinates $x = r\cos\varphi$, $y = r\sin\varphi$:

$$ \dot x = \dot r\cos\varphi - r\dot\varphi\sin\varphi $$

$$ \dot y = \dot r\sin\varphi + r\dot\varphi\cos\varphi $$

$$ T = \frac12 m(\dot r^2 + r\dot\varphi^2) $$
";
    assert_eq!(found("polar", polar)[3], "refuted");
}

/// A true definition is not blamed for a slip in the display that uses it.
#[test]
fn a_definition_is_not_called_wrong_where_its_consequence_may_be() {
    let fall = |rate: &str| format!("$$ s = v_0 t + \\frac12 a t^2 $$\n\n$$ \\dot s = v_0 + {rate} $$\n");
    assert_eq!(found("rate", &fall("a t"))[1], "certified");
    let verdicts = found("rate-slip", &fall(r"\frac12 a t"));
    assert!(verdicts[0] != "refuted" && verdicts[1] != "certified", "{verdicts:?}");
}

/// A solution of the equation of motion that does not start where the notes say is wrong; one of constants that are still open is not.
#[test]
fn a_solution_starts_where_the_notes_say() {
    let fall = |solution: &str| {
        format!(
            "$$ m \\dot v = m g - k v $$\n\nWith $v(0) = 0$,\n\n$$ v = \\frac{{mg}}{{k}}\\left({solution}\\right) $$\n"
        )
    };
    assert_eq!(found("fall", &fall("1 - e^{-k t/m}"))[1], "certified");
    assert_eq!(found("fall-slip", &fall("1 + e^{-k t/m}"))[1], "refuted");
    let oscillator = |general: &str, special: &str| {
        format!(
            "$$ \\ddot x = -\\omega^2 x $$\n\n{general}with $x(0) = x_0$ and $\\dot x(0) = v_0$:\n\n$$ x = {special} $$\n\n\
             If instead $x(0) = 0$,\n\n$$ x = \\frac{{v_0}}{{\\omega}}\\sin\\omega t $$\n"
        )
    };
    let general = "The general solution is\n\n$$ x = A\\cos\\omega t + B\\sin\\omega t $$\n\n";
    let special = r"x_0\cos\omega t + \frac{v_0}{\omega}\sin\omega t";
    let right = found("oscillator", &oscillator(general, special));
    assert_eq!(right[1..], ["certified", "certified", "certified"], "{right:?}");
    let wrong = found("oscillator-slip", &oscillator(general, r"x_0\cos\omega t - \frac{v_0}{\omega}\sin\omega t"));
    assert_eq!(wrong[2], "refuted", "{wrong:?}");
}

/// Another formula for a name is no slip for one in which a factor cancels.
#[test]
fn an_edit_whose_factor_cancels_is_none() {
    let sound = |second: &str| {
        format!(
            "Newton used the isothermal value\n\n$$ c = \\sqrt{{\\frac{{p}}{{\\rho}}}} $$\n\nLaplace noticed that the \
             compression is adiabatic, and so\n\n$$ c = {second} $$\n"
        )
    };
    assert_eq!(found("sound", &sound(r"\sqrt{\frac{\gamma p}{\rho}}"))[1], "assumed");
    // Which of two formulas with one fraction turned over is wrong, nobody can tell.
    assert_eq!(found("sound-slip", &sound(r"\sqrt{\frac{\rho}{p}}"))[1], "undecided");
}

/// A start is that of one solution. What is printed after it may be about another motion.
#[test]
fn a_start_is_used_up_by_its_solution() {
    let stone = |first: &str| {
        format!(
            "$$ m v_0 = p $$\n\n$$ \\dot v = -g $$\n\nThe stone is dropped, $v(0) = 0$:\n\n$$ v = {first} $$\n\n\
             Thrown upwards it has\n\n$$ v = v_0 - gt $$\n"
        )
    };
    let right = found("stone", &stone("-gt"));
    assert_eq!(right[2..], ["certified", "certified"], "{right:?}");
    // The twin: directly after the start it is not its solution.
    assert_eq!(found("stone-slip", &stone("v_0 - gt"))[2], "undecided");
}
