//! Symbols that a statement defines: an unknown name that is a whole member of a chain, and the formula beside it.
//!
//! An unknown name may be the left side, `\vec L = …`, or its square may be, `\omega_{eff}^2 = …`, or another whole power,
//! `r_0^3 = …`, of which it is the root. It may be a later
//! member of a chain of = and ≡, `… = M\vec v_{cm} = \vec P_{cm}`. After ≡ a sum of names may name the terms of the sum
//! before it, one by one: `… \equiv \vec L_{orb} + \vec L_{spin}`.

use crate::formula::shape::{self, Shape, Type};
use crate::formula::symbols::{Entry, Kind, Name, SymbolId, Symbols};
use crate::formula::tree::{Expr, Index, IndexId, Node, Sign, Term, Variable};
use crate::source::{Fault, Span};
use crate::suggest::declaration;

use super::layout::{Delimiter, Item, Layout};
use super::names;
use super::reader::Reader;

/// The highest power of a name that a formula defines.
const HIGHEST_POWER: u32 = 9;

/// A symbol that a statement of a display defines.
#[derive(Clone, Debug, PartialEq)]
pub struct DefinedSymbol {
    /// The symbol.
    pub symbol: SymbolId,
    /// The position of the statement in the display.
    pub statement: usize,
    /// The position of the member that is the name, or that contains it among others.
    pub member: usize,
    /// The defining formula. For a family it contains the index letters of the printed name; for a symbol defined by
    /// its square it is the square.
    pub formula: Expr,
}

/// A member of a chain that defines a symbol.
pub(super) enum Unknown {
    /// A name alone.
    Name(Name, Span),
    /// A name alone, squared.
    Square(Name, Span),
    /// A name alone, to a higher power.
    Power(Name, Span, u32),
    /// A name after a whole number, `2\beta = b/m`.
    Multiple(Name, Span, String),
    /// A name with known names in parentheses, `V(r)`: a function of them.
    Function(Name, Span, Vec<Variable>),
    /// A sum of names, each for one term.
    Terms(Vec<(Name, Span)>),
}

/// The position of a member in a chain.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Place {
    /// On the left of the first relation.
    First,
    /// After an =.
    AfterEqual,
    /// After an ≡.
    AfterIdentical,
}

/// A symbol that is to be added once the whole statement is read.
pub(super) struct New {
    name: Name,
    kind: Kind,
    slots: Vec<(usize, IndexId)>,
    squared: bool,
    arguments: Vec<Variable>,
    /// What defines it.
    pub formula: Expr,
}

impl New {
    /// Whether another part of the statement adds the same symbol.
    pub(super) fn is_same_symbol(&self, other: &New) -> bool {
        (&self.name, self.kind, &self.slots) == (&other.name, other.kind, &other.slots)
            && (self.squared, &self.arguments) == (other.squared, &other.arguments)
    }

    /// Whether a symbol of the table, or one that the statement adds before this one, has the name.
    pub(super) fn is_taken(&self, before: &[&New], symbols: &Symbols) -> bool {
        before.iter().any(|known| known.name == self.name)
            || symbols.find(&self.name).is_some_and(|(id, _)| symbols.entry(id).name == self.name)
    }

    /// Adds it; `None` where the name is taken.
    pub(super) fn add(self, symbols: &mut Symbols) -> Option<(SymbolId, Expr)> {
        let id = symbols.add_family(self.name, self.kind, self.slots)?;
        symbols.mark_defined(id, &self.formula, self.squared);
        symbols.entry_mut(id).arguments = self.arguments;
        Some((id, self.formula))
    }
}

/// Whether a name has a meaning by custom, as the numbers e and i and the d of a derivative have, so that only a display that
/// begins with it defines it.
fn has_a_custom(name: &Name) -> bool {
    name.subscript.is_empty() && ["e", "i", "d"].contains(&name.base.as_str())
}

/// Whether an item is the time in parentheses.
fn is_time(item: &Item, time: Option<&Name>) -> bool {
    let Layout::Fence(Delimiter::Round, inner) = &item.layout else { return false };
    matches!(inner.as_slice(), [only] if names::printed(only, None).is_some_and(|printed| Some(&printed.name) == time))
}

/// `\Delta x`, which is one name unless Δ is one.
fn difference(delta: &Item, only: &Item, symbols: &mut Symbols, branch: Option<Sign>) -> Option<Unknown> {
    let is_delta = matches!(&delta.layout, Layout::Command(command) if command == "\\Delta");
    if !is_delta || symbols.find(&Name::plain("\\Delta")).is_some() {
        return None;
    }
    let printed = names::difference(delta, only, branch).filter(|found| found.dots == 0 && found.sup.is_none())?;
    let is_known = Reader::new(symbols, branch).is_known(&printed, only.span);
    (!is_known).then(|| Unknown::Name(printed.name, delta.span.to(only.span)))
}

