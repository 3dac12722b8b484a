//! Subscripts, superscripts and primes: what they belong to, and the sign above a name that is no power.

use crate::source::{Fault, Span};

use super::super::lexer::TokenKind;
use super::item::{Item, Layout, letters};
use super::parser::{Parser, of_fault};

impl Parser<'_> {
    /// Gives the last item the primes that follow.
    pub(super) fn attach_primes(&mut self, items: &mut Vec<Item>) {
        let Some(last) = items.pop() else { return };
        let (mut marks, mut span) = (0u8, last.span);
        while let Some(token) = self.peek().filter(|token| token.kind == TokenKind::Prime) {
            span = span.to(token.span);
            marks = marks.saturating_add(1);
            self.next();
        }
        let layout = match last.layout {
            Layout::Scripts { nucleus, sub, sup, primes } => {
                Layout::Scripts { nucleus, sub, sup, primes: primes.saturating_add(marks) }
            }
            other => Layout::Scripts {
                nucleus: Box::new(Item { layout: other, span: last.span }),
                sub: None,
                sup: None,
                primes: marks,
            },
        };
        items.push(Item { layout, span });
    }

    /// An item with the scripts that follow it.
    pub(super) fn scripted(&mut self, single_digit: bool) -> Item {
        let nucleus = match self.peek() {
            Some(token) if matches!(token.kind, TokenKind::Sub | TokenKind::Super | TokenKind::Prime) => {
                // The reader says what is missing.
                Item { layout: Layout::Group(Vec::new()), span: Span::at(token.span.start) }
            }
            _ => self.item(single_digit),
        };
        let (mut sub, mut sup, mut primes) = (None, None, 0u8);
        let mut problem = None;
        while let Some(token) = self.peek() {
            let slot = match token.kind {
                TokenKind::Prime => {
                    self.next();
                    primes = primes.saturating_add(1);
                    continue;
                }
                TokenKind::Sub => &mut sub,
                TokenKind::Super => &mut sup,
                _ => break,
            };
            if slot.is_some() && problem.is_none() {
                problem = Some(of_fault(match token.kind {
                    TokenKind::Sub => Fault::new(token.span, "two subscripts follow one symbol")
                        .help("write both in one, x_{ab}, or put braces around the first, {x_a}_b"),
                    _ => Fault::new(token.span, "two superscripts follow one symbol")
                        .help("write both in one, x^{ab}, or put braces around the first, {x^a}^b"),
                }));
            }
            self.next();
            let sign = self.peek().filter(|next| matches!(next.kind, TokenKind::Other('+' | '-')));
            *slot = Some(Box::new(match sign {
                // `v^+`: a mark above, unless more touches it, as in `x^-1`, where braces are forgotten.
                Some(sign) if token.kind == TokenKind::Super => {
                    self.next();
                    let touches = self.peek().is_some_and(|next| {
                        next.span.start == sign.span.end
                            && match &next.kind {
                                TokenKind::Digit(_) | TokenKind::Letter(_) => true,
                                TokenKind::Command(name) => !["\\right", "\\end", "\\rangle"].contains(&name.as_str()),
                                _ => false,
                            }
                    });
                    match (touches, &sign.kind) {
                        (false, TokenKind::Other(c)) => Item { layout: Layout::Other(*c), span: sign.span },
                        _ => of_fault(
                            Fault::ambiguous(sign.span, "only the sign after the ^ is raised here")
                                .help("put the whole superscript in braces, as in x^{-1}"),
                        ),
                    }
                }
                // `\Omega_+`: a sign as a subscript
                Some(sign) if token.kind == TokenKind::Sub => {
                    self.next();
                    let TokenKind::Other(c) = sign.kind else { continue };
                    Item { layout: Layout::Other(c), span: sign.span }
                }
                _ => match self.bars() {
                    Some(parallel) => parallel,
                    None => self.argument(token.span),
                },
            }));
        }
        if let Some(problem) = problem {
            return problem;
        }
        // `v^{\prime 2}` is the square of v'.
        if let Some(Item { layout: Layout::Group(above), .. }) = sup.as_deref_mut()
            && let [Item { layout: Layout::Command(first), .. }, Item { layout: Layout::Number(_), .. }] =
                above.as_slice()
            && first == "\\prime"
        {
            above.remove(0);
            primes = primes.saturating_add(1);
        }
        // `x^{}`, as a macro without its optional argument writes it, sets nothing.
        if !is_nothing(&nucleus) {
            (sub, sup) = (sub.filter(|script| !is_nothing(script)), sup.filter(|script| !is_nothing(script)));
        }
        if sub.is_none() && sup.is_none() && primes == 0 {
            return nucleus;
        }
        let span = nucleus.span.to(Span::at(self.previous_end()));
        Item { layout: Layout::Scripts { nucleus: Box::new(nucleus), sub, sup, primes }, span }
    }

    /// The two bars of `v_\|` or `v_{\|}`, which say "parallel" and open no norm.
    fn bars(&mut self) -> Option<Item> {
        let is_braced = self.peek().is_some_and(|token| token.kind == TokenKind::Open);
        let bars = self.tokens.get(self.at + usize::from(is_braced))?;
        let is_it = matches!(&bars.kind, TokenKind::Command(name) if name == "\\|" || name == "\\Vert");
        let is_closed = !is_braced || self.tokens.get(self.at + 2)?.kind == TokenKind::Close;
        let span = bars.span;
        (is_it && is_closed).then(|| {
            self.at += if is_braced { 3 } else { 1 };
            Item { layout: Layout::Command("\\parallel".to_owned()), span }
        })
    }

    /// Whether `\underset{x}{\min}` follows, up to its operator.
    pub(super) fn is_underset_operator(&mut self) -> bool {
        const WORDS: [&str; 12] = [
            "min", "max", "sup", "inf", "argmin", "argmax", "arginf", "argsup", "minimize", "maximize", "minimum",
            "maximum",
        ];
        let at = self.at;
        self.argument(Span::at(self.previous_end()));
        let operator = self.argument(Span::at(self.previous_end()));
        self.at = at;
        WORDS.contains(&letters(&operator).trim_start_matches('\\'))
    }

    /// `\underset{x}{\min}`, which is `\min_x`.
    pub(super) fn underset(&mut self, span: Span) -> Item {
        let below = self.argument(span);
        let nucleus = match self.argument(span) {
            Item { layout: Layout::Group(mut items), .. } if items.len() == 1 => items.remove(0),
            nucleus => nucleus,
        };
        let span = span.to(Span::at(self.previous_end()));
        let layout = Layout::Scripts { nucleus: Box::new(nucleus), sub: Some(Box::new(below)), sup: None, primes: 0 };
        Item { layout, span }
    }
}

/// Whether a group holds nothing but spaces.
fn is_nothing(item: &Item) -> bool {
    matches!(&item.layout, Layout::Group(items) if items.iter().all(|item| matches!(item.layout, Layout::Space(_))))
}
