//! Signs between two formulas: ⊗, the double contraction and the like bind as a product, ∈ and → bind less than a sum; commas make a list.

use crate::formula::shape::Shape;
use crate::formula::tree::{Condition, Expr, Node};
use crate::source::{Fault, Span};

use super::super::super::layout::{Item, Layout, contents, typed};
use super::super::super::names;
use super::super::super::rows::relation;
use super::super::items::{Joint, beside, is_any_integral, is_big_product, is_big_sum, is_limit};
use super::super::state::{Read, Reader};
use super::printed;

/// Signs that bind as a product does.
const PRODUCTS: [&str; 8] = ["\\otimes", "\\circ", "\\ast", "\\star", "\\odot", "\\bullet", "\\rtimes", "\\bmod"];

/// Signs that bind as a sum does.
const SUMS: [&str; 5] = ["\\oplus", "\\cup", "\\cap", "\\setminus", "\\ominus"];

/// Signs that bind less than a sum, and state something of both sides.
const RELATIONS: [&str; 33] = [
    "\\in",
    "\\notin",
    "\\ni",
    "\\subset",
    "\\subseteq",
    "\\supset",
    "\\sim",
    "\\cong",
    "\\ll",
    "\\gg",
    "\\rightarrow",
    "\\leftarrow",
    "\\leftrightarrow",
    "\\mapsto",
    "\\longrightarrow",
    "\\longleftarrow",
    "\\longmapsto",
    "\\longleftrightarrow",
    "\\perp",
    "\\parallel",
    "\\lesssim",
    "\\gtrsim",
    "\\mid",
    "\\Leftarrow",
    "\\asymp",
    "\\doteq",
    "\\leadsto",
    "\\rightsquigarrow",
    "\\colon",
    "\\prec",
    "\\preceq",
    "\\succ",
    "\\succeq",
];

/// Signs of a map, before which a colon binds less than they do: `f : A \to B`.
const MAPS: [&str; 5] = ["\\rightarrow", "\\mapsto", "\\longrightarrow", "\\longmapsto", "\\in"];

/// The fault of a comma between digits: it may divide thousands, be that of decimals, or that of a list.
fn comma_of_digits(before: &Item, after: &Item) -> Fault {
    let [a, b] = [before, after].map(|item| typed(std::slice::from_ref(item)));
    let message = format!("{a},{b} may be one number or two values");
    let digits = b.chars().take_while(char::is_ascii_digit).count();
    let number = match digits {
        // Thousands with a point: `1.000,5`.
        _ if a.contains('.') => format!("{}.{b} for the number", a.replace('.', "")),
        3 => format!("{a}{b} for the number with thousands, {a}.{b} for the decimals"),
        _ => format!("{a}.{b} for the number"),
    };
    Fault::ambiguous(before.span.to(after.span), message).help(format!("write {number}, and {a}, {b} for a list"))
}

