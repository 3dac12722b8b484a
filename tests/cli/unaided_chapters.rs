//! Notes without a claims file that treat several systems, as chapters of textbooks do: each example has its own Lagrangian and
//! coordinates, and uses letters of another one again.

use crate::support::Desk;

/// The verdict of each display of notes, in a file with this name.
fn verdicts(name: &str, file: &str, notes: &str) -> Vec<String> {
    let desk = Desk::new(&format!("unaided-chapters-{name}"));
    desk.write(file, notes);
    let report = desk.onshell(&["check", file, "--format", "json"]).json();
    let equations = report["documents"][0]["equations"].as_array().expect("a list");
    equations.iter().map(|equation| equation["verdict"].as_str().expect("a verdict").to_owned()).collect()
}

/// Checks that the displays of true notes have these verdicts, d for definition, c for certified, v for verified and a for assumed, and that
/// each slip makes the display at its place wrong, and no other one.
fn check(name: &str, file: &str, notes: &str, expected: &str, slips: &[(usize, &str, &str)]) {
    let letters = |found: &[String]| -> String { found.iter().filter_map(|verdict| verdict.chars().next()).collect() };
    assert_eq!(letters(&verdicts(name, file, notes)), expected, "{name}");
    for (at, right, wrong) in slips {
        assert_eq!(notes.matches(right).count(), 1, "“{right}” in {name}");
        let found = verdicts(&format!("{name}-slip"), file, &notes.replace(right, wrong));
        let places: Vec<usize> = (0..found.len()).filter(|at| found[*at] == "refuted").collect();
        assert_eq!(places, [*at], "“{wrong}” in {name}: {found:?}");
    }
}

const HEADINGS: &str = r"# Lagrangian mechanics: examples

In general the motion obeys

$$
\frac{d}{dt}\frac{\partial L}{\partial \dot q_i} - \frac{\partial L}{\partial q_i} = 0 .
$$

## A mass on a spring

The Lagrangian is

$$
L = \frac12 m \dot x^2 - \frac12 k x^2
$$

so that

$$
m \ddot x = -k x .
$$

It oscillates with

$$
\omega = \sqrt{\frac{k}{m}} .
$$

## The plane pendulum

With the length $l$,

$$
T = \frac12 m l^2 \dot\theta^2
$$

$$
V = -m g l \cos\theta
$$

$$
L = T - V
$$

and therefore

$$
\frac{\partial L}{\partial \theta} = -m g l \sin\theta
$$

$$
\ddot\theta = -\frac{g}{l} \sin\theta .
$$

## A bead on a rotating hoop

The hoop of radius $R$ turns at the rate $\omega$:

$$
L = \frac12 m R^2 \left( \dot\theta^2 + \omega^2 \sin^2\theta \right) + m g R \cos\theta
$$

$$
\ddot\theta = \omega^2 \sin\theta \cos\theta - \frac{g}{R} \sin\theta
$$

## A planet

$$
L = \frac12 m \left( \dot r^2 + r^2 \dot\theta^2 \right) + \frac{G M m}{r}
$$

The angle is cyclic:

$$
p_\theta = m r^2 \dot\theta
$$

$$
m \ddot r = m r \dot\theta^2 - \frac{G M m}{r^2}
$$

## Atwood's machine

$$
L = \frac12 (m_1 + m_2) \dot x^2 + (m_1 - m_2) g x
$$

$$
\ddot x = \frac{m_1 - m_2}{m_1 + m_2} g
$$
";

const PARAGRAPHS: &str = r"A pendulum of length $b$ swings in all directions.

$$
L = \frac12 m b^2 \left( \dot\theta^2 + \sin^2\theta\, \dot\phi^2 \right) + m g b \cos\theta
$$

$$
b \ddot\theta = b \sin\theta \cos\theta\, \dot\phi^2 - g \sin\theta
$$

A ball rolls down an incline of slope $\alpha$, and $s$ is the distance it has covered.

$$
T = \frac{7}{10} m \dot s^2
$$

