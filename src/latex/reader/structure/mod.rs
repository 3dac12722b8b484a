//! What is read for its structure only: operators, tensors, states, lists, words.
//!
//! A display is read here in a second attempt, if `onshell read` asks for it ([`Symbols::may_be_abstract`]) and the first
//! attempt failed. What has no value is a template: LaTeX with a # for each formula in it, such as `\langle # | # \rangle`
//! or `# \otimes #` ([`Operator::Template`]). Shapes are not compared then, and factors stay in their order. Nothing that
//! is read in this way is ever evaluated.
//!
//! | file | what is read there |
//! | --- | --- |
//! | `acting` | letters that are operators or matrices, and no numbers |
//! | `brackets` | states, mean values, commutators, Poisson brackets, tuples, intervals, sets |
//! | `scripts` | indices, marks and labels above a symbol |
//! | `followers` | what follows a factor and belongs to it |
//! | `operators` | derivatives by anything, ∂_μ and ∇ as operators |
//! | `indicators` | `\mathbb{1}[x > 0]` |
//! | `extrema` | `\min_x` and its kin, before a sum |
//! | `named_functions` | `\max(a, b)` and other functions with a name; the power of their value |
//! | `evidence` | which letters are indices, and which functions |
//! | `indices` | letters above letters that are indices, or may be |
//! | `levels` | numbers of steps above letters, `u^{n+1}` |
//! | `repeated` | letters that two factors have as an index |
//! | `infix` | ⊗, ∘ and the like; ∈, → and the like; lists |
//!
//! [`Symbols::may_be_abstract`]: crate::formula::Symbols::may_be_abstract
//!
//! Offers methods of the reader that give such a formula as [`Node::Apply`] of a label, and what decides that a display is read so. Knows
//! the layout, the names and the state of the reader.

mod acting;
mod brackets;
mod evidence;
mod extrema;
mod followers;
mod indicators;
mod indices;
mod infix;
mod levels;
mod named_functions;
mod operators;
mod repeated;
mod scripts;

pub(in super::super) use acting::note_acting;
pub(super) use brackets::is_alone_in_brackets;
pub(in super::super) use evidence::{is_function_letter, note};
pub(in super::super) use extrema::is_extremum;
pub(super) use followers::is_open_decimal;
pub(in super::super) use indices::{note_indices, note_possible_indices};
pub(in super::super) use infix::{is_prose, states};
pub(in super::super) use levels::note_levels;
pub(super) use operators::is_material;

use crate::formula::symbols::{Kind, Name, Operator};
use crate::formula::tree::{Expr, Node};
use crate::source::{Fault, Span};

use super::super::layout::{Delimiter, Item, Layout, contents, latex};
use super::super::names;
use super::state::{Read, Reader, unknown_command};

