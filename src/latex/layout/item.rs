//! The layout tree: what is typeset, and the bytes that it came from.

use crate::formula::units::Unit;
use crate::source::{Fault, Span};

use super::super::lexer::Space;

/// One typeset thing and its bytes.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// What it is.
    pub layout: Layout,
    /// Where it stands.
    pub span: Span,
}

/// What is typeset.
#[derive(Clone, Debug, PartialEq)]
pub enum Layout {
    /// A single letter.
    Letter(char),
    /// Digits, with a decimal point perhaps.
    Number(String),
    /// A command without arguments: `\theta`, `\sin`, `\cdot`, `\{`.
    Command(String),
    /// A single other character: `+`, `=`, `,`.
    Other(char),
    /// A typeset space.
    Space(Space),
    /// `{ … }`
    Group(Vec<Item>),
    /// `( … )`, `[ … ]`, `\{ … \}`, `| … |`, with or without `\left`, `\right`.
    Fence(Delimiter, Vec<Item>),
    /// A nucleus with scripts; at least one of them is there.
    Scripts {
        /// What carries the scripts.
        nucleus: Box<Item>,
        /// `_ …`
        sub: Option<Box<Item>>,
        /// `^ …`
        sup: Option<Box<Item>>,
        /// The number of primes.
        primes: u8,
    },
    /// `\frac`
    Fraction(Box<Item>, Box<Item>),
    /// `\sqrt`, with its index.
    Root(Option<Box<Item>>, Box<Item>),
    /// `\dot`, `\vec`, `\hat`, …: the command and what is under the accent.
    Accent(String, Box<Item>),
    /// `\mathbf`, `\mathrm`, …: the command and what is set in that style.
    Style(String, Box<Item>),
    /// `\text{…}`: its letters, without spaces.
    Text(String),
    /// Units after a number.
    Unit(Units),
    /// A run of items that is declared to be one quantity, as LaTeX.
    #[cfg(feature = "notes")]
    Value(String),
    /// Terms that are left out at the end of a sum, with what stands in `O(…)`.
    #[cfg(feature = "notes")]
    Rest(Option<Vec<Item>>),
    /// `\begin{name} … \end{name}`: rows of cells.
    Environment(String, Vec<Vec<Vec<Item>>>),
    /// `\\`
    Row,
    /// `&`
    Align,
    /// Something that was not understood.
    Fault(Fault),
}

/// A product of powers of units, as it was printed.
#[derive(Clone, Debug, PartialEq)]
pub struct Units {
    /// The units with their exponents.
    pub factors: Vec<(Unit, i32)>,
    /// Why it may be read in two ways.
    pub fault: Option<Fault>,
    /// What was printed, without a meaning.
    pub plain: Vec<Item>,
    /// Whether a slash stands in it, after which one more factor would be ambiguous.
    pub(super) divides: bool,
    /// Whether it is one upright letter without `\text`, which may be a name.
    pub(super) is_letter: bool,
}

/// A pair of delimiters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Delimiter {
    /// `( )`
    Round,
    /// `[ ]`
    Square,
    /// `\{ \}`
    Curly,
    /// `\left| \right|`, `\lvert \rvert`
    Bar,
    /// `| |` without sizing, which does not say whether it opens or closes
    PlainBar,
    /// `\| \|`
    DoubleBar,
    /// `\langle \rangle`
    Angle,
    /// `\left. \right|`, the bar of an evaluation
    Evaluation,
    /// `| \rangle`
    Ket,
    /// `\langle |`
    Bra,
    /// `[ )`
    RightOpen,
    /// `( ]`
    LeftOpen,
}

/// The letters, digits and signs of an item, run together: the words of a `\text`, the name of an environment.
pub(super) fn letters(item: &Item) -> String {
    match &item.layout {
        Layout::Letter(c) | Layout::Other(c) => c.to_string(),
        Layout::Number(digits) => digits.clone(),
        Layout::Group(items) => {
            // `\text{N/(A·m)}`: all in the parenthesis stands below the slash.
            let below = |at: usize| at > 0 && items[at - 1].layout == Layout::Other('/');
            let one = |(at, item): (usize, &Item)| match &item.layout {
                Layout::Fence(Delimiter::Round, _) if below(at) => format!("({})", letters(item)),
                _ => letters(item),
            };
            items.iter().enumerate().map(one).collect()
        }
        Layout::Fence(_, items) => items.iter().map(letters).collect(),
        Layout::Style(_, inner) | Layout::Accent(_, inner) => letters(inner),
        Layout::Command(name) => name.clone(),
        Layout::Text(text) => text.clone(),
        Layout::Unit(units) => units.plain.iter().map(letters).collect(),
        // `\text{Newton's law}`
        Layout::Scripts { nucleus, sub: None, sup: None, primes } => {
            letters(nucleus) + &"'".repeat(usize::from(*primes))
        }
        _ => String::new(),
    }
}

