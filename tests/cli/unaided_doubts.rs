//! Notes without a claims file in which something would hold, or fail, only by a reading that the author does not mean: derivatives of
//! what has no formula, letters of integrals that vary, another system, another law in the place of one.

use crate::support;
use crate::unaided::page;

fn verdicts(name: &str, notes: &str) -> Vec<String> {
    support::verdicts(&format!("unaided-doubts-{name}"), notes)
}

fn holds(verdict: &str) -> bool {
    ["certified", "verified"].contains(&verdict)
}

/// Each of the two displays lacks a name of the other one. No derivative is 0 for that.
#[test]
fn displays_that_wait_for_names_of_each_other_are_read() {
    let wave = |factor: &str| {
        page(&[
            &format!(
                r"\frac{{\partial^2 u}}{{\partial t^2}} = {factor} \frac{{\partial^2 u}}{{\partial x^2}}, \qquad c = \sqrt{{\frac{{S}}{{\rho}}}}"
            ),
            r"u(x,t) = A \sin(k x - \omega t), \qquad \omega = c k",
        ])
    };
    // The first defines c too.
    assert_eq!(verdicts("wave", &wave("c^2")), ["definition", "definition"]);
    let slip = verdicts("wave-slip", &wave("-7 c"));
    assert!(!holds(&slip[0]) && slip[0] != "definition", "{slip:?}");
    assert_eq!(slip[1], "definition", "{slip:?}");
}

/// L has no q, so nothing is known of its derivatives by q. By a cyclic coordinate the derivative of L is 0.
#[test]
fn a_derivative_by_a_letter_that_the_formula_does_not_contain_is_not_zero() {
    let pendulum = r"L = \frac12 m l^2 \dot\theta^2 + m g l\cos\theta";
    let equation = |q: &str, sign: &str| {
        format!(
            r"\frac{{d}}{{dt}}\frac{{\partial L}}{{\partial \dot {q}}} {sign} \frac{{\partial L}}{{\partial {q}}} = 0"
        )
    };
    let second = |name: &str, q: &str, sign: &str| {
        verdicts(name, &page(&[pendulum, &equation(q, sign)])).pop().unwrap_or_default()
    };
    for sign in ["-", "+"] {
        assert_eq!(second("general", "q", sign), "definition", "{sign}");
    }
    assert_eq!(second("own", r"\theta", "-"), "certified");
    assert!(!holds(&second("own-slip", r"\theta", "+")));
    let orbit = r"L = \frac12 m (\dot r^2 + r^2\dot\varphi^2) + \frac{k}{r}";
    assert_eq!(
        verdicts("cyclic", &page(&[orbit, r"\frac{\partial L}{\partial\varphi} = 0"])),
        ["definition", "certified"]
    );
}

/// A correction by which the first equality says nothing, and the second one fails, is none.
#[test]
fn a_correction_spares_the_other_equalities_of_a_chain() {
    let rod = |chain: &str| {
        format!(
            "The pendulum has the moment of inertia\n\n$$ I = M (k^2 + s^2) $$\n\nand the length\n\n$$ l = s + \\frac{{k^2}}{{s}} $$\n\n\
             For a uniform rod of length $a$ we have\n\n$$ k^2 = {chain} $$\n"
        )
    };
    let found = |name: &str, chain: &str| verdicts(name, &rod(chain)).pop().unwrap_or_default();
    assert_eq!(found("rod", r"\frac{1}{a} \int_{-a/2}^{a/2} x^2 \, dx = \frac{a^2}{12}"), "assumed");
    // must-fail cases
    assert_eq!(found("rod-limit", r"\frac{1}{a} \int_{0}^{a/2} x^2 \, dx = \frac{a^2}{12}"), "refuted");
    assert_eq!(found("rod-value", r"\frac{1}{a} \int_{-a/2}^{a/2} x^2 \, dx = \frac{a^2}{6}"), "refuted");
}

