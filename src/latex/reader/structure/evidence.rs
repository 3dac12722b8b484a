//! What a display shows about letters without a value: which are indices, whether a T is a transpose, whether e is a charge,
//! and which letters stand for functions before a parenthesis.

use crate::formula::symbols::{Inferred, Name};

use super::super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::super::lexer::Space;
use super::super::super::names;
use super::super::items::{differential, is_inverse_transpose, is_limit, is_transpose, whole_number};
use super::super::vector_names::is_vectorial;

/// Records it.
pub(in super::super::super) fn note(items: &[Item], inferred: &mut Inferred) {
    let mut found = Found::default();
    found.list(items);
    inferred.index_letters.extend(found.lower);
    inferred.has_tensors |= found.has_pairs;
    inferred.segments.extend(found.segments);
    inferred.has_operators |= found.has_operators;
    inferred.component_letters.extend(found.components);
    // `\partial_0 E^3`: where the derivatives have numbers, the capitals have them too.
    if found.has_numbered_derivatives {
        inferred.component_letters.extend(found.capitals);
    }
    if found.has_pairs {
        inferred.index_letters.extend(found.pairs);
    }
    // `\frac{\partial L}{\partial q^n} \delta q^n` beside p_n: what stands above letters and below others is an index.
    found.upper.retain(|letter| !found.orders.contains(letter));
    if !found.upper.is_empty() {
        let both = found.above.into_iter().filter(|letter| found.below.contains(letter));
        inferred.index_letters.extend(both);
        inferred.index_letters.extend(found.upper);
        inferred.has_tensors = true;
    }
    // `A^T P + P A`: no power of A by a T that stands nowhere else.
    let is_plain = |name: &Name| found.plain.contains(name);
    let beside_itself = found.transposed.iter().any(is_plain) && !is_plain(&Name::plain("T"));
    inferred.has_transposes |=
        found.transposes > 1 || found.transposes == 1 && found.has_matrix || found.transposes > 0 && beside_itself;
    // `J^T F`: nobody multiplies by the T-th power of a letter, if T stands nowhere else.
    inferred.has_transposes |= found.transposed_factors > 0 && !is_plain(&Name::plain("T"));
    inferred.has_states |= found.has_states;
    let has_others = found.plain.iter().any(|name| name.base != "e");
    inferred.charge |=
        (found.has_constants || found.has_eccentricity || found.has_lone_e && has_others) && !found.has_exponential;
}

