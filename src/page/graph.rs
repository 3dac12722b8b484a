//! The graph of a document as SVG: which equation depends on which. Each node leads to its equation.

use std::collections::BTreeMap;

use maud::{Markup, html};

use super::{equation_anchor, tone};
use crate::check::Document;

const NODE: (usize, usize) = (74, 30);
const GAP: (usize, usize) = (16, 46);
/// A row of the picture has at most so many nodes; more of one layer stand in further rows.
const ACROSS: usize = 8;

/// The graph, if an equation of the document rests on another one.
pub(super) fn graph(document: &Document, prefix: &str) -> Option<Markup> {
    let equations = &document.equations;
    let place: BTreeMap<&str, usize> = equations.iter().enumerate().map(|(at, item)| (item.id.as_str(), at)).collect();
    let mut edges: Vec<(usize, usize)> = Vec::new();
    for (to, item) in equations.iter().enumerate() {
        edges.extend(item.rests_on.iter().filter_map(|id| place.get(id.as_str())).map(|from| (*from, to)));
    }
    if edges.is_empty() {
        return None;
    }
    let linked = |at: &usize| edges.iter().any(|(from, to)| from == at || to == at);
    let shown: Vec<usize> = (0..equations.len()).filter(linked).collect();
    let mut layer = vec![0_usize; equations.len()];
    for at in &shown {
        let before = edges.iter().filter(|(from, to)| to == at && from < to).map(|(from, _)| layer[*from] + 1);
        layer[*at] = before.max().unwrap_or(0);
    }
    let mut rows: Vec<Vec<usize>> = Vec::new();
    for depth in 0..=layer.iter().copied().max().unwrap_or(0) {
        let of_layer: Vec<usize> = shown.iter().copied().filter(|at| layer[*at] == depth).collect();
        rows.extend(of_layer.chunks(ACROSS).map(<[usize]>::to_vec));
    }
    let across = rows.iter().map(Vec::len).max().unwrap_or(1);
    let width = across * (NODE.0 + GAP.0) + GAP.0;
    let height = rows.len() * (NODE.1 + GAP.1) - GAP.1 + 8;
    let mut at_place: BTreeMap<usize, (usize, usize)> = BTreeMap::new();
    for (down, row) in rows.iter().enumerate() {
        let own = row.len() * (NODE.0 + GAP.0) - GAP.0;
        for (right, at) in row.iter().enumerate() {
            at_place.insert(*at, ((width - own) / 2 + right * (NODE.0 + GAP.0), 4 + down * (NODE.1 + GAP.1)));
        }
    }
    let label = format!("Which equation depends on which: {} equations, {} links", shown.len(), edges.len());
    let path = |(from, to): &(usize, usize)| {
        let (a, b) = (at_place.get(from)?, at_place.get(to)?);
        let (x, y, u, v) = (a.0 + NODE.0 / 2, a.1 + NODE.1, b.0 + NODE.0 / 2, b.1);
        let middle = (y + v) / 2;
        Some(format!("M{x} {y}C{x} {middle} {u} {middle} {u} {v}"))
    };
    Some(html! {
        figure class="graph" {
            div class="wide" tabindex="0" role="group" aria-label=(label) {
                svg xmlns="http://www.w3.org/2000/svg" width=(width) height=(height) viewBox={ "0 0 " (width) " " (height) } {
                    g class="edges" { @for edge in &edges { @if let Some(d) = path(edge) { path d=(d) {} } } }
                    @for (at, (x, y)) in &at_place {
                        @let item = &equations[*at];
                        a href={ "#" (equation_anchor(prefix, &item.id)) } {
                            title { "(" (item.id) "), " (item.finding.verdict.word()) }
                            rect class=(tone(item.finding.verdict, item.ok)) x=(x) y=(y) width=(NODE.0) height=(NODE.1) rx="6" {}
                            text x=(x + NODE.0 / 2) y=(y + 20) text-anchor="middle" { (short(&item.id)) }
                        }
                    }
                }
            }
            figcaption { "An arrow down: the lower equation uses a symbol that the upper one defines, or is checked against it." }
        }
    })
}

/// A name that fits into a node.
fn short(id: &str) -> String {
    match id.chars().count() > 8 {
        true => id.chars().take(7).chain(['…']).collect(),
        false => id.to_owned(),
    }
}
