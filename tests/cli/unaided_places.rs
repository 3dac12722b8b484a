//! Notes without a claims file: the places where a quantity is largest, its values at places, and dimensions.

use crate::support;

/// The verdict of each display of notes.
fn verdicts(name: &str, notes: &str) -> Vec<String> {
    support::verdicts(&format!("places-{name}"), notes)
}

const RESONANCE: &str = r"The amplitude is

$$ X = \frac{F}{m\sqrt{(w^2 - \omega^2)^2 + 4\gamma^2\omega^2}} . $$

It is largest at

$$ \omega_r^2 = w^2 - 2\gamma^2 , $$

and there it has the value

$$ X_{\max} = \frac{F}{2 m\gamma\sqrt{w^2 - \gamma^2}} . $$
";

#[test]
fn a_quantity_has_no_slope_where_it_is_largest() {
    assert_eq!(verdicts("resonance", RESONANCE), ["definition", "verified", "verified"]);
    let slip = RESONANCE.replace(r"w^2 - 2\gamma^2 ,", r"w^2 - \gamma^2 ,");
    assert_eq!(verdicts("resonance-slip", &slip)[1], "refuted");
    let value = RESONANCE.replace(r"\frac{F}{2 m", r"\frac{F}{4 m");
    assert_eq!(verdicts("resonance-value", &value)[1..], ["verified", "refuted"]);
    // Without the words it is a definition.
    let other = slip.replace("It is largest at", "We write");
    assert_eq!(verdicts("resonance-words", &other)[1], "definition");
}

#[test]
fn what_no_single_edit_makes_a_maximum_is_no_slip() {
    let other = RESONANCE.replace(r"w^2 - 2\gamma^2 ,", r"\frac{F}{m} + \gamma^2 ,");
    assert_ne!(verdicts("resonance-other", &other)[1], "refuted");
}

const POWER: &str = r"A flow $Q$ is measured; it is

$$ Q = a\sqrt{2 g (b - c)} . $$

The power on the wheel is

$$ P(u) = \rho Q u (v - u) (1 - \cos\vartheta) . $$

The derivative vanishes at $u = v/2$, and there

$$ P_{\max} = \frac14 \rho Q v^2 (1 - \cos\vartheta) . $$

For $\vartheta = \pi$ this is

$$ P_{\max} = \frac12 \rho Q v^2 . $$
";

#[test]
fn a_value_may_be_that_of_a_name_that_has_one() {
    // Q has no value where b < c, and the states in which it has one decide.
    assert_eq!(verdicts("power", POWER)[2..], ["verified", "verified"]);
    let first = POWER.replace(r"\frac14 \rho", r"\frac12 \rho");
    assert_eq!(verdicts("power-slip", &first)[2], "refuted");
    let second = POWER.replace(r"\frac12 \rho", r"\frac13 \rho");
    assert_eq!(verdicts("power-second", &second)[3], "refuted");
}

const GAS: &str = r"The gas has

$$ \left( p + \frac{a}{v^2} \right) (v - b) = R T $$

$$ u = c T - \frac{a}{v} $$

$$ p = \frac{R T}{v - b} - \frac{a}{v^2} $$

$$ h = u + p v $$

and with another constant

$$ k = c + \frac{R}{1 - \frac{2 a (v - b)^2}{R T v^3}} $$
";

#[test]
fn a_power_that_is_lost_spoils_the_dimensions() {
    assert!(!verdicts("gas", GAS).contains(&"refuted".to_owned()));
    assert_eq!(verdicts("gas-slip", &GAS.replace("(v - b)^2}", "(v - b)}")).pop().as_deref(), Some("refuted"));
}

const DRAG: &str = r"With friction

$$ m\dot v = - c v + f $$

$$ w = \frac{f}{c} $$

$$ v = w\left( 1 - e^{-c t/m} \right) $$

$$ s = u t $$

$$ x = w\left[ t - \frac{m}{c}\left( 1 - e^{-c t/m} \right) \right] $$
";

#[test]
fn a_fraction_that_is_turned_over_spoils_the_dimensions() {
    assert!(!verdicts("drag", DRAG).contains(&"refuted".to_owned()));
    let turned = DRAG.replace(r"\frac{m}{c}\left(", r"\frac{c}{m}\left(");
    assert_eq!(verdicts("drag-turned", &turned)[4], "refuted");
}

