//! Notes without a claims file in which words say that a display follows from the ones before it, which it does up to a number.

use crate::support::verdicts;

fn found(name: &str, notes: &str) -> Vec<String> {
    verdicts(&format!("unaided-conclusion-{name}"), notes)
}

fn passes(verdict: &str) -> bool {
    ["certified", "verified"].contains(&verdict)
}

/// The verdict on a display after others, with words between the two.
fn last(name: &str, notes: &str) -> String {
    found(name, notes).pop().expect("a verdict")
}

const PENDULUM: &str = r"The bullet sticks. Momentum is conserved,

$$ m v = (m + M) V $$

and after it the energy,

$$ \frac12 (m+M) V^2 = (m+M) g h $$

Eliminating $V$ gives

$$ v = \frac{m+M}{m}\sqrt{2 g h} $$
";

#[test]
fn a_common_factor_of_a_law_hides_nothing() {
    assert!(passes(&last("pendulum", PENDULUM)));
    for slip in ["g h", r"\frac{g h}{2}", "3 g h"] {
        let wrong = PENDULUM.replace("{2 g h}", &format!("{{{slip}}}"));
        assert_eq!(last("pendulum-slip", &wrong), "refuted", "{slip}");
    }
}

#[test]
fn a_conclusion_is_wrong_by_a_number() {
    let outflow = |words: &str, speed: &str| {
        format!("$$ p_0 + \\rho g h = p_0 + \\frac12 \\rho v^2 $$\n\n{words}\n\n$$ v = {speed} $$\n")
    };
    assert!(passes(&last("outflow", &outflow("hence", r"\sqrt{2 g h}"))));
    assert_eq!(last("outflow-slip", &outflow("hence", r"\sqrt{g h}")), "refuted");
    assert_eq!(last("outflow-four", &outflow("so that", r"2\sqrt{g h}")), "refuted");
    // Where the words say of no consequence, it may be another speed.
    assert_eq!(last("outflow-other", &outflow("The wave has the speed", r"\sqrt{g h}")), "assumed");
    assert_ne!(last("outflow-case", &outflow("For a circular orbit instead", r"\sqrt{g h}")), "refuted");
}

/// The law of one thing holds with another number for several: that is no slip.
#[test]
fn several_things_have_another_number() {
    let law =
        |law: &str, words: &str, result: &str| last("several", &format!("$$ {law} $$\n\n{words}\n\n$$ {result} $$\n"));
    for (first, words, result) in [
        ("F = k x", "Two springs side by side give", "F = 2 k x"),
        ("m v = p", "Hence", r"v = \frac{2 p}{m}"),
        (r"E = \frac12 k T", "Three degrees of freedom give", r"E = \frac32 k T"),
        (r"m g h = \frac12 m v^2", "Half of the energy is lost, so that", r"v = \sqrt{g h}"),
    ] {
        assert_ne!(law(first, words, result), "refuted", "{words}");
    }
}

#[test]
fn what_is_doubled_has_another_number() {
    let pull = |words: &str| {
        let laws = "$$ F - \\mu m g = m a $$\n\nso that\n\n$$ a = \\frac Fm - \\mu g $$";
        last("pull", &format!("{laws}\n\n{words}\n\n$$ a = \\frac{{2F}}{{m}} - \\mu g $$\n"))
    };
    assert_eq!(pull("It then follows that"), "refuted");
    assert_ne!(pull("Once it moves, the pull is doubled; then"), "refuted");
}

/// What begins a sentence as another thing has a formula of its own.
#[test]
fn another_thing_has_another_formula() {
    let speed = |words: &str| {
        let law = r"\frac12 m v^2 = \frac{G M m}{r}";
        last("thing", &format!("$$ {law} $$\n\n{words}\n\n$$ v = \\sqrt{{\\frac{{G M}}{{r}}}} $$\n"))
    };
    assert_eq!(speed("It follows that"), "refuted");
    assert_eq!(speed("A short calculation then gives"), "refuted");
    assert_ne!(speed("A satellite on a circle is slower. It follows that"), "refuted");
    assert_ne!(speed("A satellite then has"), "refuted");
    let doppler = |words: &str, result: &str| {
        let law = r"f' = f\sqrt{\frac{1-\beta}{1+\beta}}";
        last("mirror", &format!("$$ {law} $$\n\n{words} with $\\beta = \\frac35$ gives\n\n$$ f' = {result} $$\n"))
    };
    assert!(passes(&doppler("The source", r"\frac f2")));
    assert_eq!(doppler("The source", r"\frac f4"), "refuted");
    assert_ne!(doppler("A mirror", r"\frac f4"), "refuted");
}

#[test]
fn two_quantities_of_a_sentence_that_are_equal_are_a_law() {
    let stokes = |speed: &str| {
        format!(
            "Weight and friction\n\n$$ G = \\frac43\\pi a^3\\rho g, \\qquad F = 6\\pi\\eta a v $$\n\n\
             are equal, $G = F$, so\n\n$$ v = {speed} $$\n"
        )
    };
    assert!(passes(&last("stokes", &stokes(r"\frac{2 a^2 \rho g}{9\eta}"))));
    assert_eq!(last("stokes-power", &stokes(r"\frac{2 a \rho g}{9\eta}")), "refuted");
    assert_eq!(last("stokes-number", &stokes(r"\frac{4 a^2 \rho g}{9\eta}")), "refuted");
}

