//! Problems with their claims files, by which the tests of `onshell mark` mark hand-ins.

/// A cart that hits another one, which then climbs a ramp.
pub const COLLISION: (&str, &str) = (
    "A cart of mass $m_1 = 2\\,\\text{kg}$ with the velocity $u = 3\\,\\text{m/s}$ hits a cart of mass $m_2 = 1\\,\\text{kg}$ at rest. Take \
     $g = 9.81\\,\\text{m/s}^2$.\n\n$$ m_1 u = m_1 v_1 + m_2 v_2 \\tag{1} $$\n\n\
     $$ \\frac12 m_1 u^2 = \\frac12 m_1 v_1^2 + \\frac12 m_2 v_2^2 \\tag{2} $$\n\n\
     $$ v_1 = \\frac{m_1 - m_2}{m_1 + m_2} u, \\qquad v_2 = \\frac{2 m_1}{m_1 + m_2} u \\tag{3} $$\n\n\
     $$ \\eta = \\frac{m_2 v_2^2}{m_1 u^2} = \\frac{4 m_1 m_2}{(m_1 + m_2)^2} \\tag{4} $$\n\n$$ h = \\frac{v_2^2}{2 g} \\tag{5} $$\n\n\
     If they stick together:\n\n$$ w = \\frac{m_1 u}{m_1 + m_2} \\tag{6} $$\n\n\
     $$ Q = \\frac12 m_1 u^2 - \\frac12 (m_1 + m_2) w^2 = \\frac{m_1 m_2 u^2}{2 (m_1 + m_2)} \\tag{7} $$\n",
    r#"{ "notes": "p.md", "constants": { "m_1, m_2, u, g": "> 0" }, "rubric": { "results": { "3": 2, "4": 1, "5": 1, "7": 1 } } }"#,
);

/// A stone that is thrown from a cliff.
pub const CLIFF: (&str, &str) = (
    "From a cliff of height $h = 45\\,\\text{m}$ a stone is thrown with $v_0 = 20\\,\\text{m/s}$ at $\\alpha = 30^\\circ$. Take \
     $g = 9.81\\,\\text{m/s}^2$.\n\n$$ x = v_0 t \\cos\\alpha, \\qquad y = h + v_0 t\\sin\\alpha - \\frac12 g t^2 $$\n\n\
     It hits the ground when $y = 0$:\n\n\
     $$ t_1 = \\frac{v_0\\sin\\alpha + \\sqrt{v_0^2\\sin^2\\alpha + 2 g h}}{g} \\tag{1} $$\n\n$$ D = v_0 t_1\\cos\\alpha \\tag{2} $$\n\n\
     $$ H = h + \\frac{v_0^2\\sin^2\\alpha}{2 g} \\tag{3} $$\n\n$$ v_1 = \\sqrt{v_0^2 + 2 g h} \\tag{4} $$\n",
    r#"{ "notes": "p.md", "constants": { "v_0, g, h": "> 0", "\\alpha": "(0, \\pi/2)" },
        "rubric": { "results": { "1": 1, "2": 1, "3": 1, "4": 1 } } }"#,
);

/// A cylinder that rolls down a slope.
pub const CYLINDER: (&str, &str) = (
    "A cylinder of mass $m = 2\\,\\text{kg}$ and radius $R = 0.1\\,\\text{m}$ rolls down a slope of $\\alpha = 30^\\circ$. Take \
     $g = 9.81\\,\\text{m/s}^2$. Find its acceleration $a$. How fast is it after $s = 3\\,\\text{m}$?\n\n\
     $$ m a = m g\\sin\\alpha - F \\tag{1} $$\n\n$$ I \\beta = F R \\tag{2} $$\n\n\
     $$ I = \\frac12 m R^2, \\qquad \\beta = \\frac aR \\tag{3} $$\n\n$$ a = \\frac23 g\\sin\\alpha \\tag{4} $$\n\n\
     $$ F = \\frac13 m g\\sin\\alpha \\tag{5} $$\n\n$$ v = \\sqrt{2 a s} = \\sqrt{\\frac43 g s\\sin\\alpha} \\tag{6} $$\n",
    r#"{ "notes": "p.md", "constants": { "m, R, g, s, a, F": "> 0", "\\alpha": "(0, \\pi/2)" },
        "laws": { "Newton": "1", "rotation": "2" }, "rubric": { "results": { "4": 2, "5": 1, "6": 1 }, "half for": ["factor"] } }"#,
);

