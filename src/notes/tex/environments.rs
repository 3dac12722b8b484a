//! The author's own names for display environments: `\be … \ee`, `\begin{eq}`, `\eqn{…}`.

use std::collections::HashMap;

use crate::notes::macros::{self, Form};
use crate::notes::tex_scanner::{self, Delimiter};

/// The names that a text defines for display environments.
#[derive(Default)]
pub(super) struct Own {
    /// Commands that open one, with the name of the environment.
    opening: HashMap<String, String>,
    /// Commands that close one.
    closing: Vec<String>,
    /// Commands whose argument is a display, with the name of the environment.
    around: HashMap<String, String>,
    /// Environments, each with the one that it opens.
    environments: HashMap<String, String>,
}

impl Own {
    /// The names that `text` defines.
    pub fn of(text: &str) -> Own {
        let mut own = Own::default();
        if !text.contains("\\begin{") {
            return own;
        }
        for definition in macros::definitions(text) {
            let body = definition.body.trim();
            let opens = opened(body);
            match (opens, definition.form) {
                (Some(name), Form::Plain) if definition.arguments == 0 && !body.contains("\\end{") => {
                    own.opening.insert(definition.name, name.to_owned());
                }
                (Some(name), Form::Plain) if definition.arguments == 1 => {
                    let closing = format!("\\end{{{name}}}");
                    let inside = body[name.len() + "\\begin{}".len()..].strip_suffix(&closing).map(str::trim);
                    if inside == Some("#1") {
                        own.around.insert(definition.name, name.to_owned());
                    }
                }
                (None, Form::Plain) if definition.arguments == 0 && closes(body) => {
                    own.closing.push(definition.name);
                }
                _ => {}
            }
        }
        let mut at = 0;
        while let Some(next) = tex_scanner::find(text, at, "newenvironment") {
            at = next + "newenvironment".len();
            if let Some((name, environment)) = environment(text, at) {
                own.environments.insert(name, environment);
            }
        }
        own
    }

    /// The kind of the author's environment with this name.
    pub fn environment(&self, name: &str) -> Option<(Delimiter, &str)> {
        let real = self.environments.get(name)?;
        Some((tex_scanner::environment(real)?, real))
    }

    /// The environment that a command opens.
    pub fn opens(&self, command: &str) -> Option<&str> {
        self.opening.get(command).map(String::as_str)
    }

    /// The environment in which a command puts its argument.
    pub fn surrounds(&self, command: &str) -> Option<&str> {
        self.around.get(command).map(String::as_str)
    }

    /// Whether a command closes a display.
    pub fn closes(&self, command: &str) -> bool {
        self.closing.iter().any(|known| known == command)
    }
}

/// The display environment that a text opens at its start.
fn opened(body: &str) -> Option<&str> {
    let (name, _) = tex_scanner::begin(body, 0)?;
    tex_scanner::environment(name).map(|_| name)
}

/// Whether a text only closes environments, the last of them a display.
fn closes(body: &str) -> bool {
    let Some(last) = body.rfind("\\end{") else { return false };
    let name = body[last + "\\end{".len()..].strip_suffix('}');
    body.starts_with("\\end{") && name.is_some_and(|name| tex_scanner::environment(name).is_some())
}

/// `{eq}{\begin{equation}}{…}` after `\newenvironment`: the name, and the display environment.
fn environment(text: &str, at: usize) -> Option<(String, String)> {
    let bytes = text.as_bytes();
    let open = tex_scanner::skip_space(bytes, at + usize::from(bytes.get(at) == Some(&b'*')));
    let end = tex_scanner::short_group(bytes, open)?;
    let name = text.get(open + 1..end - 1)?.trim();
    let start = tex_scanner::skip_space(bytes, end);
    let close = tex_scanner::body(bytes, start)?;
    let name = (!name.is_empty()).then(|| name.to_owned())?;
    Some((name, opened(text.get(start + 1..close - 1)?.trim())?.to_owned()))
}