/// The notes say that the letter depends on that of the integral, or an equation of state does.
#[test]
fn an_integral_over_a_letter_that_may_vary_proves_nothing() {
    let last = |name: &str, notes: &str| verdicts(name, notes).pop().unwrap_or_default();
    let star = |mass: &str| {
        format!(
            "The mass inside of the radius $r$ is {mass}. The energy is\n\n$$ E = -G\\int_0^M \\frac{{m}}{{r}}\\,dm $$\n\n\
             so that\n\n$$ E = -\\frac{{G M^2}}{{2 r}} $$\n"
        )
    };
    assert_eq!(last("star", &star("$m(r)$")), "undecided");
    assert_eq!(last("shell", &star("$m$")), "certified");
    let rod = |words: &str| format!("{words} The heat is\n\n$$ Q = \\int_0^l c\\,T\\,dx $$\n\n$$ Q = c\\,T\\,l $$\n");
    assert_eq!(last("rod-falls", &rod("The temperature $T$ falls along the rod.")), "undecided");
    assert_eq!(last("rod-even", &rod("The temperature of the rod is $T$.")), "certified");
    let gas = |words: &str| {
        format!(
            "$$ p V = n R T $$\n\n{words}\n\n$$ W = \\int_{{V_1}}^{{V_2}} p\\,dV $$\n\nhence\n\n$$ W = p (V_2 - V_1) $$\n"
        )
    };
    assert!(!holds(&last("gas", &gas("The work of the gas is"))));
    assert!(holds(&last("isobar", &gas("At constant pressure the work of the gas is"))));
}

/// One letter for the frequencies of two systems equates nothing, where a label says that the second is another one.
#[test]
fn one_letter_of_two_systems_equates_nothing() {
    let springs = |label: &str| {
        format!(
            "The force of the spring is\n\n$$ \\omega = \\sqrt{{\\frac{{k}}{{m}}}} $$\n\n{label}\n\n$$ \\omega = \\sqrt{{\\frac{{g}}{{L}}}} $$\n\n\
             $$ \\frac{{k}}{{m}} = \\frac{{g}}{{L}} $$\n"
        )
    };
    assert!(!holds(&verdicts("two-systems", &springs("Pendulum:"))[2]));
    assert!(holds(&verdicts("one-system", &springs("This must be the frequency of the pendulum, so"))[2]));
}

/// What follows from a law holds no more where the words put another law in its place, unless they name it.
#[test]
fn a_law_that_is_replaced_proves_nothing() {
    let rocket = |with_gravity: &str, velocity: &str| {
        format!(
            "In free space\n\n$$ m \\frac{{dv}}{{dt}} = - u \\frac{{dm}}{{dt}} \\tag{{1}} $$\n\nIntegrating gives\n\n\
             $$ v = u \\ln \\frac{{m_0}}{{m}} \\tag{{2}} $$\n\nThe fuel burns at a constant rate, hence\n\n\
             $$ m(t) = m_0 - \\mu t \\tag{{3}} $$\n\n{with_gravity}The velocity is then\n\n$$ v(t) = {velocity} \\tag{{5}} $$\n"
        )
    };
    let gravity = "With gravity (1) is replaced by\n\n$$ m \\dot v = \\mu u - m g \\tag{4} $$\n\n";
    let lost = r"- u \ln\left( 1 - \frac{\mu t}{m_0} \right)";
    let last = |name: &str, notes: &str| verdicts(name, notes).pop().unwrap_or_default();
    assert!(!holds(&last("rocket-lost", &rocket(gravity, lost))));
    assert_ne!(last("rocket", &rocket(gravity, &format!("{lost} - g t"))), "refuted");
    assert!(holds(&last("rocket-free", &rocket("", lost))));
}

/// "Suppose now the force is …": what was supposed before refutes nothing.
#[test]
fn what_is_supposed_anew_is_not_judged_by_what_was() {
    let spring = |words: &str| {
        format!(
            "Newton's second law gives\n\n$$ \\ddot x + \\frac{{k}}{{m}} x = 0 $$\n\n{words} Let $x_e = F_0/k$ and $z = x - x_e$. \
             Substitute $x = z + x_e$:\n\n$$ m \\ddot z = -k (z + x_e) + F_0 $$\n"
        )
    };
    assert_eq!(verdicts("anew", &spring("Suppose now the force is $F = -k x + F_0$."))[1], "assumed");
    assert_eq!(verdicts("as-before", &spring(""))[1], "refuted");
}

