//! Sentences of the prose, each kind true and false.

use onshell::check::Verdict::{self, Refuted, Undecided, Unreadable, Verified};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, numbers, outcome, pendulum, planet, with};

/// The verdict on a sentence; (1) of the document is a quadratic equation for x, (2) a double well.
fn sentence(claims: &Json, test: Json) -> Verdict {
    let notes = "It is as I say.\n\n$$ x^2 - 2bx + c = 0 \\tag{1} $$\n\n$$ V = x^4 - 2a x^2 \\tag{2} $$\n";
    let mut test = test;
    test["quote"] = json!("It is as I say.");
    test["name"] = json!("the sentence");
    let claims = with(claims, "sentences", json!([test]));
    let claims = match claims.get("system") {
        Some(_) => claims,
        None => with(&claims, "define", json!({ "V": "x^4 - 2a x^2" })),
    };
    let found = document(&claims, notes, &Registry::standard(), None).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(found.sentences.len(), 1);
    outcome(&found.sentences[0].finding)
}

fn of_numbers(test: Json) -> Verdict {
    sentence(&numbers(), test)
}

#[test]
fn the_sign_of_something() {
    let sign = |of: &str, sign: &str| of_numbers(json!({ "of": of, "sign": sign, "against": "x" }));
    assert_eq!(sign("x^2 + a", "positive"), Verified);
    assert_eq!(sign("x^2 + a", "negative"), Refuted);
    assert_eq!(sign("x^2 + a", "changes"), Refuted);
    assert_eq!(sign("-x^2 - a", "negative"), Verified);
    assert_eq!(sign(r"\frac{x}{a}", "changes"), Verified);
    assert_eq!(sign(r"\frac{x}{a}", "positive"), Refuted);
    // Only special states show it.
    assert_eq!(sign("x^2 - 2bx + c", "positive"), Refuted);
    assert_eq!(sign("(x - a)^2 - 10^{-6} a^2", "positive"), Refuted);
    assert_eq!(sign("10^{-6} a^2 - (x - a)^2", "negative"), Refuted);
}

#[test]
fn what_any_number_can_be_has_no_end() {
    let sign = |of: &str, sign: &str| of_numbers(json!({ "of": of, "sign": sign, "against": "x" }));
    assert_eq!(sign("x - a", "positive"), Refuted);
    assert_eq!(sign("x - a", "changes"), Verified);
}

#[test]
fn minima_and_maxima_are_counted() {
    let minima = |n: usize| of_numbers(json!({ "of": "x^4 - 2a x^2", "minima": n, "against": "x" }));
    assert_eq!((minima(2), minima(1), minima(0), minima(3)), (Verified, Refuted, Refuted, Refuted));
    let maxima = |n: usize| of_numbers(json!({ "of": "x^4 - 2a x^2", "maxima": n, "against": "x" }));
    assert_eq!((maxima(1), maxima(0), maxima(2)), (Verified, Refuted, Refuted));
    let hill = |n: usize| of_numbers(json!({ "of": "a - x^2", "minima": n, "against": "x" }));
    assert_eq!((hill(0), hill(1)), (Verified, Refuted));
}

#[test]
fn where_something_tends_to() {
    let tends = |of: &str, end: &str, value: &str| of_numbers(json!({ "of": of, "tends to": { end: value } }));
    assert_eq!(tends(r"\frac{a \sin x}{x}", r"x \to 0", "a"), Verified);
    assert_eq!(tends(r"\frac{a \sin x}{x}", r"x \to 0", "1"), Refuted);
    assert_eq!(tends(r"\frac{a \sin x}{x}", r"x \to 0", r"\infty"), Refuted);
    let positive = with(&numbers(), "constants", json!({ "a, b, c, x": "> 0" }));
    let diverges =
        |value: &str| sentence(&positive, json!({ "of": r"\frac{a}{x}", "tends to": { r"x \to 0": value } }));
    assert_eq!((diverges(r"\infty"), diverges(r"-\infty"), diverges("0")), (Verified, Refuted, Refuted));
}

#[test]
fn a_limit_is_reached_however_steep_the_way() {
    let tends = |value: &str| {
        of_numbers(json!({ "of": r"\frac{\sin(ax)}{x}", "tends to": { r"x \to 0": value }, "assume": "x > 0" }))
    };
    assert_eq!(tends("1"), Refuted);
    assert_eq!(tends("a"), Verified);
}

