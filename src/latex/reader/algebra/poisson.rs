//! Poisson brackets: `\{f, g\}`, `[f, g]_{q,p}`, `\{f, g\}_{\mathrm{PB}}`.
//!
//! The bracket is formed at once, as a partial derivative is: the sum over all pairs of ∂f/∂q ∂g/∂p − ∂f/∂p ∂g/∂q. The
//! pairs are those below the bracket, or the coordinates of the document with their momenta, or, where there are none,
//! the declared names p and q. A momentum may have two names, p and p_x; a derivative is then the sum over both.

use crate::formula::derivative::{self, NoDerivative, Scope};
use crate::formula::shape::Shape;
use crate::formula::symbols::{Kind, Name, Symbols};
use crate::formula::tree::{Expr, Node, Sign, Term, Variable};
use crate::formula::{SymbolId, text};
use crate::source::{Fault, Span};

use super::super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::super::names;
use super::super::state::{Read, Reader};

/// A coordinate, and the names of its momentum.
pub type Pair = (SymbolId, Vec<SymbolId>);

impl Reader<'_> {
    /// A Poisson bracket, if one stands here.
    pub(super) fn poisson(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let item = &items[*cursor];
        let (fence, below) = match &item.layout {
            Layout::Scripts { nucleus, sub: Some(sub), sup: None, primes: 0 } => (&**nucleus, Some(&**sub)),
            _ => (item, None),
        };
        let Layout::Fence(delimiter @ (Delimiter::Square | Delimiter::Curly), inside) = &fence.layout else {
            return Ok(None);
        };
        let parts: Vec<&[Item]> = inside.split(is_comma).collect();
        let [first, second] = parts.as_slice() else { return Ok(None) };
        // Without declarations nothing says what depends on what, and [a, b] alone is a commutator or an interval.
        if self.symbols.open || self.is_abstract() || *delimiter == Delimiter::Square && below.is_none() {
            return Ok(None);
        }
        let pairs = match below.filter(|below| !is_label(below)) {
            Some(below) => self.pairs_below(below)?,
            None => self.canonical_pairs(item.span)?,
        };
        let (f, g) = (self.sum(first, item.span)?, self.sum(second, item.span)?);
        for side in [&f, &g] {
            if self.shape_of(side)? != Shape::Scalar {
                return Err(Fault::unsupported(
                    side.span,
                    "a Poisson bracket of a vector or a matrix is not supported",
                )
                .help("write the bracket for each component"));
            }
        }
        *cursor += 1;
        self.formed(&f, &g, &pairs, item.span).map(Some)
    }

    fn formed(&self, f: &Expr, g: &Expr, pairs: &[Pair], span: Span) -> Read<Expr> {
        let fixed: Vec<SymbolId> = pairs.iter().flat_map(|(q, momenta)| momenta.iter().chain([q])).copied().collect();
        let scope = Scope { symbols: self.symbols, fixed: &fixed };
        let refused = |reason: NoDerivative| self.refused(&reason, span);
        for side in [f, g] {
            let all = derivative::variables(side, scope).map_err(refused)?;
            if let Some(rate) = all.iter().find(|variable| variable.dots > 0) {
                let name = text::plain(&self.symbols.entry(rate.id).name.to_string());
                return Err(Fault::unsupported(
                    side.span,
                    format!("a Poisson bracket contains the time derivative of {name}, which is not supported"),
                )
                .help("write the functions in the bracket in terms of coordinates and momenta"));
            }
        }
        let by = |side: &Expr, names: &[SymbolId]| -> Read<Vec<Expr>> {
            let partial = |id: &SymbolId| {
                let by = Variable { id: *id, indices: Vec::new(), dots: 0 };
                derivative::partial(side, &by, scope, span).map_err(refused)
            };
            let all: Read<Vec<Expr>> = names.iter().map(partial).collect();
            Ok(all?.into_iter().filter(|term| !term.is_zero()).collect())
        };
        let mut terms = Vec::new();
        for (q, momenta) in pairs {
            let q = std::slice::from_ref(q);
            for (sign, of_f, of_g) in [(Sign::Plus, q, &momenta[..]), (Sign::Minus, &momenta[..], q)] {
                let (of_f, of_g) = (by(f, of_f)?, by(g, of_g)?);
                for (a, b) in of_f.iter().flat_map(|a| of_g.iter().map(move |b| (a, b))) {
                    let expr = Expr::new(Node::Product(vec![a.clone(), b.clone()]), span);
                    terms.push(Term { sign, sign_span: None, expr });
                }
            }
        }
        if terms.is_empty() {
            terms.push(Term { sign: Sign::Plus, sign_span: None, expr: Expr::integer(0, span) });
        }
        // As a sum of one term it differs from its own text, because to form the bracket is a step.
        Ok(Expr::new(Node::Sum(terms), span))
    }

    /// The pairs that are written below a bracket: `q,p`, `(q, p)`, `q_1, q_2, p_1, p_2`, `q_1, p_1, q_2, p_2`.
    fn pairs_below(&mut self, below: &Item) -> Read<Vec<Pair>> {
        let inside = match contents(below) {
            [Item { layout: Layout::Fence(Delimiter::Round, inside), .. }] => inside,
            other => other,
        };
        let mut found = Vec::new();
        for part in inside.split(is_comma) {
            let mut marks = part.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
            let name = marks.next().filter(|_| marks.next().is_none()).and_then(|item| names::printed(item, None));
            let name = name.filter(|name| name.dots == 0 && name.sup.is_none());
            let name = name.ok_or_else(|| {
                Fault::unsupported(
                    below.span,
                    "below a Poisson bracket, only the names of coordinates and momenta are supported",
                )
                .help("write their names alone, as in \\{f, g\\}_{q,p}")
            })?;
            let Some((id, _)) = self.symbols.find(&name.name) else {
                return Err(Fault::undeclared(below.span, &name.name));
            };
            found.push(id);
        }
        let half = found.len() / 2;
        if found.len() % 2 == 1 {
            return Err(Fault::new(below.span, "each coordinate below a Poisson bracket needs its momentum")
                .help("write each coordinate with its momentum, as in \\{f, g\\}_{q,p}"));
        }
        let is_alternating = found.chunks(2).all(|pair| self.symbols.entry(pair[1]).is_momentum());
        Ok(match is_alternating {
            true => found.chunks(2).map(|pair| (pair[0], vec![pair[1]])).collect(),
            false => (0..half).map(|at| (found[at], vec![found[half + at]])).collect(),
        })
    }

    /// The coordinates with their momenta; where a document has no coordinates, the names that look like pairs.
    fn canonical_pairs(&self, span: Span) -> Read<Vec<Pair>> {
        let coordinates = &self.symbols.canonical;
        if coordinates.is_empty() {
            let pairs = pairs_by_name(self.symbols);
            return match pairs.is_empty() {
                false => Ok(pairs),
                true => Err(Fault::unsupported(span, "the coordinates and momenta of this bracket are not known")
                    .help(
                        "write them below the bracket, as in \\{f, g\\}_{q,p}, or \
                         declare \"coordinates\" and a Lagrangian or a Hamiltonian",
                    )),
            };
        }
        let named = |name: Name| {
            let (id, _) = self.symbols.find(&name)?;
            (self.symbols.entry(id).kind == Kind::Scalar).then_some(id)
        };
        let mut pairs = Vec::new();
        for (q, known) in coordinates {
            let mut momenta = known.clone();
            let subscript = &self.symbols.entry(*q).name.subscript;
            if !subscript.is_empty() || coordinates.len() == 1 {
                momenta.extend(named(Name { subscript: subscript.clone(), ..Name::plain("p") }));
            }
            momenta.dedup();
            if momenta.is_empty() {
                let name = text::plain(&self.symbols.entry(*q).name.to_string());
                return Err(Fault::unsupported(span, format!("the name of the momentum of {name} is not known"))
                    .help("say under \"means\" which name is the momentum, as in \"p\": \"momentum of q\""));
            }
            pairs.push((*q, momenta));
        }
        Ok(pairs)
    }
}

