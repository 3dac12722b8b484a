//! Sums and integrals in notes as textbooks print them: each display is true, and each has a slip beside it that is false.

use onshell::check::Verdict::{Refuted, Undecided, Unreadable, Verified};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, numbered, outcome};

fn letters() -> Json {
    json!({
        "constants": { r"a, b, k, l, m, R, z, \rho, \beta, \hbar, \omega, \gamma, T, r, x": "> 0", "n": "integer 2..6" },
    })
}

/// What the notes print, and the same with one slip.
const DISPLAYS: [[&str; 2]; 12] = [
    [r"\int_0^a k x \, dx = \frac{k a^2}{2}", r"\int_0^a k x \, dx = \frac{k a^2}{3}"],
    [
        r"\int_{-l/2}^{l/2} \frac{m}{l} x^2 \, dx = \frac{m l^2}{12}",
        r"\int_0^{l/2} \frac{m}{l} x^2 \, dx = \frac{m l^2}{12}",
    ],
    [r"\int_0^R 4\pi\rho r^4 \, dr = \frac{4\pi\rho R^5}{5}", r"\int_0^R 4\pi\rho r^3 \, dr = \frac{4\pi\rho R^5}{5}"],
    [
        r"\int_0^\pi \int_0^{2\pi} R^2 \sin\theta \, d\phi \, d\theta = 4\pi R^2",
        r"\int_0^\pi \int_0^{\pi} R^2 \sin\theta \, d\phi \, d\theta = 4\pi R^2",
    ],
    [
        r"\frac{\omega}{2\pi} \int_0^{2\pi/\omega} \cos^2(\omega t) \, dt = \frac12",
        r"\frac{\omega}{2\pi} \int_0^{2\pi/\omega} \cos(\omega t) \, dt = \frac12",
    ],
    [
        r"\int_0^\infty e^{-\gamma t} \sin(\omega t) \, dt = \frac{\omega}{\gamma^2 + \omega^2}",
        r"\int_0^\infty e^{-\gamma t} \sin(\omega t) \, dt = \frac{\gamma}{\gamma^2 + \omega^2}",
    ],
    [
        r"\int_{-\infty}^{\infty} x^2 e^{-a x^2} \, dx = \frac{1}{2a} \sqrt{\frac{\pi}{a}}",
        r"\int_{-\infty}^{\infty} x^2 e^{-a x^2} \, dx = \frac{1}{a} \sqrt{\frac{\pi}{a}}",
    ],
    [
        r"\int_{-\infty}^{\infty} \frac{b \, dx}{(x^2 + b^2)^{3/2}} = \frac{2}{b}",
        r"\int_0^{\infty} \frac{b \, dx}{(x^2 + b^2)^{3/2}} = \frac{2}{b}",
    ],
    [
        r"\int_R^\infty \frac{k}{r^2} \, dr = \left[ -\frac{k}{r} \right]_{r=R}^{r=2R} + \frac{k}{2R}",
        r"\int_R^\infty \frac{k}{r^2} \, dr = \left[ -\frac{k}{r} \right]_{r=R}^{r=2R} + \frac{k}{R}",
    ],
    [r"\sum_{j=1}^{n} j^2 = \frac{n(n+1)(2n+1)}{6}", r"\sum_{j=1}^{n} j^2 = \frac{n(n+1)(2n-1)}{6}"],
    [
        r"\sum_{s=0}^{\infty} e^{-\beta\hbar\omega s} = \frac{1}{1 - e^{-\beta\hbar\omega}}",
        r"\sum_{s=1}^{\infty} e^{-\beta\hbar\omega s} = \frac{1}{1 - e^{-\beta\hbar\omega}}",
    ],
    [
        r"\left. \frac{d}{dx} \left( x^3 - b x \right) \right|_{x=a} = 3a^2 - b",
        r"\left. \frac{d}{dx} \left( x^3 - b x \right) \right|_{x=a} = 3a^2 + b",
    ],
];

#[test]
fn what_textbooks_print_holds_and_its_slips_are_refuted() {
    let judge = |which: usize| {
        let displays: Vec<&str> = DISPLAYS.iter().map(|pair| pair[which]).collect();
        let found = document(&letters(), &numbered(&displays), &Registry::standard(), None).unwrap();
        found.equations.into_iter().map(|equation| equation.finding).collect::<Vec<_>>()
    };
    let wrong = |(_, passes): &(usize, bool)| !*passes;
    let held = judge(0);
    let open: Vec<String> = held
        .iter()
        .map(|finding| finding.verdict.passes())
        .enumerate()
        .filter(wrong)
        .map(|(at, _)| format!("{}: {}", DISPLAYS[at][0], held[at].message))
        .collect();
    assert!(open.is_empty(), "{}", open.join("\n"));
    let refuted = judge(1);
    let missed: Vec<String> = refuted
        .iter()
        .map(|finding| finding.verdict == Refuted)
        .enumerate()
        .filter(wrong)
        .map(|(at, _)| format!("{}: {}", DISPLAYS[at][1], refuted[at].message))
        .collect();
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}