/// Whether a letter before a parenthesis stands for a function whatever stands in it: Γ(x + 1), f(2x), J_n(kr), δ(x − a),
/// V(x_1 − x_2).
pub(in super::super::super) fn is_function_letter(name: &Name, inside: &[Item]) -> bool {
    let base = name.base.as_str();
    let always = [
        "f",
        "\\Gamma",
        "\\Phi",
        "\\Psi",
        "\\psi",
        "\\phi",
        "\\varphi",
        "\\Theta",
        "O",
        "\\mathcal{O}",
        "\\zeta",
        "\\delta",
        "\\iota",
    ];
    let of_a_place = ["V", "U", "F", "u", "g", "h", "G", "W", "H", "y", "\\rho", "\\eta", "v", "q", "x"];
    let is_place = |item: &Item| {
        let place = [
            "x",
            "r",
            "q",
            "y",
            "\\vec{r}",
            "\\vec{x}",
            "\\mathbf{r}",
            "\\mathbf{x}",
            "\\vec{q}",
            "\\mathbf{q}",
            "t",
            "\\tau",
        ];
        names::printed(item, None).is_some_and(|found| found.sup.is_none() && place.contains(&found.name.base.as_str()))
    };
    let is_part = |item: &Item| {
        is_place(item)
            || matches!(&item.layout, Layout::Other('+' | '-') | Layout::Number(_) | Layout::Space(_))
            || matches!(&item.layout, Layout::Command(name) if ["\\Delta", "\\delta", "\\pm"].contains(&name.as_str()))
            || matches!(&item.layout, Layout::Fence(_, inner) if inner.iter().all(is_place))
            || names::printed(item, None).is_some_and(|found| {
                ["h", "a", "T", "\\xi", "\\epsilon", "\\varepsilon", "c", "v"].contains(&found.name.base.as_str())
            })
    };
    // P_l, J_n, Y_{lm}; but `P_0 \left(\frac{T}{T_0}\right)^\chi` is a product.
    let is_ratio = matches!(inside, [Item { layout: Layout::Fraction(..), .. }]);
    let is_capital = |item: &Item| matches!(item.layout, Layout::Letter('A'..='Z'));
    let is_legendre = ["P", "J", "Y"].contains(&base)
        && !name.subscript.is_empty()
        && !is_ratio
        // `P_{n+1}(A - BK_n)` is a product of matrices.
        && !inside.first().is_some_and(is_capital);
    // The spherical Bessel function `j_l(kr)`.
    let is_order = |part: &String| ["l", "\\ell", "n", "0", "1", "2"].contains(&part.as_str());
    let is_spherical = base == "j" && matches!(name.subscript.as_slice(), [order] if is_order(order));
    // `\zeta(\nabla\cdot\mathbf u)`, `\psi(\hat a + \hat b)`: what an operator makes, or operators, are factors.
    let is_operator = |item: &Item| {
        item.layout == Layout::Command("\\nabla".to_owned())
            || names::printed(item, None).is_some_and(|found| found.name.base.starts_with("\\hat{"))
    };
    if base != "f" && inside.iter().any(is_operator) {
        return false;
    }
    // The gamma function has no argument that varies with the time: `i\Gamma(x/c - t)` is refused as k(x − ct) is.
    let is_rate = base == "\\Gamma" && inside.iter().any(|item| is_time(item) || is_field(item));
    // One product in a parenthesis is a factor as often: `\rho(\xi^2 q)`.
    let is_sum = inside.iter().skip(1).any(|item| matches!(item.layout, Layout::Other('+' | '-')));
    let letters = inside.iter().filter(|item| names::printed(item, None).is_some()).count();
    let is_argument = is_sum || letters < 2;
    let has_place = inside.iter().any(|item| match &item.layout {
        Layout::Fence(_, inner) => inner.iter().any(is_place),
        _ => is_place(item),
    });
    let is_kronecker = ["\\delta", "\\Gamma"].contains(&base) && name.subscript.len() > 1;
    let is_known = always.contains(&base) && !is_rate && !is_kronecker
        || is_legendre
        || is_spherical
        || base.starts_with("\\mathcal{");
    // `\dot\psi(\bar\rho + \bar P)`, `\mathcal{H}(a + b)`: a sum of letters that are no place is a factor as often.
    let is_symbol = ["\\Phi", "\\Psi", "\\psi", "\\phi", "\\varphi"].contains(&base) || base.starts_with("\\mathcal{");
    let is_variable = |item: &Item| {
        matches!(
            item.layout,
            Layout::Number(_)
                | Layout::Fence(..)
                | Layout::Fraction(..)
                | Layout::Letter('z' | 's' | 'k' | 'p' | 'n' | 'u')
        ) || is_place(item)
            || ["\\theta", "\\omega", "\\xi"]
                .iter()
                .any(|sign| names::printed(item, None).is_some_and(|found| found.name.base == *sign))
    };
    if is_symbol && base != "\\mathcal{O}" && is_sum && !inside.iter().any(is_variable) {
        return false;
    }
    // U_0 is the value of U at a place, and a factor: `U_0(1 - x/a)`, `V_0(x - a)^2`.
    let is_value = name.subscript == ["0"];
    // `hf(1 + z)`: a sum that begins with a number is a factor as often.
    let starts_with_number = inside.first().is_some_and(|item| matches!(item.layout, Layout::Number(_)));
    let is_latin = base.len() == 1 && base != "O" && !is_legendre && !is_spherical;
    if is_latin && is_sum && (starts_with_number || is_value && ["f", "q", "x", "y"].contains(&base)) {
        return false;
    }
    is_known && name.primes == 0
        || of_a_place.contains(&base)
            && !is_value
            && base != "q"
            && base != "x"
            && inside.iter().all(is_part)
            && has_place
            && is_argument
        || ["q", "x", "y"].contains(&base) && inside.iter().all(is_part) && inside.iter().any(is_time)
}