/// Close to the end a double has lost all digits of 1 − cos x, and a slow approach looks like none.
#[test]
fn a_limit_rests_on_no_rounding() {
    let positive = with(&numbers(), "constants", json!({ "a, b, c": "> 0", "x": "any" }));
    let tends = |of: &str, end: &str, value: &str| sentence(&positive, json!({ "of": of, "tends to": { end: value } }));
    let after = |of: &str, value: &str| {
        sentence(&positive, json!({ "of": of, "tends to": { r"x \to 0": value }, "assume": "x > 0" }))
    };
    let top = r"\frac{abc \sin x}{x} - \frac{a^2 (1 - \cos x)^2}{b x \sin^3 x}";
    assert_eq!(tends(top, r"x \to 0", r"abc - \frac{a^2}{4b}"), Verified);
    for wrong in [r"abc", r"abc - \frac{a^2}{2b}", r"abc - \frac{a^2}{4.0000000000001b}", r"\infty"] {
        assert_eq!(tends(top, r"x \to 0", wrong), Refuted, "{wrong}");
    }
    for (of, right, wrong) in [
        (r"\frac{x - \sin x}{x^3}", r"\frac16", r"0.16666666666666666"),
        (r"\frac{e^x - 1 - x - \frac{x^2}{2}}{x^3}", r"\frac16", r"\frac13"),
        (r"\frac{\tan x - \sin x}{x^3}", r"\frac12", "0"),
        (r"a + \frac{\sin(x^2)}{x}", "a", r"a + 10^{-12}"),
    ] {
        assert_eq!((tends(of, r"x \to 0", right), tends(of, r"x \to 0", wrong)), (Verified, Refuted), "{of}");
    }
    for (of, right, wrong) in [
        (r"a + \frac{1}{\ln x}", "a", "2a"),
        (r"\frac{a}{\ln x} - \ln x", r"\infty", "0"),
        (r"a x \ln x", "0", "10^{-9}"),
        (r"a e^{-1/x}", "0", "a"),
    ] {
        assert_eq!(after(of, right), Verified, "{of}");
        assert!(matches!(after(of, wrong), Refuted | Undecided), "{of}");
    }
    assert_eq!(tends(r"\frac{\sin x}{x - \pi}", r"x \to \pi", "-1"), Verified);
    assert_eq!(tends(r"\frac{1 + \cos x}{(x - \pi)^2}", r"x \to \pi", r"\frac12"), Verified);
    assert_eq!(tends(r"\frac{1 + \cos x}{(x - \pi)^2}", r"x \to \pi", r"\frac13"), Refuted);
}

/// A dip that stays above zero by 10⁻¹⁴ is no root, and two roots 10⁻⁸ apart are two.
#[test]
fn a_close_dip_is_decided_with_many_digits() {
    let sign = |of: &str| of_numbers(json!({ "of": of, "sign": "positive", "against": "x" }));
    assert_eq!(sign("(x - a)^2 + 10^{-14} a^2"), Verified);
    assert_eq!(sign("(x - a)^2 - 10^{-14} a^2"), Refuted);
    assert_eq!(sign("(x - a)^2"), Refuted);
}

#[test]
fn rising_and_falling() {
    let positive = with(&numbers(), "constants", json!({ "a, b, c, x": "> 0" }));
    let rises = |of: &str| sentence(&positive, json!({ "of": of, "rises with": "x" }));
    let falls = |of: &str| sentence(&positive, json!({ "of": of, "falls with": "x" }));
    assert_eq!((rises("a x^2"), falls("a x^2")), (Verified, Refuted));
    assert_eq!((rises(r"\frac{a}{x}"), falls(r"\frac{a}{x}")), (Refuted, Verified));
    assert_eq!((rises("x^2 - 2bx"), falls("x^2 - 2bx")), (Refuted, Refuted));
}

#[test]
fn solutions_are_counted() {
    let solutions =
        |n: usize, assume: &str| of_numbers(json!({ "solutions": n, "of": "1", "for": "x", "assume": assume }));
    assert_eq!(
        (solutions(2, "b^2 > c"), solutions(1, "b^2 > c"), solutions(0, "b^2 > c")),
        (Verified, Refuted, Refuted)
    );
    assert_eq!((solutions(0, "b^2 < c"), solutions(2, "b^2 < c")), (Verified, Refuted));
    assert_eq!(solutions(2, "b > 0"), Refuted);
}