#[test]
fn what_has_no_value_is_said_to_have_none() {
    let none = [r"\int_0^\infty e^{x} \, dx = -1", r"\sum_{j=1}^{n} \frac1j = n", r"\sum_{j=1}^{n} a = n a"];
    let found = document(&letters(), &numbered(&none), &Registry::standard(), None).unwrap();
    for (latex, equation) in none.iter().zip(&found.equations) {
        assert_eq!(outcome(&equation.finding), Unreadable, "{latex}: {}", equation.finding.message);
    }
}

/// Integrals without a known antiderivative, and the same with one slip.
const BY_QUADRATURE: [[&str; 2]; 8] = [
    [
        r"\int_0^\infty \frac{x^3}{e^x - 1} \, dx = \frac{\pi^4}{15}",
        r"\int_0^\infty \frac{x^3}{e^x - 1} \, dx = \frac{\pi^4}{12}",
    ],
    [
        r"\int_0^\infty \frac{\rho^3 \, d\rho}{e^{\beta\rho} - 1} = \frac{\pi^4}{15\beta^4}",
        r"\int_0^\infty \frac{\rho^3 \, d\rho}{e^{\beta\rho} - 1} = \frac{\pi^4}{15\beta^3}",
    ],
    [
        r"\int_{-\infty}^\infty \frac{dx}{x^4 + b^4} = \frac{\pi}{\sqrt2 b^3}",
        r"\int_{-\infty}^\infty \frac{dx}{x^4 + b^4} = \frac{\pi}{2 b^3}",
    ],
    [
        r"\int_0^{2\pi} \frac{d\gamma}{a + b + a\cos\gamma} = \frac{2\pi}{\sqrt{b(2a + b)}}",
        r"\int_0^{2\pi} \frac{d\gamma}{a + b + a\cos\gamma} = \frac{2\pi}{\sqrt{b(a + b)}}",
    ],
    [r"\int_0^l x\ln(x/l) \, dx = -\frac{l^2}{4}", r"\int_0^l x\ln(x/l) \, dx = -\frac{l^2}{2}"],
    [
        r"\int_1^\infty \frac{dx}{x(x + b)} = \frac{\ln(1 + b)}{b}",
        r"\int_0^\infty \frac{dx}{x(x + b)} = \frac{\ln(1 + b)}{b}",
    ],
    [
        r"\frac{\partial}{\partial b} \int_0^\infty \frac{x}{e^{b x} + 1} \, dx = -\frac{\pi^2}{6 b^3}",
        r"\frac{\partial}{\partial b} \int_0^\infty \frac{x}{e^{b x} + 1} \, dx = -\frac{\pi^2}{12 b^3}",
    ],
    // The letter is a name of its own, also where an end has that name.
    [
        r"\int_0^x \frac{dx}{e^x + e^{-x}} = \arctan(e^x) - \frac{\pi}{4}",
        r"\int_0^x \frac{dx}{e^x + e^{-x}} = \arctan(e^x)",
    ],
];

#[test]
fn an_integral_without_a_known_antiderivative_has_a_value_and_no_certificate() {
    let judge = |which: usize| {
        let displays: Vec<&str> = BY_QUADRATURE.iter().map(|pair| pair[which]).collect();
        let found = document(&letters(), &numbered(&displays), &Registry::standard(), None).unwrap();
        found.equations.into_iter().map(|equation| equation.finding).collect::<Vec<_>>()
    };
    for (pair, finding) in BY_QUADRATURE.iter().zip(judge(0)) {
        assert_eq!(finding.verdict, Verified, "{}: {}", pair[0], finding.message);
    }
    // One of the slips makes an integral that has no value.
    for (pair, finding) in BY_QUADRATURE.iter().zip(judge(1)) {
        let wanted = if pair[1].contains(r"\int_0^\infty \frac{dx}{x(x") { Undecided } else { Refuted };
        assert_eq!(finding.verdict, wanted, "{}: {}", pair[1], finding.message);
    }
}

#[test]
fn an_integral_whose_sums_do_not_converge_decides_nothing() {
    let open = [
        r"\int_{-1}^{1} \frac{dx}{x^2} = -2",
        r"\int_{-1}^{2} \frac{dx}{x} = \ln 2",
        r"\int_0^\infty \frac{\sin x}{x} \, dx = \frac{\pi}{3}",
        r"\int_0^\infty \frac{dx}{\sqrt{x^2 + a^2}} = a",
    ];
    let found = document(&letters(), &numbered(&open), &Registry::standard(), None).unwrap();
    for (latex, equation) in open.iter().zip(&found.equations) {
        assert!(matches!(outcome(&equation.finding), Undecided | Unreadable), "{latex}: {}", equation.finding.message);
    }
    // must-fail case: near one of these, and finite
    let near = [r"\int_{1}^{2} \frac{dx}{x^2 + \sqrt{x}} = 1"];
    let found = document(&letters(), &numbered(&near), &Registry::standard(), None).unwrap();
    assert_eq!(outcome(&found.equations[0].finding), Refuted);
}