impl Item {
    /// The rows of the one environment that is all there is in other rows; else those rows.
    pub(in super::super) fn inner_rows(rows: &[Vec<Vec<Item>>]) -> &[Vec<Vec<Item>>] {
        let is_space = |item: &&Item| !matches!(item.layout, Layout::Space(_));
        let [row] = rows else { return rows };
        let [cell] = row.as_slice() else { return rows };
        let mut items = cell.iter().filter(is_space);
        match (items.next().map(|item| &item.layout), items.next()) {
            (Some(Layout::Environment(name, inner)), None)
                if ["aligned", "gathered", "split", "array"].contains(&name.as_str()) =>
            {
                inner
            }
            _ => rows,
        }
    }
}

/// The items inside a group, or the item itself.
pub(crate) fn contents(item: &Item) -> &[Item] {
    match &item.layout {
        // `\frac{{\partial S}}{{\partial N}}`
        Layout::Group(items) => match items.as_slice() {
            [only @ Item { layout: Layout::Group(_), .. }] => contents(only),
            _ => items,
        },
        _ => std::slice::from_ref(item),
    }
}

/// The lists of items directly inside an item.
#[cfg(feature = "notes")]
pub(crate) fn parts(item: &Item) -> Vec<&[Item]> {
    match &item.layout {
        Layout::Group(items) | Layout::Fence(_, items) => vec![items],
        Layout::Fraction(a, b) => vec![contents(a), contents(b)],
        Layout::Root(_, a) | Layout::Accent(_, a) | Layout::Style(_, a) => vec![contents(a)],
        Layout::Scripts { nucleus, .. } => vec![contents(nucleus)],
        Layout::Environment(_, rows) => rows.iter().flatten().map(Vec::as_slice).collect(),
        _ => Vec::new(),
    }
}

/// ∂, ∇ or an upright d, which braces around it do not part from what it acts on.
pub(super) fn is_derivative_mark(item: &Item) -> bool {
    match &item.layout {
        Layout::Command(name) => name == "\\nabla" || name == "\\partial",
        Layout::Style(style, inner) if style == "\\mathrm" => match &inner.layout {
            Layout::Letter('d') => true,
            Layout::Group(items) => matches!(items.as_slice(), [Item { layout: Layout::Letter('d'), .. }]),
            _ => false,
        },
        _ => false,
    }
}

/// Whether an equals sign stands directly in a group.
pub(super) fn has_equals(item: &Item) -> bool {
    matches!(&item.layout, Layout::Group(items) if items.iter().any(|item| item.layout == Layout::Other('=')))
}

/// The letters of items that are letters and spaces; empty, if there are others.
pub(super) fn letters_and_spaces(items: &[Item]) -> String {
    let one = |item: &Item| match item.layout {
        Layout::Letter(c) => Some(c),
        Layout::Space(_) => Some(' '),
        _ => None,
    };
    items.iter().map(one).collect::<Option<String>>().unwrap_or_default()
}

/// Whether braces set nothing: around nothing, a parenthesis, `\theta{\left(t \right)}`, a derivative without what it acts on,
/// `{\frac{d}{dt}}(mv)`, or a sign, `a{\times}b`. Around another fraction they end an argument: `\sin{\frac{x}{2}} y`.
pub(super) fn prints_alone(items: &[Item]) -> bool {
    const SIGNS: [&str; 8] = ["\\times", "\\cdot", "\\pm", "\\mp", "\\approx", "\\equiv", "\\leq", "\\geq"];
    match items {
        [] => true,
        [Item { layout, .. }] => match layout {
            Layout::Fence(Delimiter::Round, _) => true,
            Layout::Fraction(above, _) => is_mark_of_a_derivative(above),
            Layout::Other(c) => "=<>".contains(*c),
            Layout::Command(name) => SIGNS.contains(&name.as_str()),
            _ => false,
        },
        _ => false,
    }
}

/// Whether a d or ∂ is all that stands above the line of a fraction, with its order perhaps: `d^n`.
fn is_mark_of_a_derivative(above: &Item) -> bool {
    let only = match &above.layout {
        Layout::Group(items) => match items.as_slice() {
            [only] => only,
            _ => return false,
        },
        _ => above,
    };
    let mark = if let Layout::Scripts { nucleus, sub: None, primes: 0, .. } = &only.layout { nucleus } else { only };
    mark.layout == Layout::Letter('d') || is_derivative_mark(mark)
}
