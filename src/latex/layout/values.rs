//! Formulas that stand for one name, such as `\langle E \rangle` or `V(\vec r_i)`: a declared run of items becomes one item.
//!
//! What no part of the reader knows the value of may still be one quantity. Declared as a whole, it is read like a name:
//! wherever the same items stand, they are the same quantity. Places and spaces do not count in the comparison. A longer
//! run goes before a shorter one. A run that begins with Σ, ∏, ∫ or lim reaches to the end of its term, so it is found
//! only where a term ends.

use super::item::{Delimiter, Item, Layout, contents};
use super::print::latex;

/// Commands before which a term ends.
const ENDS: [&str; 24] = [
    "\\quad",
    "\\qquad",
    "\\equiv",
    "\\coloneqq",
    "\\lt",
    "\\gt",
    "\\leq",
    "\\geq",
    "\\neq",
    "\\approx",
    "\\propto",
    "\\sim",
    "\\simeq",
    "\\cong",
    "\\ll",
    "\\gg",
    "\\to",
    "\\rightarrow",
    "\\Rightarrow",
    "\\implies",
    "\\iff",
    "\\Leftrightarrow",
    "\\pm",
    "\\mp",
];

/// The declared runs of items, the longest first.
#[derive(Clone, Debug, Default)]
pub struct Values {
    runs: Vec<Vec<Item>>,
    /// The names whose differentials are rates.
    rates: Vec<Item>,
}

impl Values {
    /// Adds a run of items.
    pub fn add(&mut self, items: &[Item]) {
        let run: Vec<Item> = without_spaces(items).cloned().collect();
        if !run.is_empty() && !self.runs.iter().any(|known| same(known, &run)) {
            self.runs.push(run);
            self.runs.sort_by_key(|run| std::cmp::Reverse(run.len()));
        }
    }

    /// Makes a rate of the differential of a name; returns whether it is one.
    pub fn add_rate(&mut self, items: &[Item]) -> bool {
        let significant: Vec<&Item> = without_spaces(items).collect();
        let [d, name] = significant.as_slice() else { return false };
        let is_rate = is_d(d) && !matches!(name.layout, Layout::Fence(..));
        if is_rate {
            self.rates.push((*name).clone());
        }
        is_rate
    }

    /// The rate that stands at a place as a differential, and where it ends. The differential of the time is 1.
    fn rate(&self, items: &[Item], at: usize) -> Option<(Item, usize)> {
        let is_space = |item: &Item| matches!(item.layout, Layout::Space(_));
        let next = (at + 1..items.len()).find(|next| !is_space(&items[*next]))?;
        let (nucleus, raised) = match &items[next].layout {
            Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes } if !self.has_rate(&items[next]) => {
                (&**nucleus, Some((sup, *primes)))
            }
            _ => (&items[next], None),
        };
        if !is_d(&items[at]) || !self.has_rate(nucleus) {
            return None;
        }
        let span = items[at].span.to(items[next].span);
        let layout = match nucleus.layout {
            Layout::Letter('t') => Layout::Number("1".to_owned()),
            _ => Layout::Accent("\\dot".to_owned(), Box::new(nucleus.clone())),
        };
        let rate = Item { layout, span };
        let layout = match raised {
            Some((sup, primes)) => {
                Layout::Scripts { nucleus: Box::new(rate), sub: None, sup: Some(sup.clone()), primes }
            }
            None => return Some((rate, next + 1)),
        };
        Some((Item { layout, span }, next + 1))
    }

    fn has_rate(&self, name: &Item) -> bool {
        self.rates.iter().any(|known| same_item(known, name))
    }

    /// The items, in which each declared run is one item.
    pub(crate) fn named(&self, items: Vec<Item>) -> Vec<Item> {
        if self.runs.is_empty() && self.rates.is_empty() {
            return items;
        }
        let mut found = Vec::with_capacity(items.len());
        let mut at = 0;
        while at < items.len() {
            // The differential of an integral belongs to it.
            let in_integral = items[..at].iter().any(is_integral);
            let fits = |run: &Vec<Item>| !in_integral || !is_d(&run[0]);
            let found_run =
                self.runs.iter().filter(|run| fits(run)).find_map(|run| Some((run, end_of(run, &items, at)?)));
            match found_run {
                None if !in_integral && let Some((rate, end)) = self.rate(&items, at) => {
                    found.push(rate);
                    at = end;
                }
                Some((run, end)) => {
                    let span = items[at].span.to(items[end - 1].span);
                    found.push(Item { layout: Layout::Value(text_of(run)), span });
                    at = end;
                }
                None => {
                    found.push(self.inside(items[at].clone()));
                    at += 1;
                }
            }
        }
        found
    }

    /// An item, in whose parts each declared run is one item.
    fn inside(&self, item: Item) -> Item {
        let one = |item: Box<Item>| match self.named(vec![*item]).as_slice() {
            [only] => Box::new(only.clone()),
            items => Box::new(Item { layout: Layout::Group(items.to_vec()), span: items[0].span }),
        };
        // A derivative keeps its differentials.
        if is_derivative(&item) && !self.rates.is_empty() && !has_sign_below(&item) {
            return item;
        }
        let layout = match item.layout {
            Layout::Group(items) => Layout::Group(self.named(items)),
            Layout::Fence(delimiter, items) => Layout::Fence(delimiter, self.named(items)),
            Layout::Scripts { nucleus, sub, sup, primes } => {
                Layout::Scripts { nucleus: one(nucleus), sub, sup: sup.map(one), primes }
            }
            Layout::Fraction(above, below) => Layout::Fraction(one(above), one(below)),
            Layout::Root(index, radicand) => Layout::Root(index, one(radicand)),
            Layout::Accent(command, inner) => Layout::Accent(command, one(inner)),
            Layout::Style(command, inner) => Layout::Style(command, one(inner)),
            Layout::Environment(name, rows) => {
                let cells = |row: Vec<Vec<Item>>| row.into_iter().map(|cell| self.named(cell)).collect();
                Layout::Environment(name, rows.into_iter().map(cells).collect())
            }
            other => other,
        };
        Item { layout, span: item.span }
    }
}

