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