impl Unknown {
    /// The definition that these items are, if they are one.
    pub(super) fn of(items: &[Item], place: Place, symbols: &mut Symbols, branch: Option<Sign>) -> Option<Unknown> {
        if symbols.open {
            return None;
        }
        let significant: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        if let (true, [delta, only]) = (place == Place::First, significant.as_slice())
            && let Some(found) = difference(delta, only, symbols, branch)
        {
            return Some(found);
        }
        let time = symbols.time.clone();
        let mut name = |item: &Item, power: Option<u32>| {
            let printed = names::printed(item, branch).filter(|printed| printed.dots == 0)?;
            let reserved = printed.name.subscript.is_empty() && printed.name.base == "\\pi"
                || (power.is_some() || place != Place::First) && has_a_custom(&printed.name)
                || Some(&printed.name) == symbols.time.as_ref();
            if reserved
                || printed.sup.map(whole_power) != power.map(Some)
                || Reader::new(symbols, branch).is_known(&printed, item.span)
            {
                return None;
            }
            Some((printed.name, item.span))
        };
        match significant.as_slice() {
            [only] => match name(only, None) {
                Some((name, span)) => Some(Unknown::Name(name, span)),
                None if place == Place::First => {
                    let power = names::printed(only, branch)?.sup.and_then(whole_power)?;
                    let (name, span) = name(only, Some(power))?;
                    let is_vector = ["\\vec", "\\mathbf", "\\hat"].iter().any(|mark| name.base.contains(mark));
                    (!is_vector).then_some(match power {
                        2 => Unknown::Square(name, span),
                        _ => Unknown::Power(name, span, power),
                    })
                }
                None => None,
            },
            [Item { layout: Layout::Number(digits), .. }, only]
                if place == Place::First && digits.parse::<u32>().is_ok_and(|factor| factor > 1) =>
            {
                let (name, span) = name(only, None)?;
                let is_vector = ["\\vec", "\\mathbf", "\\hat"].iter().any(|mark| name.base.contains(mark));
                (!is_vector).then(|| Unknown::Multiple(name, significant[0].span.to(span), digits.clone()))
            }
            // `x(t)` is x, which may vary with time.
            [only, argument] if place == Place::First && is_time(argument, time.as_ref()) => {
                name(only, None).map(|(name, span)| Unknown::Name(name, span.to(argument.span)))
            }
            [only, arguments] if place == Place::First => {
                let (name, span) = name(only, None)?;
                let arguments = (arguments.span, Reader::new(symbols, branch).known_arguments(arguments)?);
                Some(Unknown::Function(name, span.to(arguments.0), arguments.1))
            }
            [first, rest @ ..] if place == Place::AfterIdentical && rest.len() % 2 == 0 => {
                let mut terms = vec![name(first, None)?];
                for pair in rest.chunks(2) {
                    let term = name(pair[1], None).filter(|_| pair[0].layout == Layout::Other('+'))?;
                    if terms.iter().any(|(known, _)| *known == term.0) {
                        return None;
                    }
                    terms.push(term);
                }
                Some(Unknown::Terms(terms))
            }
            _ => None,
        }
    }

    /// The fault if nothing defines the name.
    pub(super) fn undeclared(&self, symbols: &Symbols) -> Fault {
        let (name, span) = match self {
            Unknown::Name(name, span)
            | Unknown::Square(name, span)
            | Unknown::Power(name, span, _)
            | Unknown::Multiple(name, span, _)
            | Unknown::Function(name, span, _) => (name, *span),
            Unknown::Terms(terms) => (&terms[0].0, terms[0].1),
        };
        undeclared(name, span, symbols)
    }

