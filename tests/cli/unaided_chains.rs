//! Notes without a claims file: the equalities of chains one by one, sides that are multiples of each other, what follows from a
//! slip, and numbers that are put into a formula.

use serde_json::Value;

use crate::support::Desk;

/// The verdict and the first replacement of each display of notes.
fn findings(name: &str, notes: &str) -> Vec<(String, Option<String>)> {
    let desk = Desk::new(&format!("chains-{name}"));
    desk.write("notes.md", notes);
    let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err));
    let equations = report["documents"][0]["equations"].as_array().expect("a list");
    let text = |value: &Value| value.as_str().map(str::to_owned);
    let one = |found: &Value| (text(&found["verdict"]).unwrap_or_default(), text(&found["repairs"][0]["replacement"]));
    equations.iter().map(one).collect()
}

/// The verdicts of notes, of which the text in angle quotes is replaced.
fn verdicts(name: &str, notes: &str, (from, to): (&str, &str)) -> Vec<String> {
    assert_eq!(notes.matches(from).count(), 1, "{name}: {from}");
    findings(name, &notes.replace(from, to)).into_iter().map(|(verdict, _)| verdict).collect()
}

fn right(name: &str, notes: &str) -> Vec<String> {
    findings(&format!("{name}-right"), notes).into_iter().map(|(verdict, _)| verdict).collect()
}

const PHASES: &str = r"For a free particle

$$ \omega(k) = \frac{\hbar k^2}{2m} $$

The velocity of the phase at $k_0$ is half of the group velocity $v_0 = \hbar k_0/m$:

$$ \frac{\omega(k_0)}{k_0} = \frac{\hbar k_0}{2m} = \frac{v_0}{2} . $$
";

#[test]
fn each_equality_of_a_chain_is_judged() {
    assert_eq!(right("phases", PHASES), ["definition", "certified"]);
    assert_eq!(verdicts("first", PHASES, (r"= \frac{\hbar k_0}{2m}", r"= \frac{\hbar k_0}{m}"))[1], "refuted");
    assert_eq!(verdicts("last", PHASES, (r"\frac{v_0}{2}", r"\frac{v_0}{3}"))[1], "refuted");
}

const MEANS: &str = r"The momentum has

$$ \langle p^2 \rangle = \hbar^2 k_0^2 + \frac{\hbar^2}{4\sigma^2} , $$

and the energy

$$ \langle H \rangle = \frac{\langle p^2 \rangle}{2m} = \frac{\hbar^2 k_0^2}{2m} + \frac{\hbar^2}{8 m \sigma^2} . $$

The rate of the mean square of the place is

$$ \frac{d}{dt} \langle p^2 \rangle = 0 . $$
";

#[test]
fn a_mean_that_a_display_gives_is_defined_by_it() {
    let found = right("means", MEANS);
    assert_eq!(found[0], "definition");
    assert!(["definition", "certified", "verified"].contains(&found[1].as_str()), "{found:?}");
    assert!(["certified", "verified"].contains(&found[2].as_str()), "{found:?}");
    let wrong = verdicts("means", MEANS, ("{8 m", "{4 m"));
    assert!(["refuted", "undecided"].contains(&wrong[1].as_str()) && wrong != found, "{wrong:?}");
    let rate = verdicts("mean-rate", MEANS, (r"\rangle = 0 .", r"\rangle = \hbar k_0 ."));
    assert_ne!(rate[2], found[2]);
}

const CRITICAL: &str = r"The critical point is

$$ v_c = 3 b , \qquad T_c = \frac{8 a}{27 R b} , \qquad p_c = \frac{a}{27 b^2} $$

Together

$$ \frac{p_c v_c}{R T_c} = \frac38 $$

If $I_0$ is the intensity on the axis, the power is

$$ P = \int_0^\infty I_0 e^{-2 r^2/w^2} \, 2 \pi r \, dr = \frac12 \pi w^2 I_0 . $$
";