$$
V = -m g s \sin\alpha
$$

$$
L = T - V
$$

$$
\ddot s = \frac57 g \sin\alpha
$$

Two masses slide on a rail, held together by a spring.

$$
L = \frac12 m \dot x_1^2 + \frac12 m \dot x_2^2 - \frac12 k (x_2 - x_1)^2
$$

$$
m \ddot x_1 = k (x_2 - x_1)
$$
";

const ENVIRONMENTS: &str = r"\documentclass{article}
\begin{document}
\section{Examples}

\begin{example}
A particle falls in the field $g$:
\begin{equation}
  L = \frac12 m \dot z^2 - m g z
\end{equation}
Hence
\begin{equation}
  \ddot z = -g .
\end{equation}
\end{example}

\begin{example}
A bead slides on the parabola $z = a x^2$:
\begin{equation}
  L = \frac12 m \left( 1 + 4 a^2 x^2 \right) \dot x^2 - m g a x^2
\end{equation}
so the momentum is
\begin{equation}
  p_x = m \left( 1 + 4 a^2 x^2 \right) \dot x
\end{equation}
and the equation of motion is
\begin{equation}
  \left( 1 + 4 a^2 x^2 \right) \ddot x + 4 a^2 x \dot x^2 + 2 g a x = 0 .
\end{equation}
\end{example}

\begin{example}
A charge on a spring in the field $E$:
\begin{equation}
  L = \frac12 m \dot x^2 - \frac12 k x^2 + e E x
\end{equation}
\begin{equation}
  m \ddot x = -k x + e E
\end{equation}
\end{example}
\end{document}
";

const SECTIONS: &str = r"\documentclass{article}
\begin{document}
The Lagrangian is the difference of the energies,
\begin{equation}
  \mathcal{L}(q, \dot q, t) = T - V .
\end{equation}
\section{The pendulum}
The kinetic energy is
\begin{equation}
  T = \frac12 m l^2 \dot\theta^2
\end{equation}
and the potential energy
\begin{equation}
  V = m g l (1 - \cos\theta) .
\end{equation}
So
\begin{equation}
  \mathcal{L}(\theta, \dot\theta) = \frac12 m l^2 \dot\theta^2 - m g l (1 - \cos\theta) .
\end{equation}
From this
\begin{equation}
  \frac{\partial \mathcal{L}}{\partial \dot\theta} = m l^2 \dot\theta
\end{equation}
and
\begin{equation}
  m l^2 \ddot\theta + m g l \sin\theta = 0 .
\end{equation}
\section{The cylinder}
A cylinder of radius $R$ rolls without slipping down a slope:
\begin{equation}
  \mathcal{L}(x, \dot x) = \frac34 m \dot x^2 + m g x \sin\alpha .
\end{equation}
From this
\begin{equation}
  \frac{\partial \mathcal{L}}{\partial \dot x} = \frac32 m \dot x
\end{equation}
and
\begin{equation}
  \ddot x = \frac23 g \sin\alpha .
\end{equation}
\end{document}
";

const SPOKEN: &str = r"First example. The effective potential is

$$
U(r) = \frac{l^2}{2 m r^2} - \frac{k}{r}
$$

with the derivative

$$
U'(r) = -\frac{l^2}{m r^3} + \frac{k}{r^2} .
$$

Second example. The effective potential is

$$
U(r) = \frac{l^2}{2 m r^2} + \frac12 k r^2
$$

with the derivative

$$
U'(r) = -\frac{l^2}{m r^3} + k r .
$$

Third example. A mass on a spring has

$$
\omega = \sqrt{\frac{k}{m}}
$$

$$
P = \frac{2\pi}{\omega} = 2\pi \sqrt{\frac{m}{k}}
$$

Fourth example. A pendulum has

$$
\omega = \sqrt{\frac{g}{a}}
$$

$$
P = \frac{2\pi}{\omega} = 2\pi \sqrt{\frac{a}{g}}
$$
";

const SAME_LETTERS: &str = r"Consider a point mass on a string of length $l$. Its Lagrangian is