    /// The member that is defined by `source`, its type, and the symbols to add; `next` is the id of the first of
    /// them.
    ///
    /// # Errors
    /// A name whose indices or arrow do not fit its definition.
    pub(super) fn introduce(
        &self,
        source: (&Expr, &Type),
        next: usize,
        symbols: &Symbols,
    ) -> Result<(Expr, Type, Vec<New>), Fault> {
        match self {
            Unknown::Name(name, span) => {
                let (expr, found, new) = one(name, *span, source, SymbolId(next), symbols)?;
                Ok((expr, found, vec![new]))
            }
            Unknown::Function(name, span, arguments) => {
                let (expr, found, mut new) = one(name, *span, source, SymbolId(next), symbols)?;
                new.arguments = arguments.clone();
                Ok((expr, found, vec![new]))
            }
            Unknown::Multiple(name, span, digits) => {
                let factor = || Expr::new(Node::Number(digits.clone()), *span);
                let part = Node::Quotient(Box::new(source.0.clone()), Box::new(factor()));
                let part = Expr::new(part, source.0.span);
                let (expr, found, new) = one(name, *span, (&part, source.1), SymbolId(next), symbols)?;
                if new.kind != Kind::Scalar {
                    return Err(undeclared(name, *span, symbols));
                }
                Ok((Expr::new(Node::Product(vec![factor(), expr]), *span), found, vec![new]))
            }
            Unknown::Square(name, span) => {
                let (expr, found, mut new) = one(name, *span, source, SymbolId(next), symbols)?;
                if new.kind != Kind::Scalar {
                    return Err(undeclared(name, *span, symbols));
                }
                new.squared = true;
                Ok((expr, found, vec![new]))
            }
            Unknown::Power(name, span, power) => {
                let root = Expr::new(Node::Root(*power, Box::new(source.0.clone())), source.0.span);
                let (expr, found, new) = one(name, *span, (&root, source.1), SymbolId(next), symbols)?;
                if new.kind != Kind::Scalar {
                    return Err(undeclared(name, *span, symbols));
                }
                let exponent = Expr::integer(*power, *span);
                Ok((Expr::new(Node::Power(Box::new(expr), Box::new(exponent)), *span), found, vec![new]))
            }
            Unknown::Terms(names) => {
                let Node::Sum(terms) = &source.0.node else { return Err(self.undeclared(symbols)) };
                if terms.len() != names.len() {
                    let span = names[0].1.to(names[names.len() - 1].1);
                    let message = format!("{} names stand for a sum of {} terms", names.len(), terms.len());
                    return Err(
                        Fault::new(span, message).help("write one name for each term of the sum, in the same order")
                    );
                }
                let (mut members, mut news) = (Vec::new(), Vec::new());
                let mut of_sum: Option<Type> = None;
                for (at, ((name, span), term)) in names.iter().zip(terms).enumerate() {
                    let signed = match term.sign {
                        Sign::Plus => term.expr.clone(),
                        Sign::Minus => term.expr.clone().negated(),
                    };
                    let (signed, found) = shape::bind(signed, symbols)?;
                    let (expr, found, new) = one(name, *span, (&signed, &found), SymbolId(next + at), symbols)?;
                    of_sum = Some(match of_sum {
                        None => found,
                        Some(known) => Type { free: shape::union(&known.free, &found.free), ..known },
                    });
                    members.push(Term { sign: Sign::Plus, sign_span: None, expr });
                    news.push(new);
                }
                let span = names[0].1.to(names[names.len() - 1].1);
                let found = of_sum.ok_or_else(|| self.undeclared(symbols))?;
                Ok((Expr::new(Node::Sum(members), span), found, news))
            }
        }
    }
}

fn undeclared(name: &Name, span: Span, symbols: &Symbols) -> Fault {
    let fault = Fault::undeclared(span, name);
    match symbols.nearest(name) {
        Some(near) => fault.help(format!("did you mean {near}? If not, {}", declaration(&name.to_string(), 0))),
        None => fault,
    }
}

