//! The displays of a lecture on many particles and rigid bodies, in its spelling: every one is read, in order, with
//! nothing declared but what the lecture says in words.

use onshell::latex::read_display;

use super::*;

const DISPLAYS: [&str; 54] = [
    r"\vec{r}_{cm} = \frac{\sum_{i=1}^{n} m_i \vec{r}_i}{\sum_{i=1}^{n} m_i} = \frac{1}{M} \sum_{i=1}^{n} m_i \vec{r}_i \quad , \quad M = \sum_{i=1}^{n} m_i",
    r"\rho(\vec{r}) = \lim_{V(\vec{r}) \to 0} \frac{\sum_{\vec{r}_i \in V(\vec{r})} m_i}{V(\vec{r})}",
    r"\vec{r}_{cm} = \frac{\int_{V} \rho(\vec{r}) \vec{r} d^{3}r}{M} , \quad M = \int_{V} \rho(\vec{r}) d^{3}r",
    r"\sigma(\vec{r}) = \lim_{A(\vec{r}) \to 0} \frac{\sum_{\vec{r}_i \in A(\vec{r})} m_i}{A(\vec{r})}",
    r"\vec{r}_{cm} = \frac{\int_A \sigma(\vec{r}) \vec{r} d^2 r}{M} \quad , \quad M = \int_A \sigma(\vec{r}) d^2 r \tag{2.5}",
    r"\lambda(\vec{r}) = \lim_{L(\vec{r}) \to 0} \frac{\sum_{\vec{r}_i \in L(\vec{r})} m_i}{L(\vec{r})}",
    r"\vec{r}_{cm} = \frac{\int_L \lambda(\vec{r}) \vec{r} dr}{M} , M = \int_L \lambda(\vec{r}) dr",
    r"\frac{m_i \vec{r_i} + m_i(-\vec{r_i})}{M} = 0",
    r"\vec{r}_{1cm} = \frac{\sum_{i} m_{1i} \vec{r}_{1i}}{M_1} , \quad \vec{r}_{2cm} = \frac{\sum_{i} m_{2i} \vec{r}_{2i}}{M_2}",
    r"\vec{r}_{cm} = \frac{\sum_{i} m_{1i} \vec{r}_{1i} + \sum_{i} m_{2i} \vec{r}_{2i}}{\sum_{i} m_{1i} + \sum_{i} m_{2i}} = \frac{M_{1} \frac{\sum_{i} m_{1i} \vec{r}_{1i}}{M_{1}} + M_{2} \frac{\sum_{i} m_{2i} \vec{r}_{2i}}{M_{2}}}{M_{1} + M_{2}} = \frac{M_{1} \vec{r}_{1cm} + M_{2} \vec{r}_{2cm}}{M_{1} + M_{2}}",
    r"\vec{r}_{cm} = \frac{M_0 \vec{0} - (\frac{1}{8} M_0)(\frac{1}{2} R \hat{z})}{M_0 - \frac{1}{8} M_0} = -\frac{1}{14} R \hat{z}",
    r"\vec{v}_{cm} = \frac{d}{dt}\vec{r}_{cm} = \frac{1}{M}\sum_{i=1}^{n} m_i \vec{v}_i",
    r"\vec{P}_{tot} = \sum_{i=1}^{n} \vec{p}_i = \sum_{i=1}^{n} m_i \vec{v}_i \tag{2.13}",
    r"\vec{P}_{tot} = \sum_{i=1}^{n} m_i \vec{v}_i = M \vec{v}_{cm} = \vec{P}_{cm}",
    r"\vec{F}_i = \vec{F}_{(ext)i} + \sum_{j \neq i}^n \vec{F}_{ij}",
    r"\vec{F_i} = \dot{\vec{p_i}} \tag{2.16}",
    r"\dot{\vec{P}}_{cm} = \sum_{i=1}^{n} \vec{F}_{i} = \sum_{i=1}^{n} \left(\vec{F}_{(ext)i} + \sum_{j \neq i}^{n} \vec{F}_{ij} \right)",
    r"\dot{\vec{P}}_{cm} = \sum_{i=1}^{n} \vec{F}_{(ext)i} \equiv \vec{F}_{ext}",
    r"\vec{L}_{tot} = \sum_{i=1}^{n} \vec{r}_i \times \vec{p}_i",
    r"\dot{\vec{L}}_{tot} = \sum_{i=1}^{n} \dot{\vec{r}}_{i} \times \vec{p}_{i} + \sum_{i=1}^{n} \vec{r}_{i} \times \dot{\vec{p}}_{i} = \sum_{i=1}^{n} \vec{r}_{i} \times \vec{F}_{i}",
    r"\dot{\vec{L}}_{tot} = \sum_{i=1}^{n} \vec{r}_{i} \times \vec{F}_{(ext)i} + \sum_{i=1}^{n} \sum_{j \neq i}^{n} \vec{r}_{i} \times \vec{F}_{ij}",
    r"\dot{\vec{L}}_{tot} = \sum_{i=1}^{n} \vec{r}_{i} \times \vec{F}_{(ext)i} + \frac{1}{2} \sum_{i=1}^{n} \sum_{j \neq i}^{n} \vec{r}_{ij} \times \vec{F}_{ij}",
    r"\dot{\vec{L}}_{tot} = \sum_{i=1}^{n} \vec{r}_i \times \vec{F}_{(ext)i} \equiv \vec{N}",
    r"\vec{\bar{r}}_i = \vec{r}_i - \vec{r}_{cm}",
    r"\sum_{i=1}^{n} m_i \vec{r}_i = \sum_{i=1}^{n} m_i (\vec{r}_i - \vec{r}_{cm}) = M(\vec{r}_{cm} - \vec{r}_{cm}) = 0",
    r"\vec{p}_i = m_i (\dot{\vec{r}}_i - \dot{\vec{r}}_{cm}) \tag{2.27}",
    r"\sum_{i=1}^{n} \vec{p}_i = \vec{P}_{tot} - \vec{P}_{cm} = 0 \tag{2.28}",
    r"\vec{L}_{tot} = \sum_{i=1}^{n} (\vec{r}_{cm} + \vec{\bar{r}}_i) \times m_i (\dot{\vec{r}}_{cm} + \dot{\vec{\bar{r}}}_i) = \vec{r}_{cm} \times \vec{P}_{cm} + \sum_{i=1}^{n} \vec{\bar{r}}_i \times m_i \dot{\vec{\bar{r}}}_i \equiv \vec{L}_{orb} + \vec{L}_{spin}",
    r"\sum_{i=1}^{n} m_i \vec{r}_i = \sum_{i=1}^{n} m_i \dot{\vec{r}}_i = 0 \quad \Rightarrow \quad \sum_{i=1}^{n} \vec{r}_i \times m_i \dot{\vec{r}}_{cm} = \sum_{i=1}^{n} \vec{r}_{cm} \times m_i \dot{\vec{r}}_i = 0",
    r"\begin{aligned} \vec{N} &= \sum_{i=1}^{n} \vec{r}_{i} \times \vec{F}_{(ext)i} \\ &= \sum_{i=1}^{n} (\vec{r}_{cm} + \vec{r}_{i}) \times \vec{F}_{(ext)i} \\ &= \vec{r}_{cm} \times \vec{F}_{ext} + \sum_{i=1}^{n} \vec{r}_{i} \times \vec{F}_{(ext)i} \\ &\equiv \vec{N}_{orb} + \vec{N}_{spin} \end{aligned}",
    r"T_{tot} = \sum_{i=1}^{n} \frac{1}{2} m_i \vec{v}_i \cdot \vec{v}_i = \frac{1}{2} \sum_{i=1}^{n} m_i (\vec{v}_{cm} + \vec{v}_i) \cdot (\vec{v}_{cm} + \vec{v}_i) = \frac{1}{2} M \vec{v}_{cm} \cdot \vec{v}_{cm} + \frac{1}{2} \sum_{i=1}^{n} m_i \vec{v}_i \cdot \vec{v}_i",
    r"T = \frac{1}{2} \sum_{i} m_i |\vec{v}_i|^2 \tag{3.33}",
    r"|\vec{v}_i| = \omega r_{i\perp}",
    r"|\vec{v}_i| = |\vec{\omega} \times \vec{r}_i|",
    r"I_{\omega} = \sum_{i} m_i (r_{i\perp})^2",
    r"T = \frac{1}{2} \sum_{i} m_i (r_{i\perp})^2 \omega^2 \equiv \frac{1}{2} I_{\omega} \omega^2",
    r"I_{\omega} = \int_{V} \rho(\vec{r}) |\vec{r}_{\perp}|^2 d^3r",
    r"\vec{L}_{tot} = \sum_{i} m_i \vec{r}_i \times (\vec{\omega} \times \vec{r}_i) = \sum_{i} m_i \left(|r_i|^2 \vec{\omega} - (\vec{\omega} \cdot \vec{r}_i) \vec{r}_i \right)",
    r"L_{\omega} = \hat{\omega} \cdot \vec{L}_{tot} = \sum_{i} m_{i} \left(|r_i|^2 - (\hat{\omega} \cdot \vec{r}_{i})^2 \right) \omega = I_{\omega} \omega",
    r"(r_{i\perp})^2 = |r_i|^2 - (\hat{\omega} \cdot \vec{r_i})^2",
    r"N_{\omega} = \dot{L}_{\omega} = I_{\omega}\dot{\omega}",
    r"I = I_{cm} + m(r_{\perp cm})^2",
    r"\mathbb{I}_{ab} = \sum_{i} m_i (|r_i|^2 \delta_{ab} - r_{ia} r_{ib})",
    r"\mathbb{I}_{ab} = \sum_{i} m_{i} \begin{pmatrix} r_{i}^{2} - x_{i}^{2} & -x_{i}y_{i} & -x_{i}z_{i} \\ -y_{i}x_{i} & r_{i}^{2} - y_{i}^{2} & -y_{i}z_{i} \\ -z_{i}x_{i} & -z_{i}y_{i} & r_{i}^{2} - z_{i}^{2} \end{pmatrix} = \sum_{i} m_{i} \begin{pmatrix} y_{i}^{2} + z_{i}^{2} & -x_{i}y_{i} & -x_{i}z_{i} \\ -y_{i}x_{i} & x_{i}^{2} + z_{i}^{2} & -y_{i}z_{i} \\ -z_{i}x_{i} & -z_{i}y_{i} & x_{i}^{2} + y_{i}^{2} \end{pmatrix}",
    r"\vec{L}_{tot} = \mathbb{I}\vec{\omega} \tag{3.47}",
    r"\mathbb{I}_{ab} = \begin{pmatrix} \lambda_1 & 0 & 0 \\ 0 & \lambda_2 & 0 \\ 0 & 0 & \lambda_3 \end{pmatrix}",
    r"T_{spin} = \frac{1}{2} \sum_{a=1}^{3} \lambda_a \omega_a^2 = \frac{1}{2} \sum_{a,b=1}^{3} \mathbb{I}_{ab} \omega_a \omega_b",
    r"\vec{r}_1 = \hat{x} \quad , \quad \vec{r}_2 = \hat{y} \quad, \quad \vec{r}_3 = \hat{z} \quad , \quad \vec{r}_4 = -\hat{x} - \hat{y} - \hat{z}",
    r"R_{ab} = \hat{e}_a \cdot \hat{r}_b \quad \Rightarrow \quad R_{ab} = \frac{1}{\sqrt{6}} \begin{pmatrix} \sqrt{2} & \sqrt{2} & \sqrt{2} \\ \sqrt{3} & -\sqrt{3} & 0 \\ 1 & 1 & -2 \end{pmatrix}",
    r"R_{ab} \mathbb{I}_{bc} R_{cd}^T = m \begin{pmatrix} 2 & 0 & 0 \\ 0 & 5 & 0 \\ 0 & 0 & 5 \end{pmatrix}",
    r"\frac{d\vec{v}}{dt} = \dot{\vec{v}} + \vec{\omega} \times \vec{v}",
    r"\frac{d\vec{L}_{tot}}{dt} = \vec{N} \quad \Rightarrow \quad \dot{\vec{L}}_{tot} + \vec{\omega} \times \vec{L}_{tot} = \vec{N}",
    r"\begin{aligned} \lambda_{1}\dot{\omega}_{1} + (\lambda_{3} - \lambda_{2})\omega_{2}\omega_{3} &= N_{1} \\ \lambda_{2}\dot{\omega}_{2} + (\lambda_{1} - \lambda_{3})\omega_{1}\omega_{3} &= N_{2} \\ \lambda_{3}\dot{\omega}_{3} + (\lambda_{2} - \lambda_{1})\omega_{1}\omega_{2} &= N_{3} \end{aligned}",
    r"\omega_{eff}^2 = \frac{(\lambda_3 - \lambda_1)(\lambda_2 - \lambda_1)\omega_1^2}{\lambda_2 \lambda_3} > 0 \tag{4.62}",
];

