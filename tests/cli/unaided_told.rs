//! Notes without a claims file whose sentences say what the next display is: a formula for its name, or what the argument of a function
//! is. And what speaks for a premise that a display contradicts. Each page is true as printed; with one edit a display is wrong.

use crate::support;

/// The verdicts on the displays of a page.
fn verdicts(name: &str, notes: &str) -> Vec<String> {
    support::verdicts(&format!("unaided-told-{name}"), notes)
}

/// Pages that are true, and an edit that makes the last display wrong.
const PAGES: [(&str, &str, &str, &str); 5] = [
    (
        "argument",
        r"The charge of a capacitor is

$$ q(t) = C V_0 e^{-t/(R C)} $$

At the time $t_1 = R C \ln 2$ it is

$$ q(t_1) = \frac12 C V_0 $$
",
        r"\frac12 C",
        r"\frac14 C",
    ),
    (
        "square",
        r"The ellipse with the axis

$$ a = \frac{p}{1 - e^2} , \qquad p = \frac{\ell^2}{m k} $$

has the area $\pi a b$ with $b = a \sqrt{1 - e^2}$. Thus $\tau = 2 \pi m a b/\ell$ and

$$ \tau^2 = \frac{4 \pi^2 m a^3}{k} $$
",
        r"a^3",
        r"a^2",
    ),
    (
        "derivative",
        r"The gas has the energy

$$ U = a V T^4 $$

The heat capacity $C = dU/dT$ comes out as

$$ C = 4 a V T^3 $$
",
        r"C = 4 a",
        r"C = 3 a",
    ),
    (
        "printed before",
        r"The drag on a sphere of radius $a$ is $6 \pi \eta a v$. It sinks steadily if

$$ 6 \pi \eta a v = \frac{4}{3} \pi a^3 (\rho_s - \rho) g $$

that is, with

$$ v = \frac{2 a^2 (\rho_s - \rho) g}{9 \eta} $$
",
        r"{9 \eta}",
        r"{3 \eta}",
    ),
    (
        "both sides",
        r"A ball with the moment of inertia

$$ I = \frac25 m R^2 $$

slides with the speed $v_0$ and the spin $\omega_0$. With the speed $v_r$ of the final rolling

$$ m R v_0 + I \omega_0 = m R v_r + I \frac{v_r}{R} $$

and therefore

$$ v_r = \frac{5 v_0 + 2 R \omega_0}{7} $$
",
        r"5 v_0 + 2",
        r"5 v_0 - 2",
    ),
];

#[test]
fn what_a_sentence_says_of_a_name_is_compared_with_its_display() {
    for (name, notes, right, wrong) in PAGES {
        let found = verdicts(name, notes);
        let last = found.last().expect("a display");
        assert!(["certified", "verified"].contains(&last.as_str()), "{name}: {found:?}");
        assert!(found.iter().all(|verdict| verdict != "refuted"), "{name}: {found:?}");
        assert!(notes.contains(right), "{name}");
        let found = verdicts(name, &notes.replace(right, wrong));
        assert_eq!(found.last().map(String::as_str), Some("refuted"), "{name}: {found:?}");
        let others = &found[..found.len() - 1];
        assert!(others.iter().all(|verdict| verdict != "refuted"), "{name}: {found:?}");
    }
}

#[test]
fn a_sentence_about_another_place_makes_no_display_wrong() {
    let notes = r"A ball of radius $R$ has the charge $Q$. Outside, the potential is $V = Q/(4 \pi \epsilon r)$, and on the surface we have

$$ V = \frac{Q}{4 \pi \epsilon R} $$

The speed after a fall is $v = \sqrt{2 g h}$, so we get

$$ v = \sqrt{2 g H} $$

For slow particles the energy is $K = m v^2/2$, but for fast ones

$$ K = 2 m v^2 $$
";
    let found = verdicts("other", notes);
    assert!(found.iter().all(|verdict| verdict != "refuted"), "{found:?}");
}

#[test]
fn a_function_with_several_formulas_has_no_value_that_could_be_wrong() {
    let notes = r"Inside, the field is

$$ E(r) = \frac{Q r}{4 \pi \epsilon R^3} $$

and outside it is

$$ E(r) = \frac{Q}{4 \pi \epsilon r^2} $$

Half way, at $r_1 = R/2$, it is

$$ E(r_1) = \frac{Q}{8 \pi \epsilon R^2} $$
";
    let found = verdicts("several", notes);
    assert!(found.iter().all(|verdict| verdict != "refuted"), "{found:?}");
}

#[test]
fn what_a_slip_in_another_definition_explains_is_not_called_wrong() {
    let notes = |sign: &str| {
        format!(
            r"Let $\beta = 1/(k T)$. The energy of two levels is

$$ U = \frac{{N \epsilon}}{{e^{{\beta \epsilon}} + 1}} $$

and the free energy

$$ F = {sign} N k T \ln \left( 1 + e^{{-\beta \epsilon}} \right) $$

so we have the entropy, from $S = (U - F)/T$,

$$ S = N k \left[ \ln \left( 1 + e^{{-\beta \epsilon}} \right) + \frac{{\beta \epsilon}}{{e^{{\beta \epsilon}} + 1}} \right] $$
"
        )
    };
    assert_eq!(verdicts("explained-right", &notes("-"))[2], "certified");
    assert_eq!(verdicts("explained", &notes(""))[2], "undecided");
}

#[test]
fn a_premise_that_nothing_speaks_for_may_be_wrong_itself() {
    let notes = r"A sphere of radius $a$ sinks steadily if

$$ 6 \pi \eta a v = \frac{4}{3} \pi a^3 (\rho_s - \rho) g $$

that is, with

$$ v = \frac{2 a^2 (\rho_s - \rho) g}{3 \eta} $$
";
    assert_eq!(verdicts("alone", notes)[1], "undecided");
}