$$
L = \frac12 m l^2 \dot\theta^2 + m g l \cos\theta
$$

and the equation of motion

$$
l \ddot\theta = -g \sin\theta .
$$

Consider now a rigid body that turns about a fixed axis, with the moment of inertia $I$ and the centre of mass at the distance $a$. Its Lagrangian is

$$
L = \frac12 I \dot\theta^2 + m g a \cos\theta
$$

and the equation of motion

$$
I \ddot\theta = -m g a \sin\theta .
$$

Next, consider a torsion pendulum. Its Lagrangian is

$$
L = \frac12 I \dot\theta^2 - \frac12 \kappa \theta^2
$$

and the equation of motion

$$
I \ddot\theta = -\kappa \theta .
$$
";

const BLOCKS: &str = r"# Worked examples

::::{admonition} Example 1: Central force
:class: example

$$
U = -\frac{k}{r}
$$

$$
L = \frac12 m \left( \dot r^2 + r^2 \dot\theta^2 \right) + \frac{k}{r}
$$

$$
m \ddot r - m r \dot\theta^2 + \frac{k}{r^2} = 0
$$
::::

::::{admonition} Example 2: A mass that slides off a sphere
:class: example

The constraint is $r = R$.

$$
N = m g \cos\theta - m R \dot\theta^2
$$
::::

::::{admonition} Example 3: Pendulum on a cart
:class: example

$$
T = \frac12 (M + m) \dot x^2 + m l \dot x \dot\theta \cos\theta + \frac12 m l^2 \dot\theta^2
$$

$$
U = -m g l \cos\theta
$$

$$
L = T - U
$$

$$
(M + m) \ddot x + m l \ddot\theta \cos\theta - m l \dot\theta^2 \sin\theta = 0
$$

$$
l \ddot\theta + \ddot x \cos\theta + g \sin\theta = 0
$$
::::
";

const NOTATION: &str = r"## Notation

A mass $m$ hangs in the field $g$. We write

$$
k = m \omega_0^2
$$

## Example 1: a spring

$$
L = \frac12 m \dot x^2 - \frac12 k x^2
$$

$$
\ddot x = -\omega_0^2 x
$$

$$
\tau = \frac{2\pi}{\omega_0}
$$

## Example 2: a spring that hangs

$$
L = \frac12 m \dot z^2 - \frac12 k z^2 - m g z
$$

$$
\ddot z = -\omega_0^2 z - g
$$

$$
\tau \omega_0 = 2\pi
$$
";

const METHOD: &str = r"# The method

$$
L = T - V
$$

## A block on a wedge

$$
T = \frac12 (M + m) \dot x^2 + \frac12 m \dot s^2 + m \dot x \dot s \cos\alpha
$$

$$
V = -m g s \sin\alpha
$$

$$
\ddot s + \ddot x \cos\alpha = g \sin\alpha
$$

## The spherical pendulum

$$
T = \frac12 m l^2 \left( \dot\theta^2 + \sin^2\theta\, \dot\phi^2 \right)
$$

$$
V = -m g l \cos\theta
$$

$$
\ddot\theta = \sin\theta \cos\theta\, \dot\phi^2 - \frac{g}{l} \sin\theta
$$
";

const UNMARKED: &str = r"# Oscillators

## The spring

$$
L = \frac12 m \dot x^2 - \frac12 k x^2
$$

$$
m \ddot x = -k x
$$

## The pendulum

$$
L = \frac12 m l^2 \dot\theta^2 + m g l \cos\theta
$$

### Equation of motion

$$
\ddot\theta = -\frac{g}{l} \sin\theta
$$

## The inverted pendulum

The angle is now measured from the upper position.

$$
\ddot\theta = \frac{g}{l} \sin\theta
$$
";