/// One name and its definition. Its component indices must be the free component indices of the definition; its labels
/// must include the free labels.
fn one(
    name: &Name,
    span: Span,
    (source, of_source): (&Expr, &Type),
    id: SymbolId,
    symbols: &Symbols,
) -> Result<(Expr, Type, New), Fault> {
    let is_label = |letter: &IndexId| symbols.indices[letter.0].labels;
    let mut name = name.clone();
    let mut slots = symbols.slots(&name.subscript);
    if let Some(each) = symbols.for_each
        && slots.iter().all(|(_, letter)| *letter != each)
    {
        slots.push((name.subscript.len(), each));
        name.subscript.push(symbols.indices[each.0].letter.clone());
    }
    let letters: Vec<IndexId> = slots.iter().map(|(_, letter)| *letter).collect();
    let mut free = letters.clone();
    free.sort();
    if free.windows(2).any(|pair| pair[0] == pair[1]) {
        return Err(Fault::index(
            span,
            format!("{name} is not declared, and a name with repeated indices cannot be defined"),
        )
        .help("write different indices on the name, or declare the name in a claims file"));
    }
    if let Some(extra) = of_source.free.iter().find(|letter| is_label(letter) && !free.contains(letter)) {
        let letter = &symbols.indices[extra.0].letter;
        return Err(Fault::index(span, format!("the right side depends on the index {letter}, and {name} does not"))
            .help(format!("sum over the index, \\sum_{{{letter}}}, or give {name} the index {letter} too")));
    }
    let components = |free: &[IndexId]| -> Vec<IndexId> { free.iter().copied().filter(|l| !is_label(l)).collect() };
    let (left, right) = (components(&free), components(&of_source.free));
    let kind = match of_source.shape {
        Shape::Scalar if left == right => Some((Kind::Scalar, Shape::Scalar)),
        Shape::Vector if left == right => Some((Kind::Vector, Shape::Vector)),
        Shape::Complex if left == right => Some((Kind::Complex, Shape::Complex)),
        Shape::Matrix(rows, columns) if left == right && (1..=255).contains(&rows.min(columns)) => {
            Some((Kind::Matrix(rows as u8, columns as u8), of_source.shape))
        }
        // `R_{ab} = (…)` means the entries of the matrix.
        Shape::Matrix(3, 3) if right.is_empty() && left.len() == 2 => Some((Kind::Scalar, Shape::Scalar)),
        _ => None,
    };
    if let Some((kind, _)) = kind {
        // A name that the statement adds too is not in the table yet.
        let entries: Vec<(SymbolId, &Entry)> = symbols.iter().collect();
        let is_marked = |id: SymbolId| {
            let entry = entries.iter().find(|(known, _)| *known == id).map(|(_, entry)| *entry);
            entry.is_none_or(|entry| entry.kind == Kind::Vector && !is_plain(&entry.name))
        };
        let has_marks = source.symbols().is_empty() || source.symbols().into_iter().any(|(id, _)| is_marked(id));
        as_printed(&name, span, kind, has_marks)?;
    }
    let Some((kind, shape)) = kind else {
        return Err(match left == right {
            true => undeclared(&name, span, symbols),
            false => Fault::index(
                span,
                format!("{name} is not declared, and its definition has other free indices than {name}"),
            )
            .help("write the same free indices on both sides"),
        });
    };
    let formula = match of_source.shape {
        Shape::Matrix(..) if kind == Kind::Scalar => {
            let mut printed = letters.iter().filter(|letter| !is_label(letter)).map(|letter| Index::Letter(*letter));
            let (Some(row), Some(column)) = (printed.next(), printed.next()) else {
                return Err(undeclared(&name, span, symbols));
            };
            Expr::new(Node::Entry(Box::new(source.clone()), row, column), source.span)
        }
        _ => source.clone(),
    };
    let indices = letters.into_iter().map(Index::Letter).collect();
    let member = Expr::new(Node::Symbol { id, indices, dots: 0 }, span);
    Ok((member, Type { shape, free }, New { name, kind, slots, squared: false, arguments: Vec::new(), formula }))
}

/// Whether a name has no mark of a vector.
fn is_plain(name: &Name) -> bool {
    !name.base.replace("\\bar{", "").replace("\\tilde{", "").replace("\\mathrm{", "").contains('{')
}

/// Rejects a vector with the name of a number, and a number with the name of a vector. Where the notes mark none of the vectors in
/// a formula, they need not mark its name: `\tau = r \times F`.
fn as_printed(name: &Name, span: Span, kind: Kind, has_marks: bool) -> Result<(), Fault> {
    let has = |marks: &[&str]| marks.iter().any(|mark| name.base.contains(mark));
    match kind {
        Kind::Vector if is_plain(name) && has_marks => {
            let message = format!("{name} is printed as a number, but the other side is a vector");
            Err(Fault::shape(span, message).help("put an arrow on the name, or the bars of a norm around the vector"))
        }
        Kind::Scalar if has(&["\\vec{", "\\mathbf{"]) && !name.base.contains("\\hat") => {
            let message = format!("{name} is printed as a vector, but the other side is a number");
            Err(Fault::shape(span, message).help("remove the arrow from the name, or make the other side a vector"))
        }
        _ => Ok(()),
    }
}

/// The whole power that an exponent is.
fn whole_power(item: &Item) -> Option<u32> {
    match &item.layout {
        Layout::Number(digits) => digits.parse().ok().filter(|power| (2..=HIGHEST_POWER).contains(power)),
        Layout::Group(items) => match items.as_slice() {
            [only] => whole_power(only),
            _ => None,
        },
        _ => None,
    }
}