/// A function without a formula is drawn as a polynomial, for which rules with few points are exact.
#[test]
fn a_function_without_a_formula_is_not_integrated() {
    let claims = json!({
        "constants": { "a, b, n, x, y, z": "any" }, "functions": { "V": "of x", "W": "of x, y", "U": "of x, y, z" },
    });
    let judge = |latex: &str| {
        let found = document(&claims, &numbered(&[latex]), &Registry::standard(), None).unwrap();
        outcome(&found.equations[0].finding)
    };
    let (near, far) = (r"\sqrt{\frac37 - \frac27 \sqrt{\frac65}}", r"\sqrt{\frac37 + \frac27 \sqrt{\frac65}}");
    let of_gauss = format!(
        r"\int_{{-1}}^{{1}} V(x) \, dx = \frac{{18 + \sqrt{{30}}}}{{36}} \left(V({near}) + V(-{near})\right)
        + \frac{{18 - \sqrt{{30}}}}{{36}} \left(V({far}) + V(-{far})\right)"
    );
    for rule in [
        of_gauss.as_str(),
        r"\int_{-1}^{1} W(x, y) \, dx = \frac59 W(-\sqrt{3/5}, y) + \frac89 W(0, y) + \frac59 W(\sqrt{3/5}, y)",
        r"\int_0^1 U(x, y, z) \, dx = \frac16 \left(U(0, y, z) + 4 U(\frac12, y, z) + U(1, y, z)\right)",
        r"\int_0^1 V(y) \, dy = \int_0^1 V(x) \, dx",
        r"\int_0^1 x V'(x) \, dx = V(1) - \int_0^1 V(x) \, dx",
        r"\sum_{k=1}^{n} V(k) = 0",
    ] {
        assert_eq!(judge(rule), Unreadable, "{rule}");
    }
    // An integral of a derivative is the difference of the function for every function.
    for (holds, slip) in [
        (r"\int_a^b V'(x) \, dx = V(b) - V(a)", r"\int_a^b V'(x) \, dx = V(a) - V(b)"),
        (r"\int_a^x V'(y) \, dy = V(x) - V(a)", r"\int_a^x V'(y) \, dy = V(x)"),
        (r"\int_a^b V''(x) \, dx = V'(b) - V'(a)", r"\int_a^b V''(x) \, dx = V(b) - V(a)"),
        // What does not depend on the letter is a number.
        (r"\int_a^b y V(x) \, dy = \frac{b^2 - a^2}{2} V(x)", r"\int_a^b y V(x) \, dy = \frac{b^2 + a^2}{2} V(x)"),
    ] {
        assert_eq!(judge(slip), Refuted, "{slip}");
        assert_eq!(judge(holds), Verified, "{holds}");
    }
}

/// Nine coefficients stand for a function of one variable, and obey equations among ten values that other functions do not.
#[test]
fn a_function_without_a_formula_is_not_taken_for_a_polynomial() {
    let claims = json!({
        "constants": { "a, h, x, y": "any" }, "functions": { "V": "of x", "W": "of x, y" },
    });
    let judge = |latex: &str| {
        let found = document(&claims, &numbered(&[latex]), &Registry::standard(), None).unwrap();
        outcome(&found.equations[0].finding)
    };
    let difference = |n: u64| {
        let choose = |k: u64| (0..k).fold(1, |c, i| c * (n - i) / (i + 1));
        let term = |k: u64| format!("{} {} V(x + {k} h)", if (n - k).is_multiple_of(2) { "+" } else { "-" }, choose(k));
        (0..=n).map(term).collect::<String>()
    };
    for (of_polynomials, verdict) in [
        (format!("0 {} = 0", difference(9)), Undecided),
        (r"\frac{d^4}{dx^4} V'''(x) = \frac{d^4}{da^4} V'''(a)".to_owned(), Refuted),
        (r"\frac{d^4}{dx^4} V''''(x) = 0".to_owned(), Unreadable),
        (r"\frac{\partial^2}{\partial x^2} \frac{\partial^3 W}{\partial y^3} = 0".to_owned(), Unreadable),
    ] {
        assert_eq!(judge(&of_polynomials), verdict, "{of_polynomials}");
    }
    for of_all in [
        r"V(x)^2 - V(x + h)^2 = (V(x) - V(x + h))(V(x) + V(x + h))",
        r"\frac{d}{dx}\left(x V'(x + h)\right) = V'(x + h) + x V''(x + h)",
        r"\frac{d^2}{dx^2}\left(V(a x) V(x)\right) = a^2 V''(a x) V(x) + 2 a V'(a x) V'(x) + V(a x) V''(x)",
        r"\frac{\partial}{\partial x} \left(x W(x + h, y)\right) = W(x + h, y) + x \frac{\partial}{\partial x} W(x + h, y)",
    ] {
        assert_eq!(judge(of_all), Verified, "{of_all}");
    }
}