fn is_time(item: &Item) -> bool {
    names::printed(item, None).is_some_and(|found| found.name.base == "t")
}

/// Whether an item is ∇ or a vector: `\Gamma(\vec n\cdot\nabla\phi)` is a product.
fn is_field(item: &Item) -> bool {
    matches!(&item.layout, Layout::Command(name) if name == "\\nabla")
        || names::printed(item, None).is_some_and(|found| is_vectorial(&found.name.base))
}

/// Greek letters that are indices of space and time.
const GREEK: [&str; 10] =
    ["\\mu", "\\nu", "\\rho", "\\sigma", "\\lambda", "\\alpha", "\\beta", "\\gamma", "\\delta", "\\kappa"];

/// Latin letters that are usual as indices.
const LATIN: [&str; 9] = ["a", "b", "c", "d", "i", "j", "k", "l", "m"];

/// The lone letter that stands above a letter.
fn letter_above(item: &Item) -> Option<String> {
    let found = names::printed(item, None)?;
    let sup = names::printed(found.sup?, None).filter(|sup| sup.sup.is_none() && sup.name.subscript.is_empty())?;
    (found.name.base != "e").then_some(sup.name.base)
}

/// The letters below a letter.
fn subscripts(item: &Item) -> Vec<String> {
    names::printed(item, None).map(|found| found.name.subscript).unwrap_or_default()
}

/// A letter with dots.
fn is_rate(item: &Item) -> bool {
    names::printed(item, None).is_some_and(|found| found.dots > 0)
}

/// A letter with a T above it, and no number: `J^T`, `\dot q^T`.
fn is_transposed(item: &Item) -> bool {
    let Layout::Scripts { nucleus, sup: Some(sup), .. } = &item.layout else { return false };
    let is_mark = is_transpose(sup) || is_inverse_transpose(sup) && may_be_a_matrix(nucleus);
    is_mark && names::printed(nucleus, None).is_some_and(|found| found.name.base != "e")
}

/// Whether a base is a capital or in bold, as the names of matrices are: `J^{-T}`. A discount `(1 + r)^{-T}` is none.
fn may_be_a_matrix(nucleus: &Item) -> bool {
    match &nucleus.layout {
        Layout::Letter(c) => c.is_ascii_uppercase(),
        Layout::Style(style, _) => style == "\\mathbf",
        _ => false,
    }
}

/// Whether a hat stands over a letter, in parentheses perhaps.
fn has_hat(item: &Item) -> bool {
    match &item.layout {
        Layout::Accent(accent, inner) => accent == "\\hat" && names::printed(inner, None).is_some(),
        Layout::Scripts { nucleus, .. } => has_hat(nucleus),
        Layout::Fence(Delimiter::Round, inside) => inside.iter().any(has_hat),
        _ => false,
    }
}

/// Whether `1 - e^2` or `e^2 - 1` stands among some items: e is an eccentricity there.
fn has_eccentricity(items: &[Item]) -> bool {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let is_one = |item: &Item| whole_number(item) == Some(1);
    let is_square = |item: &Item| {
        matches!(&item.layout, Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 }
            if nucleus.layout == Layout::Letter('e') && whole_number(sup) == Some(2))
    };
    solid.windows(3).any(|three| {
        let is_sign = matches!(three[1].layout, Layout::Other('-'));
        is_sign && (is_one(three[0]) && is_square(three[2]) || is_square(three[0]) && is_one(three[2]))
    })
}