#[test]
fn a_label_of_a_statement_begins_no_other_system() {
    let bohr = |label: &str, power: &str| {
        format!(
            "$$ \\frac{{e^2}}{{4\\pi\\varepsilon_0 r^2}} = \\frac{{m v^2}}{{r}} \\tag{{1}} $$\n\n{label}\n\n\
             $$ m v r = n\\hbar \\tag{{2}} $$\n\nInsert $v = n\\hbar/(mr)$ into (1):\n\n\
             $$ r = \\frac{{4\\pi\\varepsilon_0 \\hbar^2}}{{m e^2}} {power} \\tag{{3}} $$\n"
        )
    };
    assert!(passes(&last("bohr", &bohr("Quantum condition:", "n^2"))));
    assert_eq!(last("bohr-slip", &bohr("Quantum condition:", "n^3")), "refuted");
    // The name of a thing does: nothing of before holds there.
    assert!(!passes(&last("bohr-thing", &bohr("Neutron star:", "n^2"))));
}

#[test]
fn the_last_term_of_an_approximation_counts() {
    let near = |words: &str, sides: &str| last("near", &format!("{words}\n\n$$ {sides} $$\n"));
    for (right, wrong) in [
        (r"\frac{1}{1+x} \approx 1 - x", r"\frac{1}{1+x} \approx 1 + x"),
        (r"\sqrt{1+x} \approx 1 + \frac{x}{2}", r"\sqrt{1+x} \approx 1 + x"),
        (r"\cos x \approx 1 - \frac{x^2}{2}", r"\cos x \approx 1 - \frac{x^2}{4}"),
        (r"\frac{1}{1-x} \approx 1 + x", r"\frac{1}{1-x} \approx 1 - x"),
    ] {
        assert!(passes(&near("For small $x$", right)), "{right}");
        assert_eq!(near("For small $x$", wrong), "refuted", "{wrong}");
    }
    // A rough estimate is no series.
    assert_ne!(near("A rough estimate for small $x$ is", r"\sqrt{1+x} \approx 1 + x"), "refuted");
    let energy = |term: &str| {
        let notes = format!(
            "$$ E = \\frac{{m c^2}}{{\\sqrt{{1 - v^2/c^2}}}} $$\n\nFor $v \\ll c$\n\n$$ E \\approx m c^2 + {term} m v^2 $$\n"
        );
        last("energy", &notes)
    };
    assert!(passes(&energy(r"\frac12")));
    assert_eq!(energy(r"\frac14"), "refuted");
}

#[test]
fn an_identity_of_a_chain_holds_whatever_is_supposed_of_other_names() {
    let beat = |words: &str, product: &str| {
        let chain = format!(
            r"x_1 = \frac a2(\cos\omega_1 t + \cos\omega_2 t) = a\cos\left(\frac{{\omega_1+\omega_2}}{{2}}t\right) {product}\left(\frac{{\omega_2-\omega_1}}{{2}}t\right)"
        );
        last("beat", &format!("{words}\n\n$$ {chain} $$\n"))
    };
    let start = "If at the beginning $x_1 = a$, $x_2 = 0$ and both are at rest,";
    assert_eq!(beat(start, r"\sin"), "refuted");
    assert_ne!(beat(start, r"\cos"), "refuted");
}

/// An equality may hold only where two names are equal, as the words say.
#[test]
fn an_equality_of_a_chain_may_need_what_the_words_say_of_its_names() {
    let sum = |words: &str| last("masses", &format!("{words}\n\n$$ S = (m_1 + m_2) m_2 = m_1^2 + m_1 m_2 $$\n"));
    assert_eq!(sum("If $x = 0$,"), "refuted");
    assert_ne!(sum("If $m_1 = m_2$,"), "refuted");
    assert_ne!(sum("If both have the same mass,"), "refuted");
}

/// "or" gives a formula another form. Without the word, and in as few symbols, it may be a law of its own.
#[test]
fn another_form_of_a_formula_follows_from_it() {
    let falls = |words: &str, result: &str| {
        let law = r"v = \frac{2 a^2 (\rho_s - \rho) g}{9\eta}";
        last("form", &format!("A sphere sinks with\n\n$$ {law} $$\n\n{words}\n\n$$ \\eta = {result} $$\n"))
    };
    let form = r"\frac29 \frac{a^2 (\rho_s - \rho) g}{v}";
    assert!(passes(&falls("or, for the viscosity,", form)));
    let wrong = falls("or, for the viscosity,", &form.replace("{v}", "{v^2}"));
    assert!(["refuted", "undecided"].contains(&wrong.as_str()), "{wrong}");
    assert_eq!(falls("The other fluid has", &form.replace("{v}", "{v^2}")), "assumed");
}

/// Words that suppose something do not matter to an identity of many names.
#[test]
fn an_identity_is_judged_whatever_the_words_suppose() {
    let divider = |sum: &str| {
        let notes = format!(
            "If a load $L$ is connected, $S$ must be replaced by\n\n$$ P = \\frac{{S L}}{{S + L}} $$\n\n\
             $$ U' = \\frac{{P}}{{R + P}} U = \\frac{{S L}}{{{sum}}} U $$\n"
        );
        last("divider", &notes)
    };
    assert!(passes(&divider("R S + R L + S L")));
    assert_eq!(divider("R S + R L - S L"), "refuted");
}