#[test]
fn not_always_needs_a_counterexample() {
    let not_always = |latex: &str| of_numbers(json!({ "not always": latex }));
    assert_eq!(not_always(r"\sqrt{x^2} = x"), Verified);
    assert_eq!(not_always("(a + b)^2 = a^2 + 2ab + b^2"), Refuted);
    assert_eq!(of_numbers(json!({ "not always": r"\sqrt{x^2} = x", "assume": "x > 0" })), Refuted);
}

#[test]
fn a_claim_in_other_words() {
    let claim = |latex: &str| of_numbers(json!({ "claim": latex }));
    assert_eq!(claim("(a + b)^2 = a^2 + 2ab + b^2"), Verified);
    assert_eq!(claim("(a + b)^2 = a^2 + b^2"), Refuted);
    assert_eq!(claim(r"(a + b)^2 = a^2 + 2ab + b^2 , \quad a = b"), Refuted);
}

#[test]
fn inequalities_hold_or_fail() {
    let claim = |latex: &str| of_numbers(json!({ "claim": latex }));
    assert_eq!(claim("a^2 + b^2 > 3ab"), Refuted);
    assert_eq!(claim("a + b < a"), Refuted);
    assert_eq!(claim(r"a \neq -b"), Verified);
    // Two unrelated numbers may be equal.
    assert_eq!(claim(r"a \neq b"), Refuted);
    assert_eq!(claim("a^2 + b^2 > 2ab"), Refuted);
    assert_eq!(claim(r"a^2 + b^2 \geq 2ab"), Verified);
    assert_eq!(claim("a^2 + b^2 > ab"), Verified);
}

#[test]
fn constants_of_the_motion() {
    let conserved = |claims: &Json, what: &str| sentence(claims, json!({ "conserved": what }));
    assert_eq!(conserved(&planet(), r"m r^2 \dot\phi"), Verified);
    assert_eq!(conserved(&planet(), r"m r \dot\phi"), Refuted);
    assert_eq!(conserved(&planet(), r"m \dot r"), Refuted);
    assert_eq!(conserved(&planet(), "m G"), Undecided);
    assert_eq!(conserved(&pendulum(), "E"), Verified);
    assert_eq!(conserved(&pendulum(), "T"), Refuted);
}

#[test]
fn independent_of() {
    let independent = |of: &str| of_numbers(json!({ "of": of, "independent of": ["x"] }));
    assert_eq!(independent(r"a (\sin^2(x) + \cos^2(x))"), Verified);
    assert_eq!(independent(r"a (\sin^2(x) - \cos^2(x))"), Refuted);
}

#[test]
fn a_function_of_a_velocity_is_not_a_function_of_a_number() {
    let of = |of: &str| sentence(&pendulum(), json!({ "of": of, "sign": "positive", "against": r"\theta" }));
    assert_eq!(of(r"\dot\theta^2 + \theta"), Unreadable);
    assert_eq!(of(r"\theta^2 + m"), Verified);
}

#[test]
fn the_quoted_formula_is_the_claim_where_nothing_else_is() {
    let claims = |quote: &str| with(&numbers(), "sentences", json!([{ "quote": quote }]));
    let notes = "We know that $a + b = b + a$ and not that $a = b$, which is all.\n\n$$ x = 0 $$\n";
    let check = |quote: &str| document(&claims(quote), notes, &Registry::standard(), None);
    assert_eq!(outcome(&check("We know that $a + b = b + a$").unwrap().sentences[0].finding), Verified);
    assert_eq!(check("and not that $a = b$").unwrap().sentences[0].finding.verdict, Refuted);
    for quote in ["which is all", "which is nothing", "a"] {
        let error = check(quote).map(|_| ()).unwrap_err().to_string();
        assert!(error.starts_with("claims.json:"), "{error}");
    }
}

