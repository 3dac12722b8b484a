//! Parentheses after a name that hold a factor by what stands in or beside them.

use crate::formula::SymbolId;
use crate::formula::symbols::{Kind, Name};

use super::super::super::arguments::names_itself;
use super::super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::super::names;
use super::super::items::{is_numeric_item, is_transpose, joint, whole_number};
use super::super::state::Reader;
use super::inside::{FIELDS, has_rate, is_function, parenthesis, relation_or_comma};

impl Reader<'_> {
    /// Whether braces hold a sum, `D\{a + b\}`, or a coefficient stands before brackets around parentheses, `a[(b + c) + d]`.
    /// The arguments of a function stand in neither.
    pub(super) fn is_a_product_by_its_brackets(&self, id: SymbolId, fence: &Item) -> bool {
        let Layout::Fence(delimiter, inside) = &fence.layout else { return false };
        // `x\left[\begin{matrix} 0 & 1 \\ 1 & 0 \end{matrix}\right]`: the brackets are those of the matrix.
        if let [Item { layout: Layout::Environment(name, _), .. }] = inside.as_slice()
            && name.ends_with("matrix")
        {
            return true;
        }
        let name = &self.symbols.entry(id).name;
        let is_sum = inside.iter().skip(1).any(|item| self.is_sign(item));
        let holds = |of: &dyn Fn(&Item) -> bool| inside.iter().any(of);
        let is_enclosed = |item: &Item| matches!(item.layout, Layout::Fence(Delimiter::Round, _));
        const COEFFICIENTS: [&str; 9] = ["a", "b", "c", "k", "A", "B", "C", "\\alpha", "\\lambda"];
        is_sum
            && !holds(&relation_or_comma)
            && name.primes == 0
            && match delimiter {
                Delimiter::Curly => name.base.chars().all(char::is_alphabetic),
                // `H_0^2[\Omega_m + \Omega_r]`
                Delimiter::Square => {
                    COEFFICIENTS.contains(&name.base.as_str()) && holds(&is_enclosed) || name.subscript == ["0"]
                }
                _ => false,
            }
    }

    /// Whether a parenthesis is a factor by the name in it or by its power: `J(J + 1)`, a power of the letter that a Σ binds, as in
    /// `f_k (t - t_0)^k`, and a transposed sum that begins with a unit matrix, `P(I - K H)^T`.
    pub(super) fn is_a_product_by_its_power(&self, id: SymbolId, next: &Item) -> bool {
        let name = &self.symbols.entry(id).name;
        let (fence, sup) = match &next.layout {
            Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } => (&**nucleus, Some(&**sup)),
            _ => (next, None),
        };
        let Layout::Fence(Delimiter::Round, inside) = &fence.layout else { return false };
        let solid: Vec<&Item> = inside.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        let is_unit = |item: &Item| {
            names::printed(item, None).is_some_and(|found| {
                found.sup.is_none() && ["I", "\\mathbf{I}", "\\mathbb{1}"].contains(&found.name.base.as_str())
            })
        };
        let starts_with_unit = matches!(solid.as_slice(), [unit, sign, ..] if is_unit(unit) && self.is_sign(sign));
        let letter = sup.and_then(|sup| contents(sup).first()).and_then(|first| names::printed(first, None));
        let is_bound = letter.is_some_and(|found| {
            let letter = found.name.to_string();
            found.sup.is_none() && self.bound.contains(&letter) && name.subscript == [letter.as_str()]
        });
        names_itself(inside, name) || is_bound && solid.len() > 1 || sup.is_some_and(is_transpose) && starts_with_unit
    }

    /// Whether a parenthesis is a factor by what the name is in the display: a matrix, a factor beside rates, or a value at the
    /// beginning before a sum that begins with a number; or a change is raised to a power after a name with a subscript.
    pub(super) fn is_a_product_by_its_kind(&self, id: SymbolId, inside: &[&Item], is_powered: bool) -> bool {
        let name = &self.symbols.entry(id).name;
        let inferred = &self.symbols.inferred;
        // `f(\dot x^2 + \dot y^2)` beside f \dot t^2.
        let is_factor = inferred.factors.contains(name) && inside.iter().any(|item| has_rate(item));
        // `V_m (\Delta\alpha)^2`
        let is_change = matches!(inside, [Item { layout: Layout::Command(mark), .. }, _] if mark == "\\Delta");
        let is_squared = is_powered && is_change && !name.subscript.is_empty();
        // `N_0(1 - \lambda t)`, `V_{in}(1 + \frac{R_2}{R_1})`
        let begins = matches!(inside, [Item { layout: Layout::Number(_), .. }, sign, ..] if self.is_sign(sign));
        let is_divided = begins && inside.len() > 2 && inside[2..].iter().all(|item| is_ratio(item));
        let is_divider = matches!(inside, [only] if is_ratio(only));
        let is_labelled = is_electric(name) && !is_powered;
        let is_value = name.subscript == ["0"] && begins || is_labelled && (is_divided || is_divider);
        name.primes == 0 && (is_factor || is_squared || is_value || inferred.matrices.contains(&name.base))
    }

    /// Whether a power of a letter that is no usual function stands before a quotient of letters, `I^2\left(\frac{\rho L}{A}\right)`: the power
    /// of a value would stand behind the parenthesis.
    pub(super) fn is_before_a_quotient(&self, id: SymbolId, sup: Option<&Item>, next: &Item) -> bool {
        let entry = self.symbols.entry(id);
        let is_power = sup.and_then(whole_number).is_some_and(|power| power > 1);
        let is_quotient = matches!(&next.layout, Layout::Fence(Delimiter::Round, inside)
            if matches!(inside.as_slice(), [only] if matches!(only.layout, Layout::Fraction(..)) && !is_numeric_item(only)));
        self.symbols.open
            && is_power
            && is_quotient
            && !is_function(entry)
            && !FIELDS.contains(&entry.name.base.as_str())
            && !self.is_inferred_function(&entry.name)
    }

    /// Whether a vector stands before a sum of vectors, `\mathbf{E}(\mathbf{r} - \mathbf{a})`: it is a function or a matrix, since
    /// a product of vectors has a sign.
    pub(super) fn is_before_a_sum_of_vectors(&self, id: SymbolId, inside: &[&Item]) -> bool {
        let is_vector = |item: &&Item| {
            let found = names::printed(item, self.branch).filter(|found| found.sup.is_none());
            found.is_some_and(|found| ["\\vec{", "\\mathbf{"].iter().any(|mark| found.name.base.contains(mark)))
        };
        let is_product = |item: &&Item| joint(item).is_some();
        let terms: Vec<&[&Item]> = inside.split(|item| self.is_sign(item)).filter(|term| !term.is_empty()).collect();
        let has_vector = |term: &[&Item]| term.iter().filter(|item| is_vector(item)).count() == 1;
        self.symbols.entry(id).kind == Kind::Vector
            && terms.len() > 1
            && terms.iter().all(|term| has_vector(term) && !term.iter().any(is_product))
    }

    /// Whether a parenthesis with more than a letter stands between a wave function with a star and the same without.
    pub(super) fn is_between_states(&self, id: SymbolId, items: &[Item], cursor: usize) -> bool {
        let base = self.symbols.entry(id).name.base.as_str();
        let is_wave = ["\\psi", "\\Psi", "\\phi", "\\varphi"].contains(&base);
        let mut rest = items[cursor.min(items.len())..].iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
        let is_operator = rest.next().and_then(parenthesis).is_some_and(|(_, inside)| inside.len() > 1);
        let next = rest.next().and_then(|next| names::printed(next, self.branch));
        is_wave && is_operator && next.is_some_and(|next| next.name.base == base)
    }

    /// Where the argument ends in which a root is a frequency: `\cos\sqrt{\frac km}\,t`, the root at a place and the time after it. A
    /// letter or a number after the time may be a factor.
    pub(in crate::latex::reader) fn time_after_a_root(&self, items: &[Item], at: usize) -> Option<usize> {
        let is_root = matches!(items.get(at)?.layout, Layout::Root(..));
        let spaces = items[at + 1..].iter().take_while(|item| matches!(item.layout, Layout::Space(_))).count();
        let end = at + 1 + spaces + 1;
        let time =
            names::printed(items.get(end - 1)?, self.branch).filter(|found| found.dots == 0 && found.sup.is_none());
        let is_time = time.is_some_and(|found| match &self.symbols.time {
            Some(time) => found.name == *time,
            None => self.symbols.open && found.name == Name::plain("t"),
        });
        let ends = items[end..].iter().all(|item| matches!(item.layout, Layout::Space(_)));
        (is_root && is_time && ends).then_some(end)
    }
}