impl Reader<'_> {
    /// Items with a sign between formulas, or a comma; `None` if there is none.
    pub(in super::super) fn infix(&mut self, items: &[Item], place: Span) -> Read<Option<Expr>> {
        let is_comma = |item: &Item| matches!(item.layout, Layout::Other(',' | ';'));
        // The bar of `P(A|B)` too; one with a place below it belongs to what stands before.
        let has_map = items.iter().any(|item| sign(item, &MAPS));
        let is_relation = |item: &Item| {
            states(item)
                || item.layout == Layout::Other('|')
                || item.layout == Layout::Other(':') && (has_map || !is_between_factors(items))
        };
        let is_sum = |item: &Item| sign(item, &SUMS);
        if let Some(at) = (1..items.len().max(1) - 1).find(|at| is_comma(&items[*at]) && joins_digits(items, *at)) {
            return Err(comma_of_digits(&items[at - 1], &items[at + 1]));
        }
        if let Some([first, .., last]) = items.windows(3).find(|three| is_comma_of_digits(three)) {
            return Err(Fault::ambiguous(
                first.span.to(last.span),
                "the comma in a number may be the decimal point, or divide thousands",
            )
            .help("write 2.897 for the decimals, and 2897 for the thousands"));
        }
        // `\alpha, \beta \in S`, `X_1, \dots, X_n \sim N`: the sign is about all names of the list.
        let mut signs = items.iter().enumerate().filter(|(_, item)| states(item));
        let is_listed = |item: &Item| {
            let is_mark = sign(item, &["\\Delta", "\\delta", "\\dots"]);
            is_mark || matches!(item.layout, Layout::Space(_)) || names::printed(item, None).is_some()
        };
        if let (Some((at, _)), None) = (signs.next(), signs.next())
            && items[..at].iter().any(is_comma)
            && items[..at].iter().all(|item| is_comma(item) || is_listed(item))
            && !items[at..].iter().any(is_comma)
        {
            return self.divided(items, &states, place).map(Some);
        }
        if items.iter().any(is_comma) {
            return self.divided(items, &is_comma, place).map(Some);
        }
        if items.iter().any(is_relation) {
            return self.divided(items, &is_relation, place).map(Some);
        }
        if items.iter().any(is_sum) {
            return self.divided(items, &is_sum, place).map(Some);
        }
        Ok(None)
    }

    /// An event, of which a probability is a function: `X \leq x \mid Y = y`.
    pub(in super::super) fn event(&mut self, items: &[Item], place: Span) -> Read<Expr> {
        let divides = |item: &Item| relation(item).is_some() || states(item) || item.layout == Layout::Other('|');
        match items.iter().any(|item| relation(item).is_some()) {
            true => self.divided(items, &divides, place),
            false => self.sum(items, place),
        }
    }

    /// The same within a term; `None` if all its signs are · and ×.
    pub(in super::super) fn infix_product(&mut self, items: &[Item], place: Span) -> Read<Option<Expr>> {
        // Between vectors ∧ is their product; between differentials and other letters it is that of forms.
        let has_vectors = items.iter().any(is_vectorial_item);
        // Σ and its kin reach to the end of the term: the signs behind it are a part of what is summed.
        let before = items.split(reaches_on).next().unwrap_or(items).as_ptr_range().end;
        let is_own = |item: &Item| {
            std::ptr::from_ref(item) < before
                && (sign(item, &PRODUCTS)
                    || item.layout == Layout::Other(':') && is_between_factors(items)
                    || !has_vectors && sign(item, &["\\wedge"]))
        };
        let ends = |at: usize| at == 0 || at + 1 == items.len();
        match items.iter().enumerate().any(|(at, item)| is_own(item) && !ends(at)) {
            true => self.divided(items, &is_own, place).map(Some),
            false => Ok(None),
        }
    }

    /// A member that is not printed: the left side of a display that begins with a relation.
    pub(in super::super::super) fn not_printed(&mut self, place: Span) -> Expr {
        self.template("\\dots", Vec::new(), place)
    }

    /// A condition that compares nothing, as it is printed.
    pub(in super::super::super) fn unread_condition(&mut self, items: &[Item], place: Span) -> Condition {
        let end = items.iter().rposition(|item| !matches!(item.layout, Layout::Space(_) | Layout::Other(',' | '.')));
        let items = &items[..end.map_or(0, |end| end + 1)];
        // Spaces are left out of a text.
        let label = match items {
            [Item { layout: Layout::Text(word), .. }, rest @ ..] if !rest.is_empty() => {
                let words = match word.as_str() {
                    "forall" => "for all",
                    "forevery" => "for every",
                    "foreach" => "for each",
                    word => word,
                };
                let text = format!("{words}\\,{}", printed(rest));
                self.template(&text, Vec::new(), place)
            }
            _ => {
                // Words are apart from what they follow.
                let is_text = |item: &Item| matches!(item.layout, Layout::Text(_));
                let parts = items.chunk_by(|_, next| !is_text(next)).map(printed);
                let text = parts.collect::<Vec<_>>().join("\\,");
                self.template(&text, Vec::new(), place)
            }
        };
        Condition { members: vec![label], relations: Vec::new() }
    }

    /// What stands over a brace: a formula, or formulas with relations between them.
    pub(in super::super) fn equated(&mut self, item: &Item) -> Read<Expr> {
        let items = contents(item);
        match items.iter().any(|item| relation(item).is_some()) {
            true => self.divided(items, &|item| relation(item).is_some(), item.span),
            false => self.item(item),
        }
    }

    /// Statements or values of which one holds, `x = 1 \text{ or } x = 2`, with the signs and words between them.
    pub(in super::super::super) fn alternatives(&mut self, items: &[Item], place: Span) -> Read<Expr> {
        let divides = |item: &Item| {
            relation(item).is_some()
                || item.layout == Layout::Other(',')
                || matches!(&item.layout, Layout::Text(word) if is_prose(word))
                || sign(item, &["\\lor", "\\vee"])
        };
        let is_blank = |item: &Item| match &item.layout {
            Layout::Text(word) => word == "either",
            layout => matches!(layout, Layout::Space(_)),
        };
        let start = items.iter().position(|item| !is_blank(item)).unwrap_or(0);
        self.divided(&items[start..], &divides, place)
    }

    fn divided(&mut self, items: &[Item], divides: &dyn Fn(&Item) -> bool, place: Span) -> Read<Expr> {
        let mut template = String::from("#");
        let mut parts = Vec::new();
        for item in items.iter().filter(|item| divides(item)) {
            template.push_str(&match &item.layout {
                Layout::Other(c @ (',' | ';')) => format!("{c} #"),
                Layout::Other(c) => format!(" {c} #"),
                Layout::Command(name) => format!(" {name} #"),
                Layout::Text(word) => format!("\\text{{ {word} }}#"),
                // `\rightarrow^{a = 1}`
                _ => format!(" {} #", printed(std::slice::from_ref(item))),
            });
        }
        let mut is_set = false;
        for part in items.split(divides) {
            let before =
                part.first().and_then(|first| items.iter().rev().find(|item| item.span.end <= first.span.start));
            // `F : Q \to SE(3)`
            let is_map = items.iter().any(|item| item.layout == Layout::Other(':'));
            is_set |= before.is_some_and(|sign| {
                self::sign(sign, &["\\in", "\\notin", "\\subset", "\\subseteq"])
                    || is_map && self::sign(sign, &["\\rightarrow"])
            });
            let is_blank = part.iter().all(|item| matches!(item.layout, Layout::Space(_)));
            parts.push(match is_blank {
                true => self.template("", Vec::new(), place),
                // A set has a name of its own, `SE(3)`, `C^\infty(M)`.
                false if is_set && (is_group(part) || is_number_set(part)) => self.label(part, place),
                false => match self.sum(part, place) {
                    Err(_) if is_set && part.iter().all(is_part_of_a_set) => self.label(part, place),
                    found => found?,
                },
            });
        }
        Ok(self.template(&template, parts, place))
    }

    /// Parts with × and · between them, of which not all are vectors: each sign is shown where it stands. × binds more.
    pub(in super::super) fn joined(&mut self, parts: Vec<(Joint, Expr, bool)>, whole: Span) -> Read<Expr> {
        let mut groups: Vec<Vec<(Joint, Expr, bool)>> = Vec::new();
        for (joint, expr, is_vector) in parts {
            match groups.last_mut() {
                Some(group) if joint == Joint::Times => group.push((joint, expr, is_vector)),
                _ => groups.push(vec![(joint, expr, is_vector)]),
            }
        }
        let mut found: Option<(Expr, bool)> = None;
        for group in groups {
            let mut product: Option<(Expr, bool)> = None;
            for (joint, next, is_vector) in group {
                product = Some(match product {
                    None => (next, is_vector),
                    Some(before) => self.pair(joint, before, (next, is_vector)),
                });
            }
            let Some(product) = product else { continue };
            found = Some(match found {
                None => product,
                Some(before) => self.pair(Joint::CDot, before, product),
            });
        }
        let (mut expr, _) = found.ok_or_else(|| {
            Fault::new(whole, "a factor is missing here").help("write the factor, or remove the sign of the product")
        })?;
        expr.span = whole;
        Ok(expr)
    }

    fn pair(&mut self, joint: Joint, (left, a): (Expr, bool), (right, b): (Expr, bool)) -> (Expr, bool) {
        let span = left.span.to(right.span);
        let has_letters = |expr: &Expr| !matches!(expr.node, Node::Number(_) | Node::Quotient(..) | Node::Power(..));
        let is_plain = !a && !b && (joint == Joint::CDot || !has_letters(&left) || !has_letters(&right));
        let has_abstract =
            [&left, &right].into_iter().any(|side| self.shape_of(side).is_ok_and(|s| s == Shape::Abstract));
        match (a && b, joint) {
            (true, Joint::Times) => (Expr::new(Node::Cross(Box::new(left), Box::new(right)), span), true),
            (true, _) => (Expr::new(Node::Dot(Box::new(left), Box::new(right)), span), false),
            _ if is_plain && !has_abstract => (beside(vec![left, right]), false),
            (_, Joint::Times) => (self.template("# \\times #", vec![left, right], span), a || b),
            _ if has_abstract => (self.template("# \\cdot #", vec![left, right], span), false),
            _ => (beside(vec![left, right]), a || b),
        }
    }
}

