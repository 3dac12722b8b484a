//! Pages in the style of textbooks, each of which treats several systems. All displays are true.

pub const HEADINGS: &str = r"# Lagrangian mechanics: examples

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

pub const PARAGRAPHS: &str = r"A pendulum of length $b$ swings in all directions.

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

pub const ENVIRONMENTS: &str = r"\documentclass{article}
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

pub const SECTIONS: &str = r"\documentclass{article}
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

pub const SPOKEN: &str = r"First example. The effective potential is

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

pub const SAME_LETTERS: &str = r"Consider a point mass on a string of length $l$. Its Lagrangian is

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

pub const BLOCKS: &str = r"# Worked examples

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

pub const NOTATION: &str = r"## Notation

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

pub const METHOD: &str = r"# The method

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

pub const UNMARKED: &str = r"# Oscillators

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
