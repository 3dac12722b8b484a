//! Notes without a claims file: integrals without a known antiderivative, series with dots, and what is nearly equal.

use serde_json::Value;

use crate::support::Desk;

/// The verdict and the message on each display of a page, and its first replacement.
fn findings(name: &str, notes: &str) -> Vec<(String, String, Option<String>)> {
    let desk = Desk::new(&format!("series-{name}"));
    desk.write("notes.md", notes);
    let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err));
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let one = |equation: &Value| {
        let repair = equation["repairs"][0]["replacement"].as_str().map(str::to_owned);
        (text(&equation["verdict"]), text(&equation["message"]), repair)
    };
    report["documents"][0]["equations"].as_array().expect("a list").iter().map(one).collect()
}

/// A page of displays.
fn page(displays: &[&str]) -> String {
    displays.iter().map(|latex| format!("We find\n$$ {latex} $$\n\n")).collect()
}

/// The verdicts on displays, each on a page of its own.
fn verdicts(name: &str, displays: &[&str]) -> Vec<(String, Option<String>)> {
    let one = |latex: &&str| findings(name, &page(&[latex])).pop().map(|(verdict, _, repair)| (verdict, repair));
    displays.iter().filter_map(one).collect()
}

#[test]
fn an_integral_is_judged_by_its_value() {
    let right = [
        r"W = \int_R^\infty \frac{Q^2}{r^2}\,dr = \frac{Q^2}{R}",
        r"\int_0^\infty v^5 e^{-a v^2}\,dv = \frac{1}{a^3}",
        r"\int_0^\infty \frac{x^3}{e^x-1}\,dx = \frac{\pi^4}{15}",
        r"\int_0^{2\pi} \frac{d\theta}{a + b\cos\theta} = \frac{2\pi}{\sqrt{a^2-b^2}}",
    ];
    for (latex, (verdict, _)) in right.iter().zip(verdicts("integrals", &right)) {
        assert_eq!(verdict, "verified", "{latex}");
    }
    let wrong = [
        (r"\int_R^\infty \frac{Q^2}{r^2}\,dr = \frac{Q^2}{2R}", None),
        (r"\int_0^\infty v^5 e^{-a v^2}\,dv = \frac{2}{a^3}", Some("1")),
        (r"\int_0^\infty \frac{x^3}{e^x-1}\,dx = \frac{\pi^4}{12}", Some("15")),
    ];
    for (latex, repair) in wrong {
        let found = verdicts("integral-slips", &[latex]).remove(0);
        assert_eq!(found.0, "refuted", "{latex}");
        assert!(repair.is_none_or(|repair| found.1.as_deref() == Some(repair)), "{latex}: {found:?}");
    }
    // must-fail cases: no finite value, and one that the sums do not show
    for latex in [r"J = \int_{-1}^{2} \frac{1}{x}\,dx = \ln 2", r"\int_0^\infty \frac{\sin x}{x}\,dx = \frac{\pi}{3}"] {
        assert_eq!(verdicts("no-integral", &[latex])[0].0, "undecided", "{latex}");
    }
}

#[test]
fn a_derivative_of_an_unknown_formula_in_an_integral_is_left_open() {
    let notes = "The work is\n$$ K = \\int_0^u u \\frac{dp}{du}\\,du = \\frac{m u^2}{2} $$\n";
    assert_ne!(findings("lost", notes)[0].0, "refuted");
}

#[test]
fn a_series_with_dots_holds_to_the_order_of_its_last_term() {
    let right = [
        r"\cos x = 1 - \frac{x^2}{2} + \cdots",
        r"\sin x = x - \frac{x^3}{6} + O(x^5)",
        r"\sqrt{1+x} = 1 + \frac{x}{2} + \mathcal{O}(x^2)",
        r"\frac{mc^2}{\sqrt{1-u^2/c^2}} = m c^2 + \tfrac12 m u^2 + \tfrac38 \frac{m u^4}{c^2} + \dots",
        r"g \sin\theta = g\left(\theta - \frac{\theta^3}{6} + \ldots\right)",
    ];
    for (latex, (verdict, _)) in right.iter().zip(verdicts("series", &right)) {
        assert_eq!(verdict, "verified", "{latex}");
    }
    let wrong = [
        (r"\cos x = 1 - \frac{x^2}{4} + \cdots", "2"),
        (r"\sin x = x - \frac{x^3}{3} + O(x^5)", "6"),
        (r"\tan x = x + \frac{x^3}{3} + \frac{2x^4}{15} + \dots", "5"),
    ];
    for (latex, repair) in wrong {
        let found = verdicts("series-slips", &[latex]).remove(0);
        assert_eq!((found.0.as_str(), found.1.as_deref()), ("refuted", Some(repair)), "{latex}");
    }
    // must-fail cases: no power grows, the order that is named is too high, and dots in the middle are no rest.
    for latex in
        [r"\sin x + \cos y = 1 + x + y + \dots", r"\sin x = x + O(x^4)", r"\frac{1}{1-x} = 1 + x + \dots + x^n"]
    {
        assert_ne!(verdicts("no-series", &[latex])[0].0, "verified", "{latex}");
    }
}

#[test]
fn a_new_name_that_is_given_a_series_is_introduced() {
    let found = findings("new", "Let us write\n$$ V = a x + b x^2 + \\dots $$\n");
    assert_eq!(found[0].0, "definition", "{found:?}");
}