#[test]
fn independent_of_is_meant_of_values_far_apart_too() {
    let independent = |of: &str| of_numbers(json!({ "of": of, "independent of": ["x"] }));
    let of_positive = |of: &str| of_numbers(json!({ "of": of, "independent of": ["x"], "assume": "x > 0" }));
    for steps in [r"\frac{x}{|x|}", r"\frac{\sqrt{x^2}}{x}", r"\arctan x + \arctan\frac1x"] {
        // The twin: of positive numbers it is true.
        assert_eq!((independent(steps), of_positive(steps)), (Refuted, Verified), "{steps}");
    }
    let step = r"\frac{|x - a|}{x - a}";
    assert_eq!((independent(step), of_positive(step)), (Refuted, Refuted));
}

#[test]
fn a_hypothesis_says_where_the_variable_runs() {
    let of = |key: &str, of: &str, assume: &str, value: Json| {
        let mut test = json!({ "of": of, "assume": assume });
        test[key] = value;
        if key != "rises with" {
            test["against"] = json!("x");
        }
        of_numbers(test)
    };
    let sign = |f: &str, assume: &str| of("sign", f, assume, json!("positive"));
    let rises = |f: &str, assume: &str| of("rises with", f, assume, json!("x"));
    let minima = |n: usize, assume: &str| of("minima", "x^4 - 2x^2", assume, json!(n));
    assert_eq!((sign("x", "x > 0"), sign("x", "x > -1"), sign("x - 1", "x > 0")), (Verified, Refuted, Refuted));
    assert_eq!((rises("x^2", "x > 0"), rises("x^2", "x > -1")), (Verified, Refuted));
    let well = r"x + \frac1x";
    assert_eq!((rises(well, "x > 1"), rises(well, "x > 0.98"), rises(well, "x > 0")), (Verified, Refuted, Refuted));
    assert_eq!((minima(1, "x > 0"), minima(2, "x > 0"), minima(2, "x > -3")), (Verified, Refuted, Verified));
    // What would fix it is refused, and so is a bound on an unknown whose values are counted.
    assert_eq!(sign("x + a", "x = 1"), Unreadable);
    let solutions = json!({ "solutions": 1, "of": "1", "for": "x", "assume": ["b^2 > c", "x > 0"] });
    assert_eq!(of_numbers(solutions), Unreadable);
}

#[test]
fn what_is_too_dense_to_count_is_not_counted() {
    let claims = json!({ "constants": { r"\alpha": r"(0, \pi)", "b, c, a, x": "> 0" } });
    let maxima = |of: &str, n: usize| sentence(&claims, json!({ "of": of, "maxima": n, "against": r"\alpha" }));
    assert_eq!((maxima(r"\sin(100\alpha)", 50), maxima(r"\sin(100\alpha)", 18)), (Undecided, Undecided));
    // The twin: what can be counted is.
    assert_eq!((maxima(r"\sin(10\alpha)", 5), maxima(r"\sin(10\alpha)", 4)), (Verified, Refuted));
}

#[test]
fn a_key_that_a_sentence_would_ignore_is_rejected() {
    let notes = "It is as I say.\n\n$$ a + b = b + a \\tag{1} $$\n";
    let checked = |test: Json| {
        let mut test = test;
        test["quote"] = json!("It is as I say.");
        let claims = with(&numbers(), "sentences", json!([test]));
        document(&claims, notes, &Registry::standard(), None)
    };
    let formula = "(a + b)^2 = a^2 + 2ab + b^2";
    assert!(checked(json!({ "claim": formula })).is_ok());
    assert!(checked(json!({ "claim": formula, "assume": "a = b" })).is_ok());
    for (key, value) in [
        ("symmetry", json!({ "a": "b" })),
        ("same motion as", json!("a")),
        ("equilibrium", json!(true)),
        ("secular equation for", json!("a")),
        ("for each", json!("i")),
        ("also equals", json!("a")),
        ("skip", json!("no reason")),
    ] {
        let mut test = json!({ "claim": formula });
        test[key] = value;
        let error = checked(test).expect_err(key).to_string();
        assert!(error.contains(&format!("\"{key}\" is not supported for a sentence")), "{error}");
    }
    // What needs a relation has none in a property.
    let test = json!({ "of": "x^2 + a", "sign": "positive", "against": "x", "small": "a" });
    assert!(checked(test).is_err_and(|error| error.to_string().contains("needs a sentence that states a formula")));
}
