//! Sums over an index: `\sum_{i=1}^{n}`, `\sum_{j \neq i}`, `\sum_{\vec r_i \in V(\vec r)}`.
//!
//! A sum reaches to the end of the term that it stands in. Its index is declared, and its limits are those of the
//! index: a sum over some of the values only is refused, but for one that is left out.

use crate::formula::tree::{Expr, Index, IndexId, Node};
use crate::source::{Fault, Span};

use super::super::layout::{Item, Layout};
use super::super::names;
use super::items::{contents, extent, whole_number};
use super::{Read, Reader};

/// One index below a Σ, and what it leaves out or stays within.
struct Over {
    index: IndexId,
    except: Option<Index>,
    within: Option<crate::formula::SymbolId>,
}

impl Reader<'_> {
    /// A sum with its body, which is the rest of the term.
    pub(super) fn big_sum(&mut self, sigma: &Item, rest: &[Item]) -> Read<Expr> {
        let span = extent(rest).map_or(sigma.span, |rest| sigma.span.to(rest));
        let Layout::Scripts { sub: Some(sub), sup, .. } = &sigma.layout else {
            return Err(wanted(sigma.span));
        };
        let overs = self.below(sub)?;
        if let Some(upper) = sup {
            for over in &overs {
                self.fits(upper, over.index)?;
            }
        }
        for (at, over) in overs.iter().enumerate() {
            if self.summed.contains(&over.index) || overs[..at].iter().any(|before| before.index == over.index) {
                return Err(Fault::new(sub.span, "this index is summed over already"));
            }
        }
        if extent(rest).is_none() || rest.iter().all(|item| matches!(item.layout, Layout::Space(_))) {
            return Err(Fault::new(sigma.span, "nothing follows this sum"));
        }
        let outer = self.summed.len();
        self.summed.extend(overs.iter().map(|over| over.index));
        let body = self.term(rest);
        self.summed.truncate(outer);
        let mut body = body?;
        for Over { index, except, within } in overs.into_iter().rev() {
            let node = Node::SumOver { index, implied: false, except, within, body: Box::new(body) };
            body = Expr::new(node, span);
        }
        Ok(body)
    }

    /// What stands below a Σ: `a, b = 1`, `j \neq i`, `j = 1, j \neq i`, `\vec r_i \in V(\vec r)`.
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
                let within = Some(self.region(region, is_in.span)?);
                overs.push(Over { index, except: None, within });
                continue;
            }
            let index = self.letter(subject).ok_or_else(|| wanted(subject.span))?;
            match predicate {
                [] => overs.push(Over { index, except: None, within: None }),
                [equals, one] if equals.layout == Layout::Other('=') => {
                    if whole_number(one) != Some(1) {
                        return Err(Fault::new(one.span, "a sum is read from 1 up").help("write \\sum_{i=1}^{n}"));
                    }
                    overs.push(Over { index, except: None, within: None });
                }
                [unequal, other] if is_unequal(unequal) => {
                    let except = Some(self.left_out(other, index)?);
                    match overs.iter_mut().find(|over| over.index == index && over.except.is_none()) {
                        Some(over) => over.except = except,
                        None => overs.push(Over { index, except, within: None }),
                    }
                }
                _ => return Err(wanted(place)),
            }
        }
        if overs.is_empty() { Err(wanted(sub.span)) } else { Ok(overs) }
    }

    fn letter(&self, item: &Item) -> Option<IndexId> {
        let printed = names::printed(item, None).filter(|printed| printed.dots == 0 && printed.sup.is_none())?;
        self.symbols.index(&printed.name.to_string())
    }

    /// The value that an index leaves out: another index with the same values, or one of them.
    fn left_out(&self, item: &Item, index: IndexId) -> Read<Index> {
        if let Some(other) = self.letter(item) {
            return match other != index && self.symbols.same_range(index, other) {
                true => Ok(Index::Letter(other)),
                false => Err(Fault::new(item.span, "these two indices do not run over the same things")),
            };
        }
        let value = whole_number(item).and_then(|value| u8::try_from(value).ok());
        match value {
            Some(value) if (1..=self.symbols.indices[index.0].upper).contains(&value) => Ok(Index::Fixed(value)),
            _ => Err(Fault::new(item.span, "what a sum leaves out is an index or one of its values")),
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
            _ => Err(Fault::new(item.span, "this does not name a particle by its index")
                .help("write \\sum_{\\vec r_i \\in V(\\vec r)}, with a declared \\vec r_i")),
        }
    }

    /// Whether an upper limit is the declared one.
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
        Err(Fault::new(upper.span, format!("the index {} is declared to run to {declared}", entry.letter)))
    }
}

fn wanted(span: Span) -> Fault {
    Fault::new(span, "a sum wants a declared index below, \\sum_{a=1}^{3}")
}

fn is_unequal(item: &Item) -> bool {
    match &item.layout {
        Layout::Other('≠') => true,
        Layout::Command(name) => name == "\\neq",
        _ => false,
    }
}

/// `\sum`, with or without limits.
pub(super) fn is_big_sum(item: &Item) -> bool {
    match &item.layout {
        Layout::Command(name) => name == "\\sum",
        Layout::Scripts { nucleus, .. } => matches!(&nucleus.layout, Layout::Command(name) if name == "\\sum"),
        _ => false,
    }
}