const HEAT: &str =
    r"C = N k \left(\frac{\varepsilon}{k T}\right)^2 \frac{e^{\varepsilon/(k T)}}{(1+e^{\varepsilon/(k T)})^2}";

/// The finding on an approximation after the formula of a heat capacity and these words.
fn of_heat(words: &str, latex: &str) -> (String, String, Option<String>) {
    findings("heat", &format!("The heat capacity is\n$$ {HEAT} $$\n{words}\n$$ {latex} $$\n")).remove(1)
}

#[test]
fn what_is_nearly_equal_holds_in_a_limit_that_the_words_name() {
    let (hot, cold) = (
        r"C \approx \frac{N k}{4}\left(\frac{\varepsilon}{k T}\right)^2",
        r"C \approx N k \left(\frac{\varepsilon}{k T}\right)^2 e^{-\varepsilon/(k T)}",
    );
    for (words, latex, end) in [
        ("At high temperature", hot, "T → ∞"),
        (r"For $\varepsilon \ll k T$ we have", hot, "ε → 0"),
        ("Hence", hot, "T → ∞"),
        ("At low temperature", cold, "T → 0"),
    ] {
        let (verdict, message, _) = of_heat(words, latex);
        assert_eq!(verdict, "verified", "{words}: {message}");
        assert!(message.ends_with(end), "{words}: {message}");
    }
    // must-fail cases: the other limit, and slips in the factor, the power and the sign
    assert_ne!(of_heat("At low temperature", hot).0, "verified");
    for (words, latex, repair) in [
        ("At high temperature", hot.replace("{4}", "{2}"), "4"),
        ("At high temperature", hot.replace(")^2", ")^3"), "2"),
        ("Hence", hot.replace("{4}", "{8}"), "4"),
        ("At low temperature", cold.replace("{-", "{"), "-"),
    ] {
        let (verdict, message, found) = of_heat(words, &latex);
        assert_eq!((verdict.as_str(), found.as_deref()), ("refuted", Some(repair)), "{latex}: {message}");
    }
}

#[test]
fn a_sum_that_is_nearly_equal_holds_to_the_order_of_its_last_term() {
    let found = |latex: &str| findings("sum", &format!("For small $x$\n$$ {latex} $$\n")).remove(0);
    assert_eq!(found(r"\ln(1+x) \approx x - \frac{x^2}{2}").0, "verified");
    let (verdict, _, repair) = found(r"\ln(1+x) \approx x - \frac{x^2}{3}");
    assert_eq!((verdict.as_str(), repair.as_deref()), ("refuted", Some("2")));
}

/// ≈ may rest on numbers, hold near a value, or be rough.
#[test]
fn what_holds_in_no_limit_is_left_open() {
    for (words, latex) in [
        ("We have", r"\ln 2 \approx \frac{7}{10}"),
        ("We have", r"F \approx m g"),
        ("Near the resonance", r"\omega_0^2 - \omega^2 \approx 2\omega_0(\omega_0 - \omega)"),
        ("Close to one", r"x^2 - 1 \approx 2(x - 1)"),
        ("For the nearly equal masses", r"\frac{m M}{m + M} \approx \frac{m}{2}"),
        ("This is", r"\sqrt{m M} \approx \frac{m + M}{2}"),
        ("For the angles near a right one", r"\cos\theta \approx \frac{\pi}{2} - \theta"),
        ("A rough estimate at small $x$ is", r"\frac{x}{1 + x} \approx 2 x"),
        (
            r"For $\omega_1 \ll \omega \ll \omega_2$",
            r"\frac{\omega^2}{\omega^2 + \omega_1^2} + \frac{\omega^2}{\omega_2^2} \approx \frac{\omega^2}{2\omega_2^2}",
        ),
    ] {
        let found = findings("open", &format!("{words}\n$$ {latex} $$\n")).remove(0);
        assert_ne!(found.0, "refuted", "{latex}: {found:?}");
    }
}

#[test]
fn an_integrand_without_its_letter_is_no_constant() {
    let notes = "With\n$$ m = m_0 - b t $$\nwe integrate,\n$$ \\int_0^t \\ln\\frac{m_0}{m}\\,dt' = \\frac1b\\int_m^{m_0}\\ln\\frac{m_0}{m'}\\,dm'. $$\n";
    assert_ne!(findings("hidden", notes)[1].0, "refuted");
}

/// The sphere's cap and the square of its rim agree where the cap is half the sphere: a crossing, and no approximation there.
#[test]
fn the_end_of_a_chain_is_nearly_equal_in_a_limit_that_no_words_name() {
    let found = |latex: &str| findings("chain-end", &format!("The cap has the height\n$$ {latex} $$\n")).remove(0);
    for (right, wrong) in [
        (r"h = R - \sqrt{R^2 - r^2} \approx \frac{r^2}{2R}", r"h = R - \sqrt{R^2 - r^2} \approx \frac{r^2}{R}"),
        (
            r"\Delta = \frac{k}{(d - a)^2} - \frac{k}{d^2} \approx \frac{2 k a}{d^3}",
            r"\Delta = \frac{k}{(d - a)^2} - \frac{k}{d^2} \approx \frac{3 k a}{d^3}",
        ),
    ] {
        assert_eq!(found(right).0, "verified", "{right}");
        assert_eq!(found(wrong).0, "refuted", "{wrong}");
    }
}
