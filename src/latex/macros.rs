//! The author's own commands: `\newcommand`, `\def` and the `macros` of a claims file.
//!
//! Expansion works on tokens. The tokens of a macro's body carry the place of the call, so that a fault is shown where
//! the author wrote the call.

use std::collections::HashMap;

use crate::code::Code;
use crate::source::{Fault, Span};

use super::lexer::{Token, TokenKind, tokens};

/// The most tokens of one expansion; more is taken to be endless.
const LARGEST_EXPANSION: usize = 100_000;

/// Commands with their bodies.
#[derive(Clone, Debug, Default)]
pub struct Macros {
    bodies: HashMap<String, (usize, Vec<Token>)>,
}

impl Macros {
    /// Defines the macro `name` (with its backslash), its number of arguments and its body.
    pub fn define(&mut self, name: &str, arguments: usize, body: &str) {
        self.bodies.insert(name.to_owned(), (arguments, tokens(body)));
    }

    /// The number of arguments of a body: the largest `#n` in it.
    pub fn arguments_of(body: &str) -> usize {
        let parameters = tokens(body).into_iter().filter_map(|token| match token.kind {
            TokenKind::Parameter(n) => Some(usize::from(n)),
            _ => None,
        });
        parameters.max().unwrap_or(0)
    }

    /// Replaces every call in `input`.
    ///
    /// # Errors
    /// A call without all its arguments, and an expansion without end.
    pub fn expand(&self, input: Vec<Token>) -> Result<Vec<Token>, Fault> {
        if self.bodies.is_empty() {
            return Ok(input);
        }
        let mut pending: Vec<Token> = input.into_iter().rev().collect();
        let mut output = Vec::with_capacity(pending.len());
        let mut produced = 0;
        while let Some(token) = pending.pop() {
            let TokenKind::Command(name) = &token.kind else {
                output.push(token);
                continue;
            };
            let Some((arguments, body)) = self.bodies.get(name) else {
                output.push(token);
                continue;
            };
            let mut values = Vec::with_capacity(*arguments);
            for n in 1..=*arguments {
                let missing = || {
                    Fault::new(token.span, format!("{name} needs {arguments} arguments, and argument {n} is missing"))
                        .code(Code::UnknownCommand)
                };
                values.push(argument(&mut pending).ok_or_else(missing)?);
            }
            let expansion: Vec<Token> = substitute(body, &values, token.span);
            produced += expansion.len() + 1;
            if produced > LARGEST_EXPANSION {
                return Err(Fault::new(
                    token.span,
                    format!("the macro {name} expands without end, or to too many tokens"),
                )
                .code(Code::UnknownCommand)
                .help("a macro must not call itself"));
            }
            pending.extend(expansion.into_iter().rev());
        }
        Ok(output)
    }
}

/// Takes one token, or one group without its braces, from the end of the reversed input.
fn argument(pending: &mut Vec<Token>) -> Option<Vec<Token>> {
    let first = pending.pop()?;
    if first.kind != TokenKind::Open {
        return Some(vec![first]);
    }
    let mut depth = 1;
    let mut taken = Vec::new();
    loop {
        let token = pending.pop()?;
        match token.kind {
            TokenKind::Open => depth += 1,
            TokenKind::Close => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some(taken);
        }
        taken.push(token);
    }
}

fn substitute(body: &[Token], values: &[Vec<Token>], call: Span) -> Vec<Token> {
    let mut result = Vec::with_capacity(body.len());
    for token in body {
        match token.kind {
            TokenKind::Parameter(n) if n >= 1 => {
                result.extend(values.get(usize::from(n) - 1).into_iter().flatten().cloned())
            }
            _ => result.push(Token { kind: token.kind.clone(), span: call }),
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arguments_keep_their_own_bytes() {
        let mut macros = Macros::default();
        macros.define("\\half", 1, "\\frac{#1}{2}");
        let expanded = macros.expand(tokens("\\half{x}")).unwrap();
        let x = expanded.iter().find(|t| t.kind == TokenKind::Letter('x')).unwrap();
        assert_eq!(x.span, Span::new(6, 7));
    }

    #[test]
    fn a_macro_that_calls_itself_is_a_fault() {
        let mut macros = Macros::default();
        macros.define("\\x", 0, "\\x\\x");
        assert!(macros.expand(tokens("\\x")).is_err());
    }
}