/// A voltage or a current with a label of several letters, `V_{in}`, `i_{R_L}`, or with one that is no number and no index, `v_b`.
fn is_electric(name: &Name) -> bool {
    let is_order = |part: &String| {
        ["n", "m", "k", "l", "j", "t", "x"].contains(&part.as_str()) || part.chars().all(|c| c.is_ascii_digit())
    };
    ["V", "v", "I", "i", "U", "E"].contains(&name.base.as_str())
        && name.primes == 0
        && !name.subscript.is_empty()
        && !(name.subscript.len() == 1 && name.subscript.iter().all(is_order))
}

/// Whether an item is a quotient of resistances or impedances, which divide a voltage.
fn is_ratio(item: &Item) -> bool {
    fn are_impedances(item: &Item) -> bool {
        contents(item).iter().all(|item| match &item.layout {
            Layout::Number(_) | Layout::Space(_) | Layout::Other('+' | '-') => true,
            Layout::Fence(Delimiter::Round, _) => are_impedances(item),
            _ => names::printed(item, None).is_some_and(|found| {
                found.sup.is_none()
                    && ["R", "r", "Z", "X"].contains(&found.name.base.as_str())
                    && found.name.primes == 0
            }),
        })
    }
    match &item.layout {
        Layout::Fraction(above, below) => {
            let is_number = |part: &Item| contents(part).iter().all(|item| matches!(item.layout, Layout::Number(_)));
            are_impedances(above) && are_impedances(below) && !is_number(below)
        }
        _ => false,
    }
}