/// A damped oscillator that starts from rest.
pub const DAMPED: (&str, &str) = (
    "$$ m\\ddot x + b\\dot x + k x = 0 \\tag{1} $$\n\n$$ \\gamma = \\frac{b}{2m}, \\qquad \\omega_0^2 = \\frac km \\tag{2} $$\n\n\
     $$ \\omega = \\sqrt{\\omega_0^2 - \\gamma^2} \\tag{3} $$\n\nThe solution with $x(0) = x_0$ and $\\dot x(0) = 0$ is\n\n\
     $$ x(t) = x_0 e^{-\\gamma t}\\left(\\cos\\omega t + \\frac{\\gamma}{\\omega}\\sin\\omega t\\right) \\tag{4} $$\n\n\
     $$ E = \\frac12 m\\dot x^2 + \\frac12 k x^2 \\tag{5} $$\n\n$$ \\dot E = -b\\dot x^2 \\tag{6} $$\n",
    r#"{ "notes": "p.md", "varies with time": { "x": "any" }, "constants": { "m, b, k": "> 0", "x_0": "any" },
        "assume": ["b^2 < 4 m k"], "laws": { "Newton": "1" },
        "rubric": { "results": { "3": 1, "4": 2, "6": 1 }, "half for": ["sign", "factor"] } }"#,
);

/// Two masses on a chain of springs.
pub const CHAIN: (&str, &str) = (
    "$$ L = \\frac12 m(\\dot x_1^2 + \\dot x_2^2) - \\frac12 k x_1^2 - \\frac12 k (x_2 - x_1)^2 \\tag{1} $$\n\n\
     $$ m\\ddot x_1 = -k x_1 + k(x_2 - x_1) \\tag{2} $$\n\nThe secular equation is\n\n\
     $$ m^2\\omega^4 - 3 k m\\omega^2 + k^2 = 0 \\tag{3} $$\n\n\
     $$ \\omega_1^2 = \\frac{3 - \\sqrt5}{2}\\frac km, \\qquad \\omega_2^2 = \\frac{3 + \\sqrt5}{2}\\frac km \\tag{4} $$\n\n\
     With amplitudes $A_1$ and $A_2$ the second equation of motion gives in the slow mode\n\n\
     $$ \\frac{A_2}{A_1} = \\frac{k}{k - m\\omega_1^2} = \\frac{1 + \\sqrt5}{2} \\tag{5} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "x_1, x_2": "any" }, "constants": { "m, k, \\omega, A_1": "> 0" },
        "means": { "L": "Lagrangian", "\\omega_1, \\omega_2": "normal frequency" },
        "define": { "A_2": "\\frac{k A_1}{k - m\\omega_1^2}" }, "equations": { "3": { "secular equation for": "\\omega" } },
        "rubric": { "results": { "2": 1, "3": 1, "4": 2, "5": 1 } } }"#,
);

/// A body in a central force.
pub const ORBIT: (&str, &str) = (
    "$$ V(r) = \\frac{\\ell^2}{2 m r^2} - \\frac kr \\tag{1} $$\n\n$$ r_0 = \\frac{\\ell^2}{m k} \\tag{2} $$\n\n\
     $$ E_0 = V(r_0) = -\\frac{m k^2}{2\\ell^2} \\tag{3} $$\n\nAt the turning points\n\n\
     $$ E = \\frac{\\ell^2}{2 m r^2} - \\frac kr \\tag{4} $$\n\n\
     $$ r_{1,2} = \\frac{-k \\pm \\sqrt{k^2 + \\frac{2 E\\ell^2}{m}}}{2 E} \\tag{5} $$\n",
    r#"{ "notes": "p.md", "varies with time": { "r": "> 0" }, "constants": { "m, k, \\ell": "> 0", "E": "< 0" },
        "laws": { "energy": "E = \\frac12 m\\dot r^2 + \\frac{\\ell^2}{2 m r^2} - \\frac kr" },
        "equations": { "4": { "assume": "\\dot r = 0" }, "5": { "solves": "4", "for": "r" } },
        "rubric": { "results": { "1": 1, "2": 1, "3": 1, "5": 2 } } }"#,
);

/// A bead on a hoop that turns.
pub const BEAD: (&str, &str) = (
    "$$ T = \\frac12 m R^2 (\\dot\\theta^2 + \\omega^2 \\sin^2\\theta), \\qquad U = -m g R \\cos\\theta \\tag{1} $$\n\n\
     $$ L = T - U \\tag{2} $$\n\n\
     $$ \\ddot\\theta = \\omega^2 \\sin\\theta \\cos\\theta - \\frac{g}{R} \\sin\\theta \\tag{3} $$\n\n\
     There is an equilibrium at $\\theta_0$ with\n\n$$ \\cos\\theta_0 = \\frac{g}{R \\omega^2} \\tag{4} $$\n",
    r#"{ "notes": "p.md", "coordinates": { "\\theta": "angle" }, "constants": { "m, g, R, \\omega": "> 0", "\\theta_0": "(0, \\pi)" },
        "means": { "L": "Lagrangian" }, "rubric": { "results": { "3": 2, "4": 1 } } }"#,
);