#[test]
fn each_section_with_a_lagrangian_is_checked_as_a_page_of_its_own() {
    let slips = [
        (2, r"m \ddot x = -k x", r"m \ddot x = k x"),
        (7, "-m g l \\sin\\theta\n", "m g l \\sin\\theta\n"),
        (8, r"-\frac{g}{l} \sin", r"\frac{g}{l} \sin"),
        (10, r"\cos\theta - \frac{g}{R}", r"\cos\theta + \frac{g}{R}"),
        (12, r"p_\theta = m r^2", r"p_\theta = m r"),
        (15, r"{m_1 + m_2} g", r"{m_1 + m_2} 2 g"),
    ];
    check("headings", "notes.md", HEADINGS, "ddcddddccdcdccdc", &slips);
    let slips = [
        (4, r"= m l^2 \dot", r"= 2 m l^2 \dot"),
        (5, r"+ m g l \sin", r"- m g l \sin"),
        (8, r"\frac23 g", r"\frac32 g"),
    ];
    check("sections", "notes.tex", SECTIONS, "ddddccdcc", &slips);
}

#[test]
fn a_lagrangian_of_other_coordinates_is_that_of_another_system() {
    let slips = [
        (1, r"\dot\phi^2 - g", r"\dot\phi^2 + g"),
        (5, r"\frac57 g \sin", r"\frac57 g \cos"),
        (7, "= k (x_2 - x_1)", "= k (x_1 - x_2)"),
    ];
    check("paragraphs", "notes.md", PARAGRAPHS, "dcdddcdc", &slips);
    let slips = [(3, r"-m g a \sin", r"m g a \sin"), (5, r"= -\kappa", r"= \kappa")];
    check("same-letters", "notes.md", SAME_LETTERS, "dcdcdc", &slips);
}

#[test]
fn an_example_is_a_system() {
    let slips = [(4, "+ 2 g a x", "- 2 g a x"), (6, "-k x + e E\n", "-k x - e E\n")];
    check("environments", "notes.tex", ENVIRONMENTS, "dcdccdc", &slips);
    let slips = [(7, r"- m l \dot\theta^2 \sin", r"+ m l \dot\theta^2 \sin"), (8, r"+ g \sin", r"- g \sin")];
    check("blocks", "notes.md", BLOCKS, "ddcddddcc", &slips);
    let slips = [(1, r"+ \frac{k}{r^2} .", r"- \frac{k}{r^2} ."), (3, "+ k r .", "- k r .")];
    check("spoken", "notes.md", SPOKEN, "dcdcdvdv", &slips);
}

/// What stands before all systems holds in each; what one example defines is unknown in the next.
#[test]
fn general_definitions_are_carried_over_and_those_of_an_example_are_not() {
    check("notation", "notes.md", NOTATION, "ddcddca", &[(5, r"\omega_0^2 z - g", r"\omega_0^2 z + g")]);
    let slips = [(3, r"= g \sin\alpha", r"= -g \sin\alpha"), (6, r"- \frac{g}{l}", r"+ \frac{g}{l}")];
    check("method", "notes.md", METHOD, "dddcddc", &slips);
}

/// A section without a Lagrangian, beside others with one, may be about another system; a step of the treatment is not.
#[test]
fn what_may_be_about_another_system_is_taken_for_granted() {
    check("unmarked", "notes.md", UNMARKED, "dcdca", &[(3, r"= -\frac{g}{l}", r"= \frac{g}{l}")]);
    let two = SPOKEN_POTENTIALS.replace("TURNS", r"\alpha n r_m^{n+2} = \frac{l^2}{\mu}");
    assert!(!verdicts("turning", "notes.md", &two).contains(&"refuted".to_owned()));
    let labels = "Spring:\n\n$$ \\omega = \\sqrt{\\frac{k}{m}} $$\n\nPendulum:\n\n$$ \\omega = \\sqrt{\\frac{g}{L}} $$\n\n\
                  $$ \\frac{k}{m} = \\frac{g}{L} $$\n";
    assert_eq!(verdicts("labels", "notes.md", labels), ["definition", "definition", "assumed"]);
}

const SPOKEN_POTENTIALS: &str = r"First example. The effective potential is

$$ U(r) = \frac{l^2}{2\mu r^2} - \frac{\alpha}{r^n} $$

