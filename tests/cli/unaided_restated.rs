//! Notes without a claims file that say in words what a display is: the sum of what stands before, or a consequence in the case that the
//! sentence states. Each page is true as printed; with one edit a display is wrong.

use crate::support;

/// The verdicts on the displays of a page.
fn verdicts(name: &str, notes: &str) -> Vec<String> {
    support::verdicts(&format!("unaided-restated-{name}"), notes)
}

/// Pages that are true, and an edit that makes the last display wrong.
const PAGES: [(&str, &str, &str, &str); 8] = [
    (
        "sum",
        r"The energy of the field inside and outside is

$$ W_i = \frac{Q^2}{40 \pi \epsilon R} $$

$$ W_o = \frac{Q^2}{8 \pi \epsilon R} $$

so outside there is more. The sum is

$$ W = \frac{3 Q^2}{20 \pi \epsilon R} $$
",
        r"{20 \pi",
        r"{10 \pi",
    ),
    (
        "case",
        r"A chain with $\lambda$ per length falls on a scale, with $v = \dot x$. The kinetic energy of what hangs is

$$ K = \frac12 \lambda (l - x) v^2 $$

and the potential one

$$ V = \frac12 \lambda g x^2 $$

When the piece $x$ has arrived, the links hit with the speed of free fall, $v^2 = 2 g x$. The scale carries

$$ F = \lambda g x + \lambda v^2 = 3 \lambda g x $$
",
        r"3 \lambda",
        r"2 \lambda",
    ),
    (
        "list",
        r"For a round drum

$$ \int_0^1 4 r^2 \, r \, dr = 1 , \qquad \int_0^1 (1 - r^2)^2 \, r \, dr = \frac16 $$
",
        r"\frac16",
        r"\frac13",
    ),
    (
        "list-of-sums",
        r"We need the integrals

$$ A = \int_0^a x \, dx , \qquad \int_0^2 x^3 \, dx = 4 $$
",
        r"= 4",
        r"= 8",
    ),
    (
        "rounded",
        r"The motor has

$$ k = \frac{K}{R b + K^2} , \qquad \tau = \frac{R J}{R b + K^2} $$

and with its numbers

$$ k = \frac{0.05}{0.0035} \approx 14.3 , \qquad \tau = \frac{2 \cdot 0.01}{0.0035} \approx 5.7 $$
",
        r"\approx 5.7",
        r"\approx 0.57",
    ),
    (
        "french",
        r"On note

$$ s = x + y $$

$$ d = x - y $$

L'énergie est

$$ E = \frac12 k \left( x^2 + y^2 \right) + \frac12 K (y - x)^2 $$

soit, avec $s$ et $d$,

$$ E = \frac14 k s^2 + \frac14 (k + 2 K) d^2 $$
",
        r"\frac14 (k",
        r"\frac12 (k",
    ),
    (
        "form",
        r"The sum is

$$ Z = \sum_{n=0}^\infty e^{-b w (n + 1/2)} = \frac{e^{-b w/2}}{1 - e^{-b w}} $$

In a more symmetric form

$$ Z = \frac{1}{2 \sinh(b w/2)} $$
",
        r"\sinh",
        r"\cosh",
    ),
    (
        "divided",
        r"The motion obeys

$$ P V = N k T , \qquad P V^2 = N a $$

Dividing one by the other we find

$$ V = \frac{a}{k T} $$
",
        r"\frac{a}{k T}",
        r"\frac{k T}{a}",
    ),
];

