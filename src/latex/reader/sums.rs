//! Sums over an index: `\sum_{i=1}^{n}`, `\sum_{j \neq i}`, `\sum_{\vec r_i \in V(\vec r)}`.
//!
//! A sum extends to the end of its term. Its index is declared, and its limits are those of the index. It may start
//! later, `i=2`, end earlier, `n-1`, and exclude values by another index, `j \neq i`, `j < i`. If two letters under
//! one Σ belong to no other Σ, `i < j` is a sum over both, and `j \neq i` is a sum over the first.
//!
//! Σ and lim reach to the end of their term, because authors write what is summed as one term. An integral reaches
//! to its differential, which must fit the region: `d^3r` for a volume, `d^2r` for an area, `dr` for a line.

use crate::formula::SymbolId;
use crate::formula::tree::{Excluded, Expr, Index, IndexId, Node};
use crate::source::{Fault, Span};

use super::super::layout::{Item, Layout, contents};
use super::super::names;
use super::items::{extent, whole_number};
use super::state::{Read, Reader};

/// One index under a Σ, with its excluded values and its continuum.
struct Over {
    index: IndexId,
    except: Vec<Excluded>,
    within: Option<crate::formula::SymbolId>,
    /// The place of a pair of letters, `i < j`, that only this Σ shows to be a pair.
    pair: Option<Span>,
}