const CART: &str = r"The bob moves with

$$ E = \frac12 M\dot x^2 + m\ell\dot x\dot\theta\cos\theta + \frac12 m\ell^2\dot\theta^2 - m g\ell\cos\theta $$

$$ M\ell\ddot\theta + (M + m) g\theta = 0 $$

$$ x = - \frac{m\ell}{M + m}\theta $$

$$ p = M\dot x + m\ell\dot\theta\cos\theta $$

and the matrix

$$ A = \begin{pmatrix} M + m & m\ell \\ m\ell & m\ell^2 \end{pmatrix} $$
";

#[test]
fn a_matrix_says_nothing_of_dimensions() {
    assert!(!verdicts("cart", CART).contains(&"refuted".to_owned()));
    assert_eq!(verdicts("cart-slip", &CART.replace(r"\ell^2\dot\theta^2 -", r"\ell\dot\theta^2 -"))[0], "refuted");
}

#[test]
fn a_value_of_a_quantity_has_its_dimension() {
    let throw = |power: u32| {
        format!(
            "$$ \\ddot x = 2 w g t $$\n\n$$ \\dot z = u - g t $$\n\n$$ z = u t - \\frac12 g t^2 $$\n\n\
             $$ x(t) = \\frac13 w g t^3 $$\n\nand when it is back\n\n$$ x(t_1) = - \\frac{{4 w u^{power}}}{{3 g^2}} $$\n"
        )
    };
    assert!(!verdicts("throw", &throw(3)).contains(&"refuted".to_owned()));
    assert_eq!(verdicts("throw-slip", &throw(2))[4], "refuted");
}

const MEAN: &str = r"In the oscillator

$$ E = \frac{p^2}{2 m} + \frac12 m \omega^2 x^2 + \lambda x^4 $$

$$ \langle x^2 \rangle = \frac{\hbar}{2 m \omega} (2 n + 1) , \qquad \langle p^2 \rangle = \frac{\hbar m \omega}{2} (2 n + 1) $$

$$ \langle x^4 \rangle = 3 \left( \frac{\hbar}{2 m \omega} \right)^2 \left( 2 n^2 + 2 n + 1 \right) $$

$$ p_0 = m \omega x_0 $$

The first order is

$$ \Delta E = \lambda \langle x^4 \rangle = \frac{3 \lambda \hbar^2}{4 m^2 \omega^2} $$

$$ \Delta E' = E + \hbar\omega n $$
";

#[test]
fn a_mean_value_has_the_dimension_of_what_it_is_of() {
    assert!(!verdicts("mean", MEAN).contains(&"refuted".to_owned()));
    assert_eq!(verdicts("mean-slip", &MEAN.replace("4 m^2", "4 m"))[4], "refuted");
}

const SHEET: &str = r"**1. Sheet.** The potential of a plate is

$$ \varphi = - \frac{\sigma z}{2 \varepsilon_0} $$

$$ E_z = - \frac{\partial \varphi}{\partial z} = \frac{\sigma}{2 \varepsilon_0} $$

**2. Dipole.** From the potential

$$ \varphi = \frac{p \cos\theta}{4 \pi \varepsilon_0 r^2} $$

the component of the field is

$$ E_\theta = - \frac1r \frac{\partial \varphi}{\partial \theta} = \frac{p \sin\theta}{4 \pi \varepsilon_0 r^3} $$
";

#[test]
fn a_letter_is_another_one_after_a_heading_within_a_paragraph() {
    assert_eq!(verdicts("sheet", SHEET), ["definition", "certified", "definition", "certified"]);
    let slip = SHEET.replace(r"p \sin", r"p \cos");
    assert_eq!(verdicts("sheet-slip", &slip)[3], "refuted");
    assert_ne!(verdicts("sheet-plain", &slip.replace("**", ""))[3], "refuted");
}

#[test]
fn notes_that_cannot_be_set_up_are_reported_and_end_nothing() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/derivations/06-spinning-top.md");
    let notes = std::fs::read_to_string(path).expect("the derivation is there");
    let found = verdicts("top", &notes);
    assert!(!found.is_empty() && !found.contains(&"refuted".to_owned()), "{found:?}");
}