fn lecture() -> Symbols {
    let mut symbols = particles();
    for name in ["x_i", "y_i", "z_i", "m_{1i}", "m_{2i}", "M_0", "M_1", "M_2", "m", "I", "I_{cm}", r"r_{\perp cm}"] {
        add(&mut symbols, name, Kind::Scalar);
    }
    for name in [r"\vec r_{1i}", r"\vec r_{2i}", r"\vec r_{i\perp}", r"\hat y", r"\hat z", r"\hat r_a"] {
        add(&mut symbols, name, Kind::Vector);
    }
    symbols.add(onshell::latex::name_search::parse_decorated(r"\dot{\vec v}").unwrap(), Kind::Vector).unwrap();
    let (omega, axes) = (find(&symbols, r"\vec\omega"), find(&symbols, r"\hat e_a"));
    symbols.entry_mut(omega).components = Some(Components::Along(axes));
    symbols
}

#[test]
fn every_display_of_a_lecture_is_read() {
    let mut symbols = lecture();
    let mut refusals = Vec::new();
    for latex in DISPLAYS {
        for statement in read_display(latex, &mut symbols, &Macros::default()).statements {
            match statement {
                Err(fault) => refusals.push(format!("{}: {} in {latex}", fault.message, &latex[fault.span.range()])),
                Ok(statement) => {
                    for member in &statement.members {
                        let printed = typeset(member, &symbols);
                        match read_formula(&printed, &mut symbols, &Macros::default()) {
                            Ok(again) => assert_eq!(again, *member, "{latex}, printed {printed}"),
                            Err(fault) => refusals.push(format!("{} in the printed {printed}", fault.message)),
                        }
                    }
                }
            }
        }
        if latex.contains(r"\equiv \vec{N}") && !latex.contains("orb") {
            let torque = find(&symbols, r"\vec N");
            let axes = find(&symbols, r"\hat e_a");
            symbols.entry_mut(torque).components = Some(Components::Along(axes));
        }
    }
    assert!(refusals.is_empty(), "{}", refusals.join("\n"));
}