/// Whether a fraction is one of charges, `\frac{e^2}{r}`, `\frac{m e^4}{2}`: an even power of e over a distance, or beside
/// a letter that no exponential has as a factor.
fn is_of_charges(above: &Item, below: &Item) -> bool {
    let is_even = |item: &Item| {
        matches!(&item.layout, Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 }
            if nucleus.layout == Layout::Letter('e') && matches!(whole_number(sup), Some(2 | 4 | 6)))
    };
    let is_one_of = |items: &[Item], letters: &[&str]| {
        items
            .iter()
            .filter_map(|item| names::printed(item, None))
            .any(|found| letters.contains(&found.name.base.as_str()))
    };
    contents(above).iter().any(is_even)
        && (is_one_of(contents(below), &["r", "R", "a", "|"]) || is_one_of(contents(above), &["m", "k", "Z", "N", "n"]))
}

#[derive(Default)]
struct Found {
    /// The letters of subscripts that consist of index letters.
    lower: Vec<String>,
    transposes: usize,
    /// The names below a T, and all others.
    transposed: Vec<Name>,
    plain: Vec<Name>,
    /// Letters above what is differentiated or varied, which are no powers; and the lone letters above and below any letter.
    upper: Vec<String>,
    /// Letters with 0 or 1 above them, capitals with any number, and whether ∂ has a number below.
    components: Vec<String>,
    capitals: Vec<String>,
    has_numbered_derivatives: bool,
    /// Letters above ∂ or d: the order of a derivative.
    orders: Vec<String>,
    above: Vec<String>,
    below: Vec<String>,
    /// The number of letters below a T with another factor after them.
    transposed_factors: usize,
    /// Whether a subscript has two index letters, and the letters of superscripts with two.
    has_pairs: bool,
    pairs: Vec<String>,
    has_matrix: bool,
    has_constants: bool,
    has_states: bool,
    has_operators: bool,
    has_lone_e: bool,
    has_eccentricity: bool,
    has_exponential: bool,
    /// The two points between which a vector goes, `\vec{PM}`.
    segments: Vec<String>,
}

impl Found {
    fn list(&mut self, items: &[Item]) {
        self.has_eccentricity |= has_eccentricity(items);
        for (at, item) in items.iter().enumerate() {
            self.one(item);
            let next = items[at + 1..].iter().find(|item| !matches!(item.layout, Layout::Space(Space::Thin)));
            let is_factor = |item: &Item| {
                names::printed(item, None).is_some()
                    || matches!(item.layout, Layout::Fence(Delimiter::Round | Delimiter::Square, _))
            };
            let before = at.checked_sub(1).map(|before| &items[before].layout);
            let is_varied = matches!(before, Some(Layout::Command(name)) if name == "\\delta" || name == "\\partial");
            if let Some(letter) = letter_above(item) {
                let is_paired = || items.iter().any(|other| subscripts(other).contains(&letter));
                if is_varied || is_rate(item) && is_paired() {
                    self.upper.push(letter.clone());
                }
                self.above.push(letter);
            }
            // `h^k(\xi)`: a label, for nobody raises a function so.
            let argument = items.get(at + 1).and_then(|next| match &next.layout {
                Layout::Fence(Delimiter::Round, inside) => match inside.as_slice() {
                    [only] => names::printed(only, None).filter(|found| found.sup.is_none()),
                    _ => None,
                },
                _ => None,
            });
            if let (Some(letter), Some(_)) = (letter_above(item), argument)
                && ["i", "j", "k", "l", "m", "n"].contains(&letter.as_str())
            {
                self.lower.push(letter);
            }
            self.below.extend(subscripts(item));
            self.transposed_factors += usize::from(is_transposed(item) && next.is_some_and(is_factor));
        }
    }

