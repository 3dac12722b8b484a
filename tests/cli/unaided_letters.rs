//! Notes without a claims file: what letters and remarks mean.

use crate::support::{self, Desk};

/// The verdict of each display of notes.
fn verdicts(name: &str, notes: &str) -> Vec<String> {
    support::verdicts(&format!("letters-{name}"), notes)
}

const BEAM: &str = r"The field is $u\, e^{i k z}$ with

$$ q = z - i z_R . $$

We separate

$$ \frac1q = \frac{z + i z_R}{z^2 + z_R^2} . $$
";

#[test]
fn i_is_the_imaginary_unit_where_one_formula_says_so() {
    assert_eq!(verdicts("beam", BEAM), ["definition", "certified"]);
    assert_ne!(verdicts("beam-wrong", &BEAM.replace("z + i", "z - i"))[1], "certified");
    let orbit = "The star moves with $K = v \\sin i$, and\n\n$$ M = \\frac{P K^3}{2\\pi G \\sin^3 i} $$\n";
    assert!(!verdicts("orbit", orbit).contains(&"unreadable".to_owned()));
}

const STEP: &str = r"Solving

$$ r = \frac{k_1 - k_2}{k_1 + k_2} , \qquad t = \frac{2 k_1}{k_1 + k_2} $$

the transmission is

$$ T = \frac{k_2}{k_1} t^2 = \frac{4 k_1 k_2}{(k_1 + k_2)^2} $$
";

#[test]
fn t_is_a_coefficient_where_nothing_moves() {
    assert_eq!(verdicts("step", STEP)[1], "certified");
    let wrong = verdicts("step-wrong", &STEP.replace(r"\frac{k_2}{k_1} t^2", r"\frac{k_1}{k_2} t^2"));
    assert!(["refuted", "undecided"].contains(&wrong[1].as_str()), "{wrong:?}");
}

const WALK: &str = r"The solution is

$$ s = \frac{2 k T}{\gamma} \left[ t - \frac{m}{\gamma} \left( 1 - e^{-\gamma t/m} \right) \right] . $$

For long times

$$ s \approx \frac{2 k T}{\gamma} t . $$
";

#[test]
fn the_time_may_be_long_and_a_remark_may_say_so() {
    assert_eq!(verdicts("walk", WALK)[1], "verified");
    assert_ne!(verdicts("walk-wrong", &WALK.replace(r"\approx \frac{2", r"\approx \frac{3"))[1], "verified");
    let remark = WALK.replace("For long times", "Hence").replace("t . $$\n", "t \\qquad (t \\gg m/\\gamma) . $$\n");
    assert_eq!(verdicts("remark", &remark)[1], "verified");
}

const UNCERTAIN: &str = r"We read off

$$ \Delta p = \frac{\hbar}{2\sigma} . $$

Then

$$ s^2 = \sigma^2 + \frac{t^2}{m^2} (\Delta p)^2 , $$

and so

$$ s = \sigma \sqrt{1 + \left( \frac{\hbar t}{2 m \sigma^2} \right)^2} . $$
";

#[test]
fn a_difference_is_a_name_that_a_display_defines() {
    assert_eq!(verdicts("uncertain", UNCERTAIN), ["definition", "definition", "verified"]);
    assert_ne!(verdicts("uncertain-wrong", &UNCERTAIN.replace(r"{2 m \sigma^2}", r"{m \sigma^2}"))[2], "verified");
}

const HEAP: &str = r"# On the table

The chain obeys

$$ \lambda L \ddot x = \lambda g x . $$

The solution is

$$ x(t) = x_0 \cosh\left( \sqrt{\frac{g}{L}}\, t \right) $$

# From a heap

The momentum is $\lambda x v$ with $v = \dot x$:

$$ \frac{d}{dt} \left( \lambda x v \right) = \lambda g x $$

Integrated,

$$ v^2 = \frac23 g x . $$

Indeed

$$ \ddot x = \frac{g}{3} . $$
";

#[test]
fn a_law_of_one_section_is_none_of_another() {
    let found = verdicts("heap", HEAP);
    assert!(!found.contains(&"refuted".to_owned()), "{found:?}");
    assert_eq!((found[1].as_str(), found.last().map(String::as_str)), ("certified", Some("verified")), "{found:?}");
    let other = verdicts("heap-wrong", &HEAP.replace(r"\cosh", r"\cos"));
    assert_ne!(other[1], "certified");
}

#[test]
fn an_open_exponent_says_nothing_of_dimensions() {
    let notes = r"The gas has

$$ \left( p + \frac{a}{v^2} \right) (v - b) = R T $$

$$ u = c_v T - \frac{a}{v} $$

$$ p = \frac{R T}{v - b} - \frac{a}{v^2} $$

$$ v_c = 3 b $$

An adiabat is

$$ T (v - b)^{R/c_v} = \mathrm{const} $$
";
    assert!(!verdicts("adiabat", notes).contains(&"refuted".to_owned()));
}

const SPRING: &str = r"The mass obeys

$$ m \ddot x + k x = 0 . $$

With $\omega^2 = k/m$ the solution is

$$ x(t) = A \cos\omega t + B \sin\omega t . $$

At the start

$$ x(0) = A , \qquad \dot x(0) = B \omega . $$
";

#[test]
fn what_is_the_value_at_an_instant_does_not_vary() {
    assert_eq!(verdicts("spring", SPRING)[1], "certified");
    assert_ne!(verdicts("spring-wrong", &SPRING.replace(r"B \sin\omega t", r"B \sin 2\omega t"))[1], "certified");
}

#[test]
fn what_stands_before_a_place_in_a_sine_is_no_angle() {
    let string = |slope: &str| {
        format!(
            "On the left\n\n$$ y(x) = A \\sin kx $$\n\nand on the right\n\n$$ z(x) = B \\sin k(\\ell - x) $$\n\nThe slopes are\n\n\
             $$ y'(x) = {slope} $$\n"
        )
    };
    let desk = Desk::new("letters-wave-number");
    let report = |notes: &str| {
        desk.write("notes.md", notes);
        let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
        assert!(!run.out.contains("sin(k)"), "{}", run.out);
        run.json()["documents"][0]["equations"][2]["verdict"].as_str().unwrap_or_default().to_owned()
    };
    assert_eq!(report(&string("A k \\cos kx")), "certified");
    assert_eq!(report(&string("A k \\sin kx")), "refuted");
    // an angle before a parenthesis stays one
    desk.write("notes.md", "$$ F = m g \\sin\\theta(1 + \\mu) $$\n");
    let run = desk.onshell(&["check", "notes.md", "--verbose"]);
    assert!(run.out.contains("sin(θ)·(1 + μ)"), "{}", run.out);
}