impl Reader<'_> {
    /// Whether this is the second attempt, for the structure only.
    pub(super) fn is_abstract(&self) -> bool {
        self.symbols.is_abstract()
    }

    /// A template with its arguments.
    pub(super) fn template(&mut self, template: &str, arguments: Vec<Expr>, span: Span) -> Expr {
        self.operate_by(Name::plain(template), Kind::Abstract, Operator::Template, arguments, span)
    }

    /// What is shown as it is printed.
    pub(in super::super) fn label(&mut self, items: &[Item], span: Span) -> Expr {
        let text = printed(items);
        self.template(&text, Vec::new(), span)
    }

    /// A symbol without a value.
    pub(super) fn valueless(&mut self, name: Name, dots: u8, span: Span) -> Read<Expr> {
        let id = match self.symbols.find(&name) {
            Some((id, _)) => id,
            None => {
                let taken = || {
                    Fault::new(span, format!("{name} is already the name of another symbol"))
                        .help("use another name for one of the two")
                };
                self.symbols.add(name.clone(), Kind::Abstract).ok_or_else(taken)?
            }
        };
        Ok(Expr::new(Node::Symbol { id, indices: Vec::new(), dots }, span))
    }

    /// An item that only the second attempt reads; `None` if it does not either.
    pub(super) fn abstract_item(&mut self, item: &Item) -> Read<Option<Expr>> {
        let span = item.span;
        Ok(match &item.layout {
            Layout::Text(_) => Some(self.label(std::slice::from_ref(item), span)),
            Layout::Command(name)
                if [
                    "\\vdots",
                    "\\ddots",
                    "\\infty",
                    "\\emptyset",
                    "\\Box",
                    "\\nabla",
                    "\\partial",
                    "\\bullet",
                    "\\cdot",
                    "\\circ",
                    "\\star",
                    "\\ast",
                    "\\uparrow",
                    "\\downarrow",
                    "\\hslash",
                    "\\wp",
                    "\\aleph",
                    "\\dagger",
                    "\\varnothing",
                ]
                .contains(&name.as_str()) =>
            {
                Some(self.label(std::slice::from_ref(item), span))
            }
            Layout::Fence(..) => self.bracketed(item)?,
            Layout::Fraction(..) => self.abstract_derivative(std::slice::from_ref(item), &mut 0)?,
            // `\underbrace{x}_{y}`
            Layout::Style(style, inner) if style == "\\mathrm" => {
                let name = printed(contents(inner));
                Some(self.valueless(Name::plain(format!("\\mathrm{{{name}}}")), 0, span)?)
            }
            // A zero of any size.
            Layout::Style(_, inner) | Layout::Accent(_, inner) if super::items::whole_number(inner) == Some(0) => {
                Some(self.label(std::slice::from_ref(item), span))
            }
            Layout::Style(_, inner) if super::items::whole_number(inner).is_some() => None,
            Layout::Accent(accent, inner) if accent == "\\vec" && evidence::segment(inner).is_some() => {
                let points = evidence::segment(inner).unwrap_or_default();
                Some(self.valueless(Name::plain(format!("\\vec{{{points}}}")), 0, span)?)
            }
            Layout::Style(style, inner) | Layout::Accent(style, inner) => {
                let inner = self.item(inner)?;
                Some(self.template(&format!("{style}{{#}}"), vec![inner], span))
            }
            Layout::Scripts { nucleus, .. } if matches!(nucleus.layout, Layout::Fence(Delimiter::Evaluation, _)) => {
                None
            }
            Layout::Scripts { nucleus, sub: Some(_), sup: Some(_), .. }
                if matches!(nucleus.layout, Layout::Fence(Delimiter::Square, _)) =>
            {
                None
            }
            // A symbol with scripts of more than names: `\delta_{|m||n|}`, `f_{a=0}`.
            Layout::Scripts { nucleus, sub: Some(sub), sup, primes } => {
                let inner = match (&**nucleus, primes) {
                    (nucleus, 0) => nucleus.clone(),
                    (nucleus, primes) => Item {
                        layout: Layout::Scripts {
                            nucleus: Box::new(nucleus.clone()),
                            sub: None,
                            sup: None,
                            primes: *primes,
                        },
                        span,
                    },
                };
                if let Some(fault) = contents(sub).iter().find_map(fault_in) {
                    return Err(fault);
                }
                if let [Item { layout: Layout::Command(name), span }] = contents(sub)
                    && !names::is_index_sign(name)
                {
                    return Err(unknown_command(name, *span, false));
                }
                let inner = self.item(&inner)?;
                let below = printed(contents(sub));
                // Parentheses around one factor are shown: the script belongs to all of it.
                let is_one = matches!(inner.node, Node::Apply(..) | Node::Symbol { .. });
                let holder = match &nucleus.layout {
                    // One letter in brackets has them already.
                    Layout::Fence(Delimiter::Square, inside) if is_one && inside.len() > 1 => "[#]",
                    Layout::Fence(Delimiter::Round, inside) if is_one && !is_derivative(inside) => "(#)",
                    _ => "#",
                };
                let base = self.template(&format!("{holder}_{{{below}}}"), vec![inner], span);
                Some(match sup {
                    Some(sup) => self.raised(base, sup, span)?,
                    None => base,
                })
            }
            Layout::Scripts { nucleus, sub: None, sup: None, primes } => {
                let inner = self.item(nucleus)?;
                Some(self.template(&format!("#{}", "'".repeat(usize::from(*primes))), vec![inner], span))
            }
            _ => None,
        })
    }
}

/// Whether a fraction stands alone, as in `(\partial S/\partial V)_T`.
fn is_derivative(items: &[Item]) -> bool {
    matches!(items, [Item { layout: Layout::Fraction(..), .. }])
}

/// Why a part of an item cannot be read.
pub(in super::super) fn fault_in(item: &Item) -> Option<Fault> {
    match &item.layout {
        Layout::Fault(fault) => Some(fault.clone()),
        _ => crate::latex::layout::parts(item).into_iter().flatten().find_map(fault_in),
    }
}

/// Items as they are printed, for a template.
pub(in super::super) fn printed(items: &[Item]) -> String {
    latex(items).replace('#', "")
}