/// The text of a run, which is the name that it stands for.
pub(crate) fn text_of(run: &[Item]) -> String {
    latex(&without_spaces(run).cloned().collect::<Vec<Item>>())
}

/// Whether items may stand for one name: a mean value, a group with scripts, a name with its arguments, a derivative, a sum
/// or an integral with what it acts on, ∇ with what it acts on, a differential.
pub(crate) fn is_value(items: &[Item]) -> bool {
    let significant: Vec<&Item> = without_spaces(items).collect();
    match significant.as_slice() {
        [] => false,
        [only] => match &only.layout {
            Layout::Fence(delimiter, _) => {
                matches!(delimiter, Delimiter::Angle | Delimiter::Ket | Delimiter::Bra)
            }
            Layout::Scripts { nucleus, sub, .. } => {
                let holds = matches!(nucleus.layout, Layout::Fence(..)) || is_derivative(nucleus);
                holds && sub.is_some()
            }
            Layout::Environment(name, _) => name == "cases",
            _ => is_derivative(only),
        },
        [first, .., last] => {
            is_operator(first)
                || is_nabla(first)
                || significant.len() == 2
                    && (is_d(first) || matches!(last.layout, Layout::Fence(Delimiter::Round, _) | Layout::Other('!')))
        }
    }
}

/// Whether an item is a quotient of differentials.
fn is_derivative(item: &Item) -> bool {
    matches!(&item.layout, Layout::Fraction(above, below) if is_differential(above) && is_differential(below))
}

/// The lists of items inside of an item.
pub(crate) fn parts_of(item: &Item) -> Vec<&[Item]> {
    match &item.layout {
        Layout::Group(items) | Layout::Fence(_, items) => vec![items],
        Layout::Scripts { nucleus, sup, .. } => {
            let above = sup.iter().map(|sup| contents(sup));
            std::iter::once(contents(nucleus)).chain(above).collect()
        }
        Layout::Fraction(above, below) => vec![contents(above), contents(below)],
        Layout::Root(_, inner) | Layout::Accent(_, inner) | Layout::Style(_, inner) => vec![contents(inner)],
        Layout::Environment(_, rows) => rows.iter().flatten().map(Vec::as_slice).collect(),
        _ => Vec::new(),
    }
}