impl Reader<'_> {
    /// A sum with its body, which is the rest of the term.
    pub(super) fn big_sum(&mut self, sigma: &Item, rest: &[Item]) -> Read<Expr> {
        let span = extent(rest).map_or(sigma.span, |rest| sigma.span.to(rest));
        let Layout::Scripts { sub: Some(sub), sup, .. } = &sigma.layout else {
            return Err(wanted(sigma.span));
        };
        let mut overs = self.below(sub)?;
        if let Some(upper) = sup {
            let less = self.all_but(upper)?;
            for over in &mut overs {
                self.fits(less.map_or(upper, |(upper, _)| upper), over.index)
                    .map_err(|fault| Fault { span: upper.span, ..fault })?;
                over.except.extend(less.map(|(_, less)| Excluded::Last(less)));
            }
        }
        for (at, over) in overs.iter().enumerate() {
            if self.summed.contains(&over.index) || overs[..at].iter().any(|before| before.index == over.index) {
                let letter = &self.symbols.indices[over.index.0].letter;
                return Err(Fault::index(sub.span, format!("the index {letter} is already summed over"))
                    .help("use another index in the inner sum"));
            }
        }
        if extent(rest).is_none() || rest.iter().all(|item| matches!(item.layout, Layout::Space(_))) {
            return Err(Fault::new(sigma.span, "no formula follows this sum").help("write what is summed after the Σ"));
        }
        let outer = self.summed.len();
        self.summed.extend(overs.iter().map(|over| over.index));
        let body = self.term(rest);
        self.summed.truncate(outer);
        let mut body = body?;
        let lone = |over: &&Over| over.pair.is_some() && !body.has_letter(over.index);
        if let Some(Over { index, pair: Some(place), .. }) = overs.iter().find(lone) {
            let letter = &self.symbols.indices[index.0].letter;
            let what = format!("this Σ may be a sum over pairs, or a sum for each value of {letter}");
            return Err(Fault::ambiguous(*place, what)
                .help(format!("write a Σ for each letter, or only one if {letter} is free")));
        }
        for Over { index, except, within, .. } in overs.into_iter().rev() {
            let letter = &self.symbols.indices[index.0].letter;
            let is_about_it = |(id, _): &(SymbolId, u8)| {
                self.symbols.entry(*id).unread && self.symbols.entry(*id).name.mentions(letter)
            };
            if body.symbols().iter().any(is_about_it) {
                return Err(Fault::unsupported(
                    body.span,
                    format!("this quantity has no known value for each {letter}, so it cannot be summed"),
                )
                .help(format!("in its place, declare a symbol with the index {letter}")));
            }
            let node = Node::SumOver { index, implied: false, except, within, body: Box::new(body) };
            body = Expr::new(node, span);
        }
        Ok(body)
    }

    /// The indices under a Σ: `a, b = 1`, `j \neq i`, `j = 1, j \neq i`, `\vec r_i \in V(\vec r)`.
    fn below(&mut self, sub: &Item) -> Read<Vec<Over>> {
        let mut overs: Vec<Over> = Vec::new();
        let items: Vec<Item> =
            contents(sub).iter().filter(|item| !matches!(item.layout, Layout::Space(_))).cloned().collect();
        for clause in items.split(|item| item.layout == Layout::Other(',')) {
            let ([subject, predicate @ ..], Some(place)) = (clause, extent(clause)) else {
                return Err(wanted(sub.span));
            };
            if let [is_in, region @ ..] = predicate
                && matches!(&is_in.layout, Layout::Command(name) if name == "\\in")
            {
                let index = self.particle(subject)?;
                let within = Some(self.region(region, is_in.span).map_err(|fault| {
                    Fault::unsupported(fault.span, "a sum over a set is not supported")
                        .help("declare the index under \"indices\" in the claims file, and write \\sum_i")
                })?);
                overs.push(Over { index, except: Vec::new(), within, pair: None });
                continue;
            }
            let index = self.letter(subject).ok_or_else(|| wanted(subject.span))?;
            match predicate {
                [] => overs.push(Over { index, except: Vec::new(), within: None, pair: None }),
                [equals, one] if equals.layout == Layout::Other('=') => {
                    let low = whole_number(one).and_then(|low| u8::try_from(low).ok());
                    let low = low.filter(|low| (1..=self.symbols.indices[index.0].upper).contains(low));
                    let low = low.ok_or_else(|| {
                        Fault::index(one.span, "a sum must start at a value that its index can have")
                            .help("write \\sum_{i=1}^{n}, for example")
                    })?;
                    let except = (low > 1).then_some(Excluded::UpTo(Index::Fixed(low - 1)));
                    match overs.iter_mut().find(|over| over.index == index && over.within.is_some()) {
                        Some(over) => over.except.extend(except),
                        None => {
                            overs.push(Over { index, except: except.into_iter().collect(), within: None, pair: None })
                        }
                    }
                }
                [relation, other] if bound(relation).is_some() => {
                    let Some((bound, flipped, is_order)) = bound(relation) else { return Err(wanted(place)) };
                    let to = self.left_out(other, index)?;
                    let has = |overs: &[Over], wanted| overs.iter().position(|over| over.index == wanted);
                    let other = match to {
                        Index::Letter(other) => Some(other),
                        Index::Fixed(_) => None,
                    };
                    let of_other = other.and_then(|other| has(&overs, other));
                    match (has(&overs, index), other, of_other) {
                        // Both are summed over here: the inner one is bounded by the outer.
                        (Some(own), Some(_), Some(of_other)) if own < of_other => {
                            overs[of_other].except.push(flipped(Index::Letter(index)));
                        }
                        (Some(own), ..) => overs[own].except.push(bound(to)),
                        // The other letter is the one that is new.
                        (None, Some(other), None) if self.summed.contains(&index) && !self.summed.contains(&other) => {
                            overs.push(Over {
                                index: other,
                                except: vec![flipped(Index::Letter(index))],
                                within: None,
                                pair: None,
                            });
                        }
                        (None, Some(other), None) if is_order && !self.summed.contains(&other) => {
                            if !self.symbols.indices[index.0].labels {
                                return Err(wanted(place));
                            }
                            overs.push(Over { index: other, except: Vec::new(), within: None, pair: Some(place) });
                            overs.push(Over { index, except: vec![bound(to)], within: None, pair: None });
                        }
                        _ => overs.push(Over { index, except: vec![bound(to)], within: None, pair: None }),
                    }
                }
                _ => return Err(wanted(place)),
            }
        }
        if overs.is_empty() { Err(wanted(sub.span)) } else { Ok(overs) }
    }

    /// The upper limit n of `n - 1`, and the number of last values that are excluded.
    fn all_but<'i>(&self, upper: &'i Item) -> Read<Option<(&'i Item, u8)>> {
        match contents(upper) {
            [limit, minus, less] if minus.layout == Layout::Other('-') => match whole_number(less) {
                Some(less @ 1..=9) => Ok(Some((limit, less as u8))),
                _ => Err(Fault::index(
                    upper.span,
                    "the upper limit must be the largest value of the index, or at most 9 less",
                )
                .help("write a limit such as n or n - 1")),
            },
            _ => Ok(None),
        }
    }

    fn letter(&self, item: &Item) -> Option<IndexId> {
        let printed = names::printed(item, None).filter(|printed| printed.dots == 0 && printed.sup.is_none())?;
        self.symbols.index(&printed.name.to_string())
    }

    /// The excluded value of an index: another index with the same range, or a number.
    fn left_out(&self, item: &Item, index: IndexId) -> Read<Index> {
        if let Some(other) = self.letter(item) {
            if other == index {
                return Err(Fault::index(item.span, "this sum compares its index with itself")
                    .help("compare it with another index, or with a whole number in its range"));
            }
            return match self.symbols.same_range(index, other) {
                true => Ok(Index::Letter(other)),
                false => Err(Fault::index(item.span, "these two indices have different ranges")
                    .help("use indices with the same range, or a whole number in place of this index")),
            };
        }
        let value = whole_number(item).and_then(|value| u8::try_from(value).ok());
        match value {
            Some(value) if (1..=self.symbols.indices[index.0].upper).contains(&value) => Ok(Index::Fixed(value)),
            _ => Err(Fault::index(
                item.span,
                "a sum can exclude only the value of another index, or a whole number in the range of its own index",
            )
            .help("write \\sum_{i \\ne j} with two indices, or \\sum_{i \\ne 2} with a number")),
        }
    }

    /// The index of the particle whose position this is: i for `\vec r_i`, or for `i` itself.
    fn particle(&mut self, item: &Item) -> Read<IndexId> {
        let label = |index: &IndexId| self.symbols.indices[index.0].labels;
        if let Some(index) = self.letter(item).filter(label) {
            return Ok(index);
        }
        let found = names::printed(item, self.branch)
            .filter(|printed| printed.dots == 0 && printed.sup.is_none())
            .and_then(|printed| self.symbols.find_or_assemble(&printed.name));
        match found.as_ref().map(|(_, indices)| indices.as_slice()) {
            Some([Index::Letter(index)]) if self.symbols.indices[index.0].labels => Ok(*index),
            _ => Err(Fault::index(
                item.span,
                "a sum over the particles in a body needs the position of a particle with an index",
            )
            .help("write \\sum_{\\vec r_i \\in V(\\vec r)}, with a declared \\vec r_i")),
        }
    }

    /// Checks that an upper limit is the declared one.
    fn fits(&self, upper: &Item, index: IndexId) -> Read<()> {
        let entry = &self.symbols.indices[index.0];
        let declared = match entry.count {
            None if whole_number(upper) == Some(entry.upper.into()) => return Ok(()),
            None => entry.upper.to_string(),
            Some(count) => {
                let name = &self.symbols.entry(count).name;
                if names::printed(upper, None).is_some_and(|p| p.dots == 0 && p.sup.is_none() && p.name == *name) {
                    return Ok(());
                }
                name.to_string()
            }
        };
        let advice = match names::printed(upper, None) {
            Some(found) => format!(
                "write \\sum_{{{0}}} for all of these, or declare {0} as \"1..{1}\" under \"indices\", with {1} as an integer",
                entry.letter, found.name
            ),
            None => format!("write \\sum_{{{}}} for all of these", entry.letter),
        };
        let message = format!(
            "this sum has another upper limit than the index {}, which is declared to run from 1 to {declared}",
            entry.letter
        );
        Err(Fault::index(upper.span, message).help(advice))
    }
}

fn wanted(span: Span) -> Fault {
    Fault::new(span, "a sum needs a declared index under the Σ, as in \\sum_{a=1}^{3}")
        .help("declare the letter under \"indices\" in the claims file")
}

/// The excluded values of an index that is in some relation to another.
type Bound = fn(Index) -> Excluded;

/// The excluded values of the left letter of a relation under a Σ, those of the right letter, and whether it is < or
/// >.
fn bound(item: &Item) -> Option<(Bound, Bound, bool)> {
    let (unequal, below, above): (Bound, Bound, Bound) = (Excluded::Value, Excluded::From, Excluded::UpTo);
    match &item.layout {
        Layout::Other('≠') => Some((unequal, unequal, false)),
        Layout::Other('<') => Some((below, above, true)),
        Layout::Other('>') => Some((above, below, true)),
        Layout::Command(name) => match name.as_str() {
            "\\neq" => Some((unequal, unequal, false)),
            "\\lt" => Some((below, above, true)),
            "\\gt" => Some((above, below, true)),
            _ => None,
        },
        _ => None,
    }
}