#[test]
fn a_side_that_is_a_multiple_of_the_other_is_wrong() {
    let found = right("factors", CRITICAL);
    assert_eq!(found[1], "certified");
    assert!(["verified", "certified"].contains(&found[2].as_str()), "{found:?}");
    assert_eq!(verdicts("number", CRITICAL, (r"\frac38", r"\frac83"))[1], "refuted");
    assert_eq!(verdicts("integral", CRITICAL, (r"\frac12 \pi w^2", r"\pi w^2"))[2], "refuted");
}

#[test]
fn a_rounded_number_or_another_meaning_of_a_name_is_no_multiple() {
    assert_ne!(verdicts("rounded", CRITICAL, (r"\frac38", "0.38"))[1], "refuted");
    let disc = r"For a disc

$$ I = \frac12 M R^2 $$

and for a sphere

$$ I = \frac25 M R^2 $$
";
    assert!(!right("bodies", disc).contains(&"refuted".to_owned()));
    let energy = disc.replace("I = \\frac25 M R^2", "\\frac12 I \\omega^2 = \\frac15 M R^2 \\omega^2");
    assert!(!right("energies", &energy).contains(&"refuted".to_owned()));
    // Of one body it is a claim.
    assert_ne!(right("one", &energy.replace("and for a sphere", "and so")), right("energies", &energy));
}

const WHEELS: &str = r"The wheels give

$$ v_R = r \omega_R , \qquad v_L = r \omega_L $$

$$ v = \frac{v_R + v_L}{2} $$

$$ \omega = \frac{v_R - v_L}{b} $$

Solve these equations:

$$ \omega_R = \frac{1}{r} \left( v + \frac{b}{2} \omega \right) $$

$$ \omega_L = \frac{1}{r} \left( v - \frac{b}{2} \omega \right) $$
";

#[test]
fn equations_that_are_solved_for_their_names_are_claims() {
    assert!(!right("wheels", WHEELS).contains(&"refuted".to_owned()));
    let wrong = verdicts("wheels", WHEELS, (r"v - \frac{b}{2} \omega", r"v - b \omega"));
    assert_eq!(wrong.last().map(String::as_str), Some("refuted"), "{wrong:?}");
}

const FILM: &str = r"Gravity is balanced by viscosity,

$$ \eta \frac{d^2 u}{dy^2} = - \rho g . $$

One integration yields

$$ \frac{du}{dy} = \frac{\rho g}{\eta} (h - y) $$

and another one

$$ u(y) = \frac{\rho g}{\eta} \left( h y - \frac{y^2}{2} \right) . $$

The flow is

$$ q = \int_0^h u(y) \, dy = \frac{\rho g h^3}{3 \eta} . $$
";

#[test]
fn what_follows_from_a_slip_is_not_called_wrong() {
    assert!(!right("film", FILM).contains(&"refuted".to_owned()));
    let wrong = verdicts("film", FILM, (r"\frac{y^2}{2}", "y^2"));
    let refuted: Vec<usize> = (0..wrong.len()).filter(|at| wrong[*at] == "refuted").collect();
    assert_eq!(refuted, [2], "{wrong:?}");
    let flow = verdicts("flow", FILM, (r"{3 \eta}", r"{2 \eta}"));
    let refuted: Vec<usize> = (0..flow.len()).filter(|at| flow[*at] == "refuted").collect();
    assert_eq!(refuted, [3], "{flow:?}");
}

const RAMP: &str = r"A crate with $m = 2.00\,\mathrm{kg}$ and the speed $v = 4.39\,\mathrm{m/s}$ meets a spring with
$k = 800\,\mathrm{N/m}$; $\mu = 0.200$, $\theta = 30^\circ$, and $g = 9.81\,\mathrm{m/s^2}$. The contact lasts for

$$ t_c = \pi \sqrt{\frac{m}{k}} = \pi \times 0.0500\,\mathrm{s} = 0.157\,\mathrm{s} . $$