/// Whether a derivative stands in items: a quotient of differentials, ∂, ∇ or overdots.
pub(super) fn has_derivative(items: &[Item]) -> bool {
    items.iter().any(|item| {
        let mark = |name: &str| name == "\\partial" || name == "\\nabla" || name.ends_with("dot") && name != "\\cdot";
        let is_mark = matches!(&item.layout, Layout::Command(name) | Layout::Accent(name, _) if mark(name));
        let is_primed = matches!(&item.layout, Layout::Scripts { primes: 1.., .. });
        is_mark || is_primed || is_derivative(item) || parts_of(item).into_iter().any(has_derivative)
    })
}

/// Whether a sum stands below the line of a fraction.
fn has_sign_below(item: &Item) -> bool {
    let Layout::Fraction(_, below) = &item.layout else { return false };
    let items = if let Layout::Group(items) = &below.layout { items } else { std::slice::from_ref(&**below) };
    items.iter().any(|item| matches!(item.layout, Layout::Other('+' | '-')))
}

/// Whether an item begins what reaches to the end of its term.
pub(crate) fn is_operator(item: &Item) -> bool {
    let nucleus = match &item.layout {
        Layout::Scripts { nucleus, .. } => nucleus,
        _ => item,
    };
    matches!(&nucleus.layout, Layout::Command(name)
        if ["\\sum", "\\prod", "\\int", "\\iint", "\\iiint", "\\oint", "\\oiint", "\\lim"].contains(&name.as_str()))
}

/// Whether an item is a sign of an integral.
pub(crate) fn is_integral(item: &Item) -> bool {
    let nucleus = match &item.layout {
        Layout::Scripts { nucleus, .. } => nucleus,
        _ => item,
    };
    matches!(&nucleus.layout, Layout::Command(name) if name.ends_with("int"))
}

/// Whether an item is ∇, perhaps squared.
pub(crate) fn is_nabla(item: &Item) -> bool {
    let nucleus = match &item.layout {
        Layout::Scripts { nucleus, .. } | Layout::Style(_, nucleus) | Layout::Accent(_, nucleus) => nucleus,
        _ => item,
    };
    matches!(&nucleus.layout, Layout::Command(name) if name == "\\nabla")
}

/// Whether an item is the d of a differential.
pub(crate) fn is_d(item: &Item) -> bool {
    match &item.layout {
        Layout::Letter('d') => true,
        Layout::Style(style, inner) => {
            style == "\\mathrm" && matches!(first_of(inner).map(|item| &item.layout), Some(Layout::Letter('d')))
        }
        _ => false,
    }
}

/// Whether a numerator or a denominator begins with d or ∂.
pub(crate) fn is_differential(item: &Item) -> bool {
    let first = first_of(item);
    first.is_some_and(|first| match &first.layout {
        Layout::Scripts { nucleus, .. } => is_d_or_partial(nucleus),
        _ => is_d_or_partial(first),
    })
}

/// Whether an item is the d or ∂ of a differential.
pub(crate) fn is_d_or_partial(item: &Item) -> bool {
    is_d(item) || matches!(&item.layout, Layout::Command(name) if name == "\\partial")
}

fn first_of(item: &Item) -> Option<&Item> {
    contents(item).first()
}

/// Where a run that begins here ends, if it stands here.
fn end_of(run: &[Item], items: &[Item], start: usize) -> Option<usize> {
    let mut wanted = run.iter();
    let mut next = wanted.next()?;
    let mut at = start;
    loop {
        let item = items.get(at)?;
        let is_space = matches!(item.layout, Layout::Space(_));
        if is_space && at == start || !is_space && !same_item(next, item) {
            return None;
        }
        at += 1;
        if !is_space {
            match wanted.next() {
                Some(item) => next = item,
                None => break,
            }
        }
    }
    let goes_on = items[at..].iter().find(|item| !matches!(item.layout, Layout::Space(_)));
    (!is_operator(&run[0]) || goes_on.is_none_or(ends_term)).then_some(at)
}

/// Whether a term ends before an item.
pub(crate) fn ends_term(item: &Item) -> bool {
    match &item.layout {
        Layout::Row | Layout::Align => true,
        Layout::Other(c) => "=+-<>,;.≠".contains(*c),
        Layout::Command(name) => ENDS.contains(&name.as_str()),
        Layout::Text(_) => true,
        _ => false,
    }
}

fn without_spaces(items: &[Item]) -> impl Iterator<Item = &Item> {
    items.iter().filter(|item| !matches!(item.layout, Layout::Space(_)))
}