    fn one(&mut self, item: &Item) {
        if let Some(found) = names::printed(item, None).filter(|found| found.sup.is_none()) {
            self.plain.push(found.name);
        }
        if let Layout::Command(name) = &item.layout {
            self.has_constants |= name == "\\hbar";
        }
        self.has_lone_e |= item.layout == Layout::Letter('e');
        // Stirling's formula, and the limit of (1 + 1/n)^n: there e is Euler's number.
        self.has_exponential |= item.layout == Layout::Other('!') || is_limit(item);
        match &item.layout {
            Layout::Command(name) if name == "\\psi" || name == "\\Psi" => self.has_states = true,
            Layout::Scripts { nucleus, sub, sup, .. } => self.scripts(nucleus, sub.as_deref(), sup.as_deref()),
            Layout::Fence(Delimiter::Ket | Delimiter::Bra, _) => self.has_states = true,
            // `\langle \hat x^2 \rangle`: what has a mean value is an operator.
            Layout::Fence(Delimiter::Angle, inside) => {
                self.has_operators |= inside.iter().any(has_hat);
                self.list(inside);
            }
            Layout::Group(items) | Layout::Fence(_, items) => {
                self.upper.extend(indexed_arguments(items));
                self.list(items);
            }
            Layout::Fraction(a, b) => {
                self.has_constants |= is_of_charges(a, b);
                self.has_eccentricity |= has_eccentricity(contents(a)) || has_eccentricity(contents(b));
                self.one(a);
                self.one(b);
            }
            Layout::Accent(accent, inner) if accent == "\\hat" => self.has_operators |= is_an_operator_with_hat(inner),
            Layout::Accent(accent, inner) if accent == "\\vec" => {
                self.segments.extend(segment(inner));
                self.one(inner);
            }
            Layout::Root(_, a) => {
                self.has_eccentricity |= has_eccentricity(contents(a));
                self.one(a);
            }
            Layout::Accent(_, a) | Layout::Style(_, a) => self.one(a),
            Layout::Environment(name, rows) => {
                self.has_matrix |= name.ends_with("matrix") || name == "array";
                rows.iter().flatten().for_each(|cell| self.list(cell));
            }
            _ => {}
        }
    }

    fn scripts(&mut self, nucleus: &Item, sub: Option<&Item>, sup: Option<&Item>) {
        self.has_states |= matches!(&nucleus.layout, Layout::Command(name)
            if ["\\partial", "\\psi", "\\Psi"].contains(&name.as_str()));
        if let (Some(number), Some(found)) = (sup.and_then(whole_number), names::printed(nucleus, None)) {
            match number {
                0 | 1 => self.components.push(found.name.base),
                _ if found.name.base.starts_with(|c: char| c.is_uppercase()) => {
                    self.capitals.push(found.name.base);
                }
                _ => {}
            }
        }
        let is_partial = matches!(&nucleus.layout, Layout::Command(name) if name == "\\partial");
        self.has_numbered_derivatives |= is_partial && sub.and_then(whole_number).is_some();
        if (is_partial || differential(nucleus).is_some())
            && let Some(sup) = sup.and_then(|sup| names::printed(sup, None))
        {
            self.orders.push(sup.name.base);
        }
        if names::printed(nucleus, None).is_none() {
            self.one(nucleus);
        }
        // The square of a unit vector is 1, and nobody writes it.
        let has_power = sup.and_then(whole_number).is_some_and(|power| power > 1);
        self.has_operators |= has_power && has_hat(nucleus);
        let is_epsilon =
            matches!(&nucleus.layout, Layout::Command(name) if ["\\epsilon", "\\varepsilon"].contains(&name.as_str()));
        if let Some(sub) = sub {
            self.has_constants |=
                is_epsilon && contents(sub).iter().any(|item| item.layout == Layout::Number("0".to_owned()));
            let below = letters(sub).unwrap_or_default();
            self.has_pairs |= below.len() > 1;
            self.lower.extend(below);
        }
        if let Some(sup) = sup {
            self.superscript(nucleus, sub, sup);
        }
    }