/// Whether an item is a sign that states something of both sides, and is no relation between numbers.
pub(in super::super::super) fn states(item: &Item) -> bool {
    sign(item, &RELATIONS) || is_arrow_with_a_condition(item)
}

/// Whether an item is an arrow with a script: `\rightarrow^{a = 1}`.
fn is_arrow_with_a_condition(item: &Item) -> bool {
    let Layout::Scripts { nucleus, primes: 0, .. } = &item.layout else { return false };
    sign(nucleus, &["\\rightarrow", "\\longrightarrow"])
}

/// Whether an item acts on the rest of its term: a sum, an integral, a limit.
fn reaches_on(item: &Item) -> bool {
    is_any_integral(item) || is_big_sum(item) || is_big_product(item) || is_limit(item)
}

/// Whether each colon stands between two factors, as in the double contraction `\sigma : \epsilon`.
fn is_between_factors(items: &[Item]) -> bool {
    let is_factor = |item: Option<&Item>| {
        item.is_some_and(|item| {
            names::printed(item, None).is_some()
                || matches!(&item.layout, Layout::Fence(..) | Layout::Accent(..) | Layout::Fraction(..))
                || sign(item, &["\\nabla"])
                || matches!(&item.layout, Layout::Scripts { nucleus, .. } if matches!(nucleus.layout, Layout::Fence(..)))
        })
    };
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let is_colon = |at: &usize| solid[*at].layout == Layout::Other(':');
    (0..solid.len())
        .filter(is_colon)
        .all(|at| is_factor(at.checked_sub(1).map(|before| solid[before])) && is_factor(solid.get(at + 1).copied()))
}