fn same(a: &[Item], b: &[Item]) -> bool {
    let (mut a, mut b) = (without_spaces(a), without_spaces(b));
    loop {
        match (a.next(), b.next()) {
            (None, None) => return true,
            (Some(a), Some(b)) if same_item(a, b) => {}
            _ => return false,
        }
    }
}

/// Whether two items are the same, wherever they stand.
fn same_item(a: &Item, b: &Item) -> bool {
    let one = |a: &Option<Box<Item>>, b: &Option<Box<Item>>| match (a, b) {
        (None, None) => true,
        (Some(a), Some(b)) => same(contents(a), contents(b)),
        _ => false,
    };
    match (&a.layout, &b.layout) {
        (Layout::Group(a), _) if a.len() == 1 => same_item(&a[0], b),
        (_, Layout::Group(b)) if b.len() == 1 => same_item(a, &b[0]),
        (Layout::Group(a), Layout::Group(b)) => same(a, b),
        (Layout::Fence(kind, a), Layout::Fence(other, b)) => kind == other && same(a, b),
        (
            Layout::Scripts { nucleus, sub, sup, primes },
            Layout::Scripts { nucleus: other, sub: below, sup: above, primes: marks },
        ) => same_item(nucleus, other) && one(sub, below) && one(sup, above) && primes == marks,
        (Layout::Fraction(a, b), Layout::Fraction(c, d)) => same_item(a, c) && same_item(b, d),
        (Layout::Root(a, b), Layout::Root(c, d)) => one(a, c) && same_item(b, d),
        (Layout::Accent(a, b), Layout::Accent(c, d)) | (Layout::Style(a, b), Layout::Style(c, d)) => {
            a == c && same_item(b, d)
        }
        (Layout::Environment(a, rows), Layout::Environment(b, others)) => {
            let cells = |rows: &[Vec<Vec<Item>>]| rows.iter().map(Vec::len).collect::<Vec<_>>();
            let all = rows.iter().flatten().zip(others.iter().flatten());
            a == b && cells(rows) == cells(others) && all.into_iter().all(|(a, b)| same(a, b))
        }
        (a, b) => a == b,
    }
}

/// Whether a run is a vector by the markup of what is in it: a·b is none, a×b and A **b** are.
#[cfg(feature = "notes")]
pub(crate) fn is_vector(run: &[Item]) -> bool {
    let items: Vec<&Item> =
        without_spaces(run).take_while(|item| !matches!(item.layout, Layout::Other('+' | '-'))).collect();
    let is_command = |item: &&&Item, wanted: &str| matches!(&item.layout, Layout::Command(name) if name == wanted);
    let (dots, crosses) = (
        items.iter().filter(|item| is_command(item, "\\cdot")).count(),
        items.iter().filter(|item| is_command(item, "\\times")).count(),
    );
    let mut vectors = 0;
    for (at, item) in items.iter().enumerate() {
        let is_argument = matches!(item.layout, Layout::Fence(Delimiter::Round, _)) && at == 1 && items.len() == 2;
        vectors += usize::from(is_nabla(item) && !is_squared(item) || !is_argument && is_vector_item(item));
    }
    vectors == 2 * dots + crosses + 1
}

/// Whether an item is squared.
#[cfg(feature = "notes")]
fn is_squared(item: &Item) -> bool {
    matches!(&item.layout, Layout::Scripts { sup: Some(_), .. })
}

#[cfg(feature = "notes")]
fn is_vector_item(item: &Item) -> bool {
    match &item.layout {
        Layout::Accent(mark, _) => mark == "\\vec" || mark.ends_with("dot") && is_vector(parts(item)),
        Layout::Style(mark, _) => ["\\mathbf", "\\boldsymbol", "\\bm"].contains(&mark.as_str()),
        Layout::Scripts { nucleus, sup: None, .. } => !is_operator(item) && is_vector_item(nucleus),
        Layout::Group(inner) | Layout::Fence(Delimiter::Round | Delimiter::Square | Delimiter::Angle, inner) => {
            is_vector(inner)
        }
        Layout::Fraction(above, _) => is_vector(parts(above)),
        Layout::Environment(_, rows) => rows.iter().flatten().next().is_some_and(|cell| is_vector(cell)),
        _ => false,
    }
}

#[cfg(feature = "notes")]
fn parts(item: &Item) -> &[Item] {
    match &item.layout {
        Layout::Accent(_, inner) => contents(inner),
        _ => contents(item),
    }
}