$$ U'(r) = -\frac{l^2}{\mu r^3} + \frac{\alpha n}{r^{n+1}} = 0 $$

at

$$ r_m = \left(\frac{l^2}{n\alpha \mu}\right)^{\frac{1}{2-n}} $$

Second example. The effective potential is

$$ U(r) = \frac{l^2}{2\mu r^2} + \alpha r^n $$

A circular orbit needs

$$ U'(r_m) = -\frac{l^2}{\mu r_m^3} + \alpha n r_m^{n-1} = 0 $$

that is

$$ TURNS $$
";

/// The Euler–Lagrange equation in q is not about a Lagrangian without q, whatever its signs are; nor is what uses its momentum.
#[test]
fn a_general_law_is_introduced_and_not_certified_by_zeros() {
    let pendulum = r"$$ L = \frac12 m l^2 \dot\theta^2 + m g l \cos\theta $$";
    for law in [
        r"$$ \frac{d}{dt}\frac{\partial L}{\partial \dot q} - \frac{\partial L}{\partial q} = 0 $$",
        r"$$ \frac{d}{dt}\frac{\partial L}{\partial \dot q_i} + 3 \frac{\partial L}{\partial q_i} = 0 $$",
    ] {
        let motion = r"$$ l \ddot\theta = -g \sin\theta $$";
        let after = verdicts("law-after", "notes.md", &[pendulum, law, motion].join("\n\n"));
        assert_eq!(after, ["definition", "definition", "certified"], "{law}");
        let before = verdicts("law-before", "notes.md", &[law, pendulum, motion].join("\n\n"));
        assert_eq!(before, ["definition", "definition", "certified"], "{law}");
    }
    let momentum = [pendulum, r"$$ p = \frac{\partial L}{\partial \dot q} $$", r"$$ 2 p = -3 p $$"].join("\n\n");
    assert!(!["certified", "verified", "refuted"].contains(&verdicts("momentum", "notes.md", &momentum)[2].as_str()));
}

/// L with its arguments is L, and `L = T - V` may stand before T and V.
#[test]
fn a_lagrangian_with_arguments_is_the_same() {
    let notes = |derivative: &str| {
        let displays = [
            r"\mathcal{L}(q, \dot q, t) = T - V",
            r"T = \frac12 m L^2 \dot\theta^2",
            r"V = m g L (1 - \cos\theta)",
            r"\mathcal{L}(\theta, \dot\theta) = \frac12 m L^2 \dot\theta^2 - m g L (1 - \cos\theta)",
            derivative,
        ];
        displays.map(|latex| format!("$$ {latex} $$\n\n")).concat()
    };
    let last = |name: &str, derivative: &str| verdicts(name, "notes.md", &notes(derivative)).pop().unwrap_or_default();
    assert_eq!(last("arguments", r"\frac{\partial \mathcal{L}}{\partial \theta} = -m g L \sin\theta"), "certified");
    assert_eq!(last("arguments-slip", r"\frac{\partial \mathcal{L}}{\partial \theta} = m g L \sin\theta"), "refuted");
}

/// An acceleration a in a Lagrangian is constant, though the solution is ẍ = a.
#[test]
fn a_constant_of_a_lagrangian_may_be_equal_to_an_acceleration() {
    let notes = |force: &str| {
        format!(
            "The Lagrangian is\n\n$$ \\mathcal{{L}} = \\frac12 m (\\dot x + v_0 - a t)^2 $$\n\n\
             $$ \\frac{{d}}{{dt}}\\left(\\frac{{\\partial \\mathcal{{L}}}}{{\\partial \\dot x}}\\right) = {force} $$\n\n\
             $$ \\frac{{d^2 x}}{{dt^2}} = a $$\n"
        )
    };
    assert_eq!(verdicts("bus", "notes.md", &notes(r"m (\ddot x - a)")), ["definition", "certified", "certified"]);
    assert_eq!(verdicts("bus-slip", "notes.md", &notes(r"m (\ddot x + a)"))[1], "refuted");
}