It climbs the distance

$$ d = \frac{v^2}{2 g (\sin\theta + \mu \cos\theta)}
   = \frac{(4.386\,\mathrm{m/s})^2}{2 \times 9.81\,\mathrm{m/s^2} \times 0.6732} = 1.46\,\mathrm{m} . $$
";

#[test]
fn numbers_are_compared_with_the_formula_into_which_they_are_put() {
    assert_eq!(right("ramp", RAMP), ["verified", "verified"]);
    for (name, at, from, to) in [
        ("fraction", 0, r"\frac{m}{k}", r"\frac{k}{m}"),
        ("sign", 1, r"\sin\theta + \mu", r"\sin\theta - \mu"),
        ("number", 1, r"v^2}{2 g", r"v^2}{4 g"),
    ] {
        let found = findings(name, &RAMP.replace(from, to));
        assert_eq!(found[at].0, "refuted", "{name}: {found:?}");
        assert_eq!(found[1 - at].0, "verified", "{name}: {found:?}");
    }
    // What is off by more than one part in a hundred does not agree.
    assert_ne!(verdicts("off", RAMP, ("k = 800", "k = 830"))[0], "verified");
    // Numbers of another example, which no slip explains, are not called wrong.
    assert_ne!(verdicts("other", RAMP, ("m = 2.00", "m = 3.37"))[0], "refuted");
}

const CRITICAL_NUMBERS: &str = r"The critical temperature is

$$ T_c = \frac{8 a}{27 R b} . $$

For nitrogen, $a = 0.137\,\mathrm{Pa\,m^6/mol^2}$, $b = 3.87 \cdot 10^{-5}\,\mathrm{m^3/mol}$ and
$R = 8.314\,\mathrm{J/(mol\,K)}$, that is

$$ T_c = \frac{8 \cdot 0.137}{27 \cdot 8.314 \cdot 3.87 \cdot 10^{-5}}\,\mathrm{K} \approx 126\,\mathrm{K} . $$
";

#[test]
fn numbers_contradict_a_definition() {
    assert!(!right("nitrogen", CRITICAL_NUMBERS).contains(&"refuted".to_owned()));
    let wrong = findings("nitrogen", &CRITICAL_NUMBERS.replace("8 a}", "4 a}"));
    assert_eq!((wrong[0].0.as_str(), wrong[0].1.as_deref()), ("refuted", Some("8")), "{wrong:?}");
}

#[test]
fn a_wrong_number_in_one_of_two_statements_is_found() {
    let notes = r"With these values

$$ k_m = \frac{K}{R} , \qquad \tau = \frac{2 \cdot 0.01}{0.0035} \approx 5.7 . $$
";
    assert!(!right("two", notes).contains(&"refuted".to_owned()));
    assert_eq!(verdicts("two", notes, ("5.7 .", "0.57 ."))[0], "refuted");
}

const WHEEL: &str = r"The power on the wheel is

$$ P(u) = \rho Q u (v - u) (1 - \cos\vartheta) . $$

The derivative with respect to $u$ vanishes at $u = v/2$, and there

$$ P_{\max} = \frac14 \rho Q v^2 (1 - \cos\vartheta) . $$
";

#[test]
fn a_value_at_a_place_in_words_is_compared_with_the_formula_there() {
    assert_eq!(right("wheel", WHEEL)[1], "verified");
    assert_eq!(verdicts("wheel-number", WHEEL, (r"\frac14", r"\frac12"))[1], "refuted");
    assert_eq!(verdicts("wheel-sign", WHEEL, (r"v^2 (1 -", r"v^2 (1 +"))[1], "refuted");
    // A formula that no single slip makes of it is another definition.
    assert_ne!(verdicts("wheel-other", WHEEL, (r"\frac14 \rho Q v^2", r"\frac19 \rho v^3"))[1], "refuted");
}
