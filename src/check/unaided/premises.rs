//! Which accepted relations a later statement may follow from.
//!
//! A display that does not follow and is not wrong is taken for granted, and so it is a premise of what comes after it. A
//! statement is checked with a few small sets of premises, the likeliest first. A set is worth a check only if it can
//! eliminate what the statement does not contain: n equalities eliminate at most n − 1 symbols and leave something to say.

use crate::check::unaided::prose::Words;
use crate::check::unaided::signs::Positive;
use crate::formula::SymbolId;
use crate::notes::claims::{Claim, Spanned};
use crate::phrases::listed;
use crate::source::Span;

/// The number of the last displays from which sets are made.
const RECENT: usize = 8;

/// The most sets of premises that are tried.
const TRIED: usize = 10;

/// The most of them with laws in several states.
const IN_STATES: usize = 4;

/// The most sets of several premises with which a slip is sought in what is said to be constant.
const PAIRS: usize = 3;

/// The number of premises in a pair.
const PAIR: usize = 2;

/// The most premises in a set.
const MOST: usize = 3;

/// A relation that is taken for granted.
#[derive(Clone, Debug)]
pub(super) struct Premise {
    /// The place of its display.
    pub at: usize,
    /// The name of its display.
    pub id: String,
    /// What of the display it says.
    pub said: Said,
    /// The symbols that it relates; those that a formula defines are replaced by what the formula contains.
    pub symbols: Vec<SymbolId>,
    /// The number of its equalities.
    pub equalities: usize,
    /// Whether it is a formula in a sentence.
    pub is_inline: bool,
    /// The places of the premises from which it follows, if it does.
    pub from: Vec<usize>,
}

/// What a premise says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Said {
    /// All of its display.
    Whole,
    /// One of several statements of its display: its LaTeX.
    Part(String),
    /// That a formula is constant: its LaTeX.
    Constant(String),
    /// A law in each of several states: its LaTeX in each.
    States(Vec<String>),
}

/// What is before a display that it may follow from.
pub(super) struct Sought<'p> {
    /// The words before it.
    pub words: &'p Words,
    /// The symbols that it relates.
    pub symbols: &'p [SymbolId],
    /// The sets of premises, the likeliest first.
    pub sets: Vec<Vec<&'p Premise>>,
    /// The display directly before it, where the words connect the two.
    pub nearest: Option<Vec<&'p Premise>>,
    /// The names that are positive, where it has a root of their squares.
    pub positive: Option<Positive>,
}

/// The sets of premises that a statement with these symbols may follow from. `named` are the displays that the prose names.
/// In a statement about rates, what each premise says of rates counts too.
pub(super) fn sets<'p>(
    known: &'p [Premise],
    symbols: &[SymbolId],
    has_rates: bool,
    named: &[usize],
) -> Vec<Vec<&'p Premise>> {
    let shares = |premise: &Premise| premise.symbols.iter().any(|symbol| symbols.contains(symbol));
    let mut found: Vec<Vec<&Premise>> = Vec::new();
    let by_name: Vec<&Premise> = known.iter().filter(|premise| named.contains(&premise.at)).collect();
    if !by_name.is_empty() && by_name.len() <= RECENT {
        found.push(by_name.clone());
    }
    let mut displays: Vec<usize> =
        known.iter().filter(|premise| !premise.is_inline).map(|premise| premise.at).collect();
    displays.dedup();
    let last = &displays[displays.len().saturating_sub(RECENT)..];
    let is_recent = |premise: &Premise| {
        last.contains(&premise.at) || named.contains(&premise.at) || matches!(premise.said, Said::States(_))
    };
    let recent: Vec<&Premise> = known.iter().rev().filter(|premise| is_recent(premise)).collect();
    let mut sets: Vec<Vec<usize>> = (0..recent.len()).map(|at| vec![at]).collect();
    // What may drop out of a set without being eliminated, as the magnetic field does from the power.
    let mut less_likely = Vec::new();
    for _ in 0..MOST {
        for set in &sets {
            let chosen: Vec<&Premise> = set.iter().map(|at| recent[*at]).collect();
            if !chosen.iter().any(|premise| shares(premise)) || found.contains(&chosen) || says_twice(&chosen) {
                continue;
            }
            match surplus(&chosen, symbols, has_rates) {
                Some(0) => found.push(chosen),
                Some(1) => less_likely.push(chosen),
                _ => {}
            }
        }
        let longer = |set: &Vec<usize>| {
            let after = set.last().map_or(0, |last| last + 1);
            (after..recent.len()).map(|at| [set.as_slice(), &[at]].concat()).collect::<Vec<_>>()
        };
        sets = sets.iter().flat_map(longer).collect();
    }
    found.extend(less_likely);
    // A display that names states may be about the laws in these.
    let has_states = |set: &Vec<&Premise>| set.iter().any(|premise| matches!(premise.said, Said::States(_)));
    let (mut in_states, others): (Vec<_>, Vec<_>) = found.into_iter().partition(has_states);
    in_states.truncate(IN_STATES);
    found = if named.is_empty() { [in_states, others].concat() } else { [others, in_states].concat() };
    found.truncate(TRIED);
    found
}