/// `V = …, \quad \alpha, n > 0` is a definition, also where a later example gives V another formula.
#[test]
fn a_range_of_several_names_takes_nothing_from_a_definition() {
    let examples = |first: &str| {
        page(&[
            r"L = \frac12 \mu (\dot r^2 + r^2 \dot\theta^2) - V(r)",
            r"V(r) = -\frac{\alpha}{r^n},\quad \alpha,n > 0",
            &format!(r"f(r) = -V'(r) = {first}"),
            r"V(r) = \alpha r^n",
            r"f(r) = -V'(r) = -\alpha n r^{n-1}",
        ])
    };
    let found = verdicts("potentials", &examples(r"-\frac{\alpha n}{r^{n+1}}"));
    assert!(holds(&found[2]) && holds(&found[4]), "{found:?}");
    assert_eq!(verdicts("potentials-slip", &examples(r"\frac{\alpha n}{r^{n+1}}"))[2], "refuted");
}

/// The place of the extremum of one potential is not that of the next one.
#[test]
fn a_place_of_an_earlier_example_is_another_one() {
    let orbit = |end: &str| {
        format!(
            "First example.\n\n$$ U(r) = \\frac{{l^2}}{{2\\mu r^2}} - \\frac{{\\alpha}}{{r^n}} $$\n\n\
             $$ U'(r) = -\\frac{{l^2}}{{\\mu r^3}} + \\frac{{\\alpha n}}{{r^{{n+1}}}} = 0 $$\n\nat\n\n\
             $$ r_m = \\left(\\frac{{l^2}}{{n\\alpha \\mu}}\\right)^{{\\frac{{1}}{{2-n}}}} $$\n\n{end}"
        )
    };
    let second = "Second example.\n\n$$ U(r) = \\frac{l^2}{2\\mu r^2} + \\alpha r^n $$\n\nA circular orbit needs\n\n\
                  $$ U'(r_m) = -\\frac{l^2}{\\mu r_m^3} + \\alpha n r_m^{n-1} = 0 $$\n\nthat is\n\n\
                  $$ \\alpha n r_m^{n+2} = \\frac{l^2}{\\mu} $$\n";
    assert_ne!(verdicts("places", &orbit(second)).pop().unwrap_or_default(), "refuted");
    // In the first example it is what it was.
    assert!(holds(&verdicts("place", &orbit("that is\n\n$$ n \\alpha \\mu r_m^{2-n} = l^2 $$\n"))[3]));
}

/// "A constant deceleration of magnitude $a$" is constant, also where an acceleration is a.
#[test]
fn what_a_sentence_calls_constant_does_not_vary() {
    let bus = |words: &str, value: &str| {
        format!(
            "A bus with the speed $v_0$ {words} $a$. In its frame\n\n$$ L = \\frac{{1}}{{2}} m (\\dot x + v_0 - a t)^2 $$\n\n\
             $$ \\frac{{d}}{{dt}} \\left(\\frac{{\\partial L}}{{\\partial \\dot x}}\\right) = {value} $$\n\n\
             $$ m(\\ddot x - a) = 0 \\quad \\Rightarrow \\quad \\frac{{d^2 x}}{{dt^2}} = a $$\n"
        )
    };
    let found = |words: &str, value: &str| verdicts("bus", &bus(words, value))[1].clone();
    assert_eq!(found("has a constant deceleration of magnitude", r"m (\ddot x - a)"), "certified");
    assert_eq!(found("has a constant deceleration of magnitude", r"m (\ddot x + a)"), "refuted");
}

/// A constraint with the name g says nothing of the dimension of gravity.
#[test]
fn the_name_of_a_constraint_has_no_dimension_of_its_own() {
    let found = verdicts(
        "constraint",
        &page(&[
            r"g(\rho ,z)=\rho ^{2}-az=0",
            r"2 m_{2} \dot{r} \dot{\theta}+r^{2} m_{2} \ddot{\theta}+m_{2} g r \sin \theta=0",
            r"\Lambda _{\phi }L=\frac{d}{dt}\left[ m_{1}\left( l-r\right) ^{2}\dot{\phi} \right] =0",
            r"L=\frac{1}{2}(M+2m)(\dot{x}^{2}+\dot{y}^{2}+\dot{z}^{2})+m(\dot{r}^{2}+r^{2} \dot{\theta}^{2})+\frac{1}{24}ML^{2}\dot{\theta}^{2}-K(r-r_{0})^{2}",
        ]),
    );
    assert!(found.iter().all(|verdict| verdict != "refuted"), "{found:?}");
}