    fn superscript(&mut self, nucleus: &Item, sub: Option<&Item>, sup: &Item) {
        // An index above indices: `\Gamma^k_{ij}`. Two letters above, as in `g^{kl}`, beside a pair below.
        if let (Some(above), Some(below)) = (letters(sup), sub.and_then(letters))
            && below.len() > 1
        {
            self.lower.extend(above);
            self.has_pairs = true;
        }
        if let Some(above) = letters(sup).filter(|above| above.len() > 1) {
            self.pairs.extend(above);
        }
        if is_transpose(sup) || is_inverse_transpose(sup) && may_be_a_matrix(nucleus) {
            if let Some(found) = names::printed(nucleus, None) {
                self.transposed.push(found.name);
            }
            let is_upright = !matches!(contents(sup), [.., Item { layout: Layout::Letter('T'), .. }]);
            let is_bold = matches!(nucleus.layout, Layout::Style(..) | Layout::Accent(..) | Layout::Fence(..));
            self.transposes += 1 + usize::from(is_upright || is_bold);
        } else {
            let is_e = nucleus.layout == Layout::Letter('e');
            let is_figure =
                contents(sup).iter().all(|item| matches!(item.layout, Layout::Number(_) | Layout::Other('-')));
            self.has_exponential |= is_e && !is_figure;
            self.list(contents(sup));
        }
    }
}

/// Whether a letter with a hat is an operator, and no direction.
fn is_an_operator_with_hat(inner: &Item) -> bool {
    const DIRECTIONS: [&str; 12] = ["e", "n", "r", "i", "j", "k", "x", "y", "z", "\\theta", "\\phi", "\\rho"];
    let letter = names::printed(inner, None).map(|found| found.name.base);
    letter.is_some_and(|letter| {
        letter.len() == 1 && !DIRECTIONS.contains(&letter.as_str()) && letter != "s" && letter != "t" && letter != "u"
    })
}

/// The letters above the names of a list with a rate in it, `(q^i, \dot q^i, t)`: nobody passes powers on.
fn indexed_arguments(items: &[Item]) -> Vec<String> {
    let parts: Vec<&[Item]> = items.split(|item| item.layout == Layout::Other(',')).collect();
    let lone = |part: &[Item]| -> Option<Item> {
        let mut solid = part.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
        match (solid.next(), solid.next()) {
            (Some(only), None) => names::printed(only, None).map(|_| only.clone()),
            _ => None,
        }
    };
    let arguments: Vec<Item> = parts.iter().filter_map(|part| lone(part)).collect();
    match arguments.len() == parts.len() && parts.len() > 1 && arguments.iter().any(is_rate) {
        true => arguments.iter().filter_map(letter_above).collect(),
        false => Vec::new(),
    }
}

/// Two capitals, which are points below an arrow: `\overrightarrow{PM}`.
pub(in super::super::super) fn segment(inner: &Item) -> Option<String> {
    let capital = |item: &Item| match item.layout {
        Layout::Letter(letter @ 'A'..='Z') => Some(letter),
        _ => None,
    };
    contents(inner).iter().map(capital).collect::<Option<String>>().filter(|points| points.len() > 1)
}

/// The letters of a script, if it consists of usual index letters, digits and commas.
fn letters(script: &Item) -> Option<Vec<String>> {
    let mut found = Vec::new();
    for item in contents(script) {
        match &item.layout {
            Layout::Space(_) | Layout::Other(',' | ';') | Layout::Number(_) => {}
            _ => {
                let name = names::printed(item, None).filter(|found| found.sup.is_none())?.name;
                let is_usual = GREEK.contains(&name.base.as_str()) || LATIN.contains(&name.base.as_str());
                found.push(is_usual.then_some(name.base)?);
            }
        }
    }
    Some(found)
}