#[test]
fn what_the_words_say_of_a_display_is_compared_with_it() {
    for (name, notes, from, to) in PAGES {
        let right = verdicts(name, notes);
        assert!(right.iter().all(|verdict| verdict != "refuted"), "{name}: {right:?}");
        assert_eq!(notes.matches(from).count().max(1), notes.matches(from).count(), "{name}: {from} is there");
        let at = notes.rfind(from).expect("the printed part");
        let wrong = format!("{}{to}{}", &notes[..at], &notes[at + from.len()..]);
        let wrong = verdicts(&format!("{name}-slip"), &wrong);
        assert_eq!(wrong.last().map(String::as_str), Some("refuted"), "{name}: {wrong:?}");
        let others = &wrong[..wrong.len() - 1];
        assert!(others.iter().all(|verdict| verdict != "refuted"), "{name}: {wrong:?}");
    }
}

/// True pages that resemble these: another body, another direction, another case, another limit.
#[test]
fn another_case_in_the_words_is_not_called_wrong() {
    for (name, notes) in [
        ("ring", "The moment of inertia $I = \\frac12 m R^2$ of a disc becomes that of a ring,\n\n$$ I = m R^2 $$\n"),
        (
            "partial-sum",
            "The two parts are\n\n$$ W_1 = \\frac12 k a^2 $$\n\n$$ W_2 = \\frac12 k b^2 $$\n\nand their geometric mean is\n\n$$ W = \\frac12 k a b $$\n",
        ),
        (
            "later-display",
            "The chain hangs,\n\n$$ V = \\frac12 \\lambda g x^2 $$\n\nWhen it falls freely, $v^2 = 2 g x$, and the scale carries\n\n$$ F = \\lambda g x + \\lambda v^2 = 3 \\lambda g x $$\n\nWith a speed of its own it would carry\n\n$$ F = \\lambda g x + \\lambda v^2 = \\lambda (g x + v^2) $$\n",
        ),
        (
            "rounded",
            "The numbers are\n\n$$ \\tau = \\frac{2 \\cdot 0.01}{0.0035} \\approx 5.7 \\approx 6 , \\qquad k = \\frac{0.05}{0.0035} \\approx 14 $$\n",
        ),
    ] {
        let found = verdicts(name, notes);
        assert!(found.iter().all(|verdict| verdict != "refuted"), "{name}: {found:?}");
    }
}

/// Two displays that contradict one premise, and would follow with a number that it lost: the premise is wrong, and they are not.
#[test]
fn a_lost_number_of_a_premise_is_not_blamed_on_what_follows_from_it() {
    let page = |imaginary: &str| {
        format!(
            "The wave number is complex. The real and the imaginary part are\n\n$$ p^2 - q^2 = a $$\n\n$$ {imaginary} = b $$\n\nSolving for the two unknowns one finds\n\n$$ p^2 = \\frac{{\\sqrt{{a^2 + b^2}} + a}}{{2}} $$\n\n$$ q^2 = \\frac{{\\sqrt{{a^2 + b^2}} - a}}{{2}} $$\n"
        )
    };
    let right = verdicts("premise", &page("2 p q"));
    assert!(right.iter().all(|verdict| verdict != "refuted"), "{right:?}");
    let wrong = verdicts("premise-slip", &page("p q"));
    assert!(wrong[2..].iter().all(|verdict| verdict != "refuted"), "{wrong:?}");
}

/// What two relations one after the other give is searched for slips. Where a sign in one of these explains it too, the report says that
/// one of the two is wrong.
#[test]
fn a_slip_in_what_two_relations_give_is_not_taken_for_granted() {
    let page = |sign: &str| {
        format!(
            "Conservation of energy and momentum requires\n\n$$ q^2 c^2 = E^2 + F^2 - 2 E F \\cos\\varphi $$\n\n$$ q^2 c^2 = (E - F + m c^2)^2 - m^2 c^4 $$\n\nExpand the square and subtract:\n\n$$ E F (1 {sign} \\cos\\varphi) = m c^2 (E - F) $$\n"
        )
    };
    assert_eq!(verdicts("pair", &page("-")), ["assumed", "assumed", "verified"]);
    let wrong = verdicts("pair-slip", &page("+"));
    assert!(["refuted", "undecided"].contains(&wrong[2].as_str()), "{wrong:?}");
}