/// The last display that is a premise, where it has to do with a statement with these symbols. What is said to follow may follow from it
/// though it has symbols that cannot be eliminated one by one, as in a quotient of two laws.
pub(super) fn nearest<'p>(known: &'p [Premise], symbols: &[SymbolId]) -> Option<Vec<&'p Premise>> {
    let last = known.iter().rev().find(|premise| !premise.is_inline && premise.said == Said::Whole)?;
    last.symbols.iter().any(|symbol| symbols.contains(symbol)).then(|| vec![last])
}

/// The sets with which a slip is sought: the likeliest, and the first of those with the most premises, which say the most. What is
/// said to be constant follows from two relations as a rule.
pub(super) fn for_slips<'s, 'p>(
    sets: &'s [Vec<&'p Premise>],
    symbols: &[SymbolId],
    is_constant: bool,
) -> Vec<&'s Vec<&'p Premise>> {
    if is_constant {
        return sets.iter().take(1).chain(sets.iter().skip(1).filter(|set| set.len() > 1).take(PAIRS)).collect();
    }
    // A law in several states says much already; with two relations more the premises may contradict each other.
    let says_too_much =
        |set: &&Vec<&Premise>| set.len() > PAIR && set.iter().any(|premise| matches!(premise.said, Said::States(_)));
    let sets: Vec<&Vec<&Premise>> = sets.iter().filter(|set| !says_too_much(set)).collect();
    let longest = sets.iter().map(|set| set.len()).max().unwrap_or(0);
    let most = sets.iter().skip(1).find(|set| set.len() == longest);
    // What two relations one after the other say together is what an author combines.
    let adjacent = |set: &&&Vec<&Premise>| {
        let [a, b] = set.as_slice() else { return false };
        a.at.abs_diff(b.at) == 1
    };
    let pair = sets.iter().skip(1).find(adjacent).filter(|pair| most != Some(*pair));
    // One relation that is about the same quantities, though another one stands nearer.
    let shared = |set: &Vec<&Premise>| symbols.iter().filter(|id| set[0].symbols.contains(id)).count();
    let nearest = sets.first().filter(|set| set.len() == 1).map_or(usize::MAX, |set| shared(set));
    let alone = sets.iter().rev().filter(|set| set.len() == 1 && shared(set) > nearest);
    let about = alone.max_by_key(|set| shared(set));
    sets.first().into_iter().chain(about).chain(pair).chain(most).copied().collect()
}

/// The number of symbols that the equalities of premises cannot eliminate to leave a relation between these symbols; `None`, if one of the
/// premises has nothing to do with the others.
fn surplus(premises: &[&Premise], symbols: &[SymbolId], has_rates: bool) -> Option<usize> {
    let mut others: Vec<SymbolId> =
        premises.iter().flat_map(|premise| &premise.symbols).copied().filter(|id| !symbols.contains(id)).collect();
    others.sort_unstable_by_key(|id| id.0);
    others.dedup();
    let connected = premises.iter().enumerate().all(|(at, premise)| {
        premises.len() == 1
            || premises.iter().enumerate().any(|(other, beside)| {
                other != at && premise.symbols.iter().any(|symbol| beside.symbols.contains(symbol))
            })
    });
    let equalities: usize = premises.iter().map(|premise| premise.equalities).sum();
    // The rate of each equality is another one.
    let equalities = if has_rates { 2 * equalities } else { equalities };
    connected.then(|| (others.len() + 1).saturating_sub(equalities))
}

/// Whether a display and a statement of it are both among premises, or one and what follows from it.
fn says_twice(premises: &[&Premise]) -> bool {
    if premises.iter().any(|premise| premises.iter().any(|other| premise.from.contains(&other.at))) {
        return true;
    }
    let is_whole = |at: usize| premises.iter().any(|premise| premise.at == at && premise.said == Said::Whole);
    premises.iter().any(|premise| matches!(premise.said, Said::Part(_)) && is_whole(premise.at))
}

/// The symbols that premises relate.
pub(super) fn symbols<'s>(set: &'s [&Premise]) -> impl Iterator<Item = SymbolId> + 's {
    set.iter().flat_map(|premise| premise.symbols.iter().copied())
}

/// The claim that a display follows from premises.
pub(super) fn claim(premises: &[&Premise]) -> Claim {
    let said = |premise: &&Premise| match &premise.said {
        Said::Whole => vec![premise.id.clone()],
        Said::Part(part) => vec![part.clone()],
        Said::Constant(formula) => vec![is_constant(formula)],
        Said::States(all) => all.clone(),
    };
    let throughout = premises.iter().flat_map(said).map(|text| Spanned::new(text, Span::default())).collect();
    Claim { throughout, ..Claim::default() }
}

/// The equation that a formula is constant.
pub(super) fn is_constant(formula: &str) -> String {
    format!("\\frac{{d}}{{dt}}\\left({formula}\\right) = 0")
}

impl PartialEq for Premise {
    fn eq(&self, other: &Premise) -> bool {
        self.at == other.at && self.said == other.said
    }
}

/// The displays of some premises, in their order, as a message names them.
pub(super) fn named(set: &[&Premise]) -> String {
    let mut set = set.to_vec();
    set.sort_by_key(|premise| premise.at);
    let name = |premise: &&Premise| match premise.said {
        Said::States(_) => format!("({}) in each state", premise.id),
        _ => format!("({})", premise.id),
    };
    let mut ids: Vec<String> = set.iter().map(name).collect();
    ids.dedup();
    listed(&ids, "and")
}