/// Whether a comma stands directly between digits, and may be a part of a number: not in `0,1,2`, which has another one.
fn joins_digits(items: &[Item], at: usize) -> bool {
    let digits = |at: usize| match items.get(at).map(|item| &item.layout) {
        Some(Layout::Number(digits)) => Some(digits.len()),
        _ => None,
    };
    let is_comma = |at: usize| items.get(at).is_some_and(|item| item.layout == Layout::Other(','));
    let touches = items[at - 1].span.end == items[at].span.start && items[at].span.end == items[at + 1].span.start;
    let is_part = |before: usize, after: usize| match (digits(before), digits(after)) {
        (Some(_), Some(3)) => true,
        (Some(_), Some(_)) => !(is_comma(after + 1) || before > 0 && is_comma(before - 1)),
        _ => false,
    };
    touches && is_part(at - 1, at + 1)
}

/// `2{,}897`
fn is_comma_of_digits(items: &[Item]) -> bool {
    let is_number = |item: &Item| matches!(item.layout, Layout::Number(_));
    is_number(&items[0])
        && is_number(&items[2])
        && matches!(contents(&items[1]), [Item { layout: Layout::Other(','), .. }])
        && matches!(items[1].layout, Layout::Group(_))
}

/// Capitals before a parenthesis: `SO(3)`, `SE(2)`.
fn is_group(part: &[Item]) -> bool {
    let solid: Vec<&Item> = part.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    match solid.as_slice() {
        [letters @ .., Item { layout: Layout::Fence(..), .. }] => {
            letters.len() > 1
                && letters.iter().all(|item| matches!(item.layout, Layout::Letter(c) if c.is_ascii_uppercase()))
        }
        _ => false,
    }
}

/// `\mathbb{R}^{6\times n}`: what stands above a set of numbers is no power.
fn is_number_set(part: &[Item]) -> bool {
    let is_set = |item: &Item| matches!(&item.layout, Layout::Style(style, _) if style == "\\mathbb");
    let mut solid = part.iter().filter(|item| !matches!(item.layout, Layout::Space(_) | Layout::Other('.')));
    let only = solid.next().filter(|_| solid.next().is_none());
    only.is_some_and(|only| matches!(&only.layout, Layout::Scripts { nucleus, .. } if is_set(nucleus)) || is_set(only))
}

/// Letters, numbers and parentheses: the name of a set.
fn is_part_of_a_set(item: &Item) -> bool {
    match &item.layout {
        Layout::Letter(_) | Layout::Number(_) | Layout::Style(..) | Layout::Space(_) | Layout::Fence(..) => true,
        Layout::Scripts { nucleus, .. } => is_part_of_a_set(nucleus),
        Layout::Command(name) => name == "\\times",
        _ => false,
    }
}

/// A letter with an arrow, in bold or with a hat.
fn is_vectorial_item(item: &Item) -> bool {
    match &item.layout {
        Layout::Fence(_, inside) => inside.iter().any(is_vectorial_item),
        _ => names::printed(item, None)
            .is_some_and(|found| ["\\vec{", "\\mathbf{", "\\hat{"].iter().any(|mark| found.name.base.contains(mark))),
    }
}

fn sign(item: &Item, signs: &[&str]) -> bool {
    matches!(&item.layout, Layout::Command(name) if signs.contains(&name.as_str()))
}

/// Whether a word is one of ordinary language, and neither a name nor a unit.
pub(in super::super::super) fn is_prose(word: &str) -> bool {
    const WORDS: [&str; 46] = [
        "and",
        "or",
        "oder",
        "ou",
        "if",
        "for",
        "when",
        "where",
        "with",
        "then",
        "so",
        "hence",
        "thus",
        "as",
        "is",
        "are",
        "in",
        "on",
        "at",
        "of",
        "the",
        "to",
        "by",
        "since",
        "because",
        "but",
        "otherwise",
        "else",
        "all",
        "any",
        "some",
        "not",
        "given",
        "let",
        "we",
        "have",
        "from",
        "that",
        "this",
        "which",
        "while",
        "also",
        "be",
        "an",
        "it",
        "therefore",
    ];
    WORDS.contains(&word.trim_matches(|c: char| !c.is_alphabetic()).to_ascii_lowercase().as_str())
}