/// The declared names p, p_1, p_x that vary freely, each with the declared name that it belongs to.
pub fn pairs_by_name(symbols: &Symbols) -> Vec<Pair> {
    let is_free = |id: SymbolId| {
        let entry = symbols.entry(id);
        entry.kind == Kind::Scalar && entry.varies && entry.definition.is_none() && !entry.derived
    };
    let momentum = |id: SymbolId| matches!(symbols.entry(id).name.base.as_str(), "p" | "P") && is_free(id);
    let partner = |id: SymbolId| {
        let name = &symbols.entry(id).name;
        let alike = |base: &str| Name { base: base.to_owned(), ..name.clone() };
        let coordinate = names::parse(&name.subscript.concat()).map(|(name, _)| name);
        let candidates = [Some(alike(if name.base == "p" { "q" } else { "Q" })), coordinate, Some(alike("x"))];
        let found = candidates.into_iter().flatten().find_map(|name| symbols.find(&name));
        found.map(|(id, _)| id).filter(|id| is_free(*id))
    };
    let momenta = symbols.iter().map(|(id, _)| id).filter(|id| momentum(*id));
    momenta.filter_map(|id| Some((partner(id)?, vec![id]))).collect()
}

fn is_comma(item: &Item) -> bool {
    item.layout == Layout::Other(',')
}

/// Whether what stands below a bracket is a label: `PB`, `P`.
fn is_label(below: &Item) -> bool {
    match contents(below) {
        [Item { layout: Layout::Text(text), .. }] => text.starts_with('P'),
        [Item { layout: Layout::Letter('P'), .. }] => true,
        [Item { layout: Layout::Letter('P'), .. }, Item { layout: Layout::Letter('B'), .. }] => true,
        [Item { layout: Layout::Style(_, inner), .. }] => is_label(inner),
        _ => false,
    }
}
