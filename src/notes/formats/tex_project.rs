//! TeX: a file with the files that it puts in, as one document.
//!
//! `\input`, `\include`, `\subfile`, `\import` and `\subimport` are followed. Of packages and classes beside the document only
//! the commands that they define are taken, and of the root of a part (`% !TEX root = …`, `\documentclass[…]{subfiles}`) too.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{Format, View};
use crate::notes::kind::Kind;
use crate::notes::{file, macros, tex, tex_scanner};
use crate::source::{Builder, Fault, Source, Span};
use crate::{Error, Result};

pub(super) const FORMAT: Format =
    Format { extensions: &["tex", "latex", "ltx"], kind: Kind::Tex, is_code: false, view };

/// The most files inside one another.
const DEEPEST: usize = 16;
/// The most bytes of a whole document.
const LARGEST: usize = 64 << 20;

fn view(file: &Arc<Source>, path: &Path) -> Result<View> {
    let mut project = Project {
        view: Builder::new(file.clone()),
        folder: path.parent().unwrap_or(Path::new("")).to_owned(),
        open: vec![path.canonicalize().unwrap_or_else(|_| path.to_owned())],
        absent: Vec::new(),
        files: 1,
        bytes: 0,
    };
    if let Some(root) = root(&file.text) {
        project.definitions(&project.folder.join(root))?;
    }
    project.file(0, file, path)?;
    if project.files == 1 {
        return Ok(View { source: file.clone(), absent: project.absent });
    }
    let Project { view, absent, .. } = project;
    Ok(View { source: Arc::new(view.finish(|text| Some(text.to_owned()))), absent })
}

struct Project {
    view: Builder,
    /// The folder of the document, from which TeX names files.
    folder: PathBuf,
    /// The files that are being put in, from the outermost on.
    open: Vec<PathBuf>,
    absent: Vec<Error>,
    files: usize,
    bytes: usize,
}

impl Project {
    /// Writes a file into the view.
    fn file(&mut self, number: usize, file: &Arc<Source>, path: &Path) -> Result<()> {
        let text = &file.text;
        self.bytes += text.len();
        if self.bytes > LARGEST {
            return Err(Error::new(format!("{} and the files that it includes are too large together", file.path)));
        }
        let (mut at, mut end) = (0, text.len());
        // A part that is also a document of its own.
        if number > 0
            && let Some(begin) = tex_scanner::find(text, 0, "\\begin{document}")
        {
            at = begin + "\\begin{document}".len();
            end = tex_scanner::find(text, at, "\\end{document}").unwrap_or(end);
        }
        let mut from = at;
        while at < end {
            at = match text.as_bytes()[at] {
                b'%' => tex_scanner::line_end(text.as_bytes(), at),
                b'\\' => {
                    let word = tex_scanner::word_end(text.as_bytes(), at);
                    let Some(named) = named(text, at, word) else {
                        at = tex::verbatim_end(text, at).unwrap_or(word.max(at + 2));
                        continue;
                    };
                    self.view.copy_of(number, Span::new(from, at));
                    let place = Span::new(at, named.end);
                    match named.what {
                        What::Part => self.part(number, file, place, path, &named.file)?,
                        What::Package(extension) => {
                            for name in named.file.split(',') {
                                self.definitions(&self.folder.join(format!("{}.{extension}", name.trim())))?;
                            }
                        }
                    }
                    from = named.end;
                    named.end
                }
                _ => at + 1,
            };
        }
        self.view.copy_of(number, Span::new(from.min(end), end));
        Ok(())
    }

    /// Writes the file that is named at a place of another file.
    fn part(&mut self, number: usize, file: &Arc<Source>, place: Span, within: &Path, name: &str) -> Result<()> {
        // The end of the line stays one.
        self.view.written_for(number, place, "\n");
        let beside = within.parent().unwrap_or(Path::new(""));
        let choices = [&self.folder, beside].into_iter().flat_map(|folder| {
            let plain = folder.join(name);
            let mut longer = plain.clone().into_os_string();
            longer.push(".tex");
            [PathBuf::from(longer), plain]
        });
        let Some(path) = choices.into_iter().find(|path| path.is_file()) else {
            let fault = Fault::notes(place, format!("the file {name} is not there"));
            self.absent
                .push(Error::fault(file, fault.help("correct the name; the contents of this file were not checked")));
            return Ok(());
        };
        let canonical = path.canonicalize().unwrap_or_else(|_| path.clone());
        if self.open.contains(&canonical) || self.open.len() > DEEPEST {
            let fault = Fault::notes(place, format!("the file {name} includes itself"));
            return Err(Error::fault(file, fault.help("remove this line, or the one that leads back here")));
        }
        let part = file::read_text(&path, &path.display().to_string())?;
        let added = self.view.add(part.clone());
        self.files += 1;
        self.open.push(canonical);
        self.file(added, &part, &path)?;
        self.open.pop();
        self.view.written_for(added, Span::at(part.text.len()), "\n");
        Ok(())
    }

    /// Writes the commands that a file defines, if it is there.
    fn definitions(&mut self, path: &Path) -> Result<()> {
        let canonical = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        if !path.is_file() || self.open.len() > DEEPEST || self.open.contains(&canonical) {
            return Ok(());
        }
        let file = file::read_text(path, &path.display().to_string())?;
        let added = self.view.add(file.clone());
        self.files += 1;
        self.open.push(canonical);
        let beside = path.parent().unwrap_or(Path::new("")).to_owned();
        let text = &file.text;
        let mut at = 0;
        while at < text.len() {
            at = match text.as_bytes()[at] {
                b'%' => tex_scanner::line_end(text.as_bytes(), at),
                b'\\' if text[at..].starts_with("\\begin{document}") => break,
                b'\\' => {
                    let word = tex_scanner::word_end(text.as_bytes(), at);
                    if let Some(definition) = macros::definition(text, at) {
                        self.view.copy_of(added, definition.span);
                        self.view.written_for(added, Span::at(definition.span.end), "\n");
                        definition.span.end
                    } else if let Some(named) = named(text, at, word) {
                        let extension = match named.what {
                            What::Part => "tex",
                            What::Package(extension) => extension,
                        };
                        for name in named.file.split(',').map(str::trim) {
                            self.definitions(&beside.join(name).with_extension(extension))?;
                        }
                        named.end
                    } else {
                        word.max(at + 2)
                    }
                }
                _ => at + 1,
            };
        }
        self.open.pop();
        Ok(())
    }
}

/// A file that a command names.
struct Named {
    what: What,
    file: String,
    end: usize,
}

enum What {
    /// Its text stands there.
    Part,
    /// A package or a class, with the extension of its files.
    Package(&'static str),
}

fn named(text: &str, at: usize, word: usize) -> Option<Named> {
    let bytes = text.as_bytes();
    let group = |at: usize| {
        let open = tex_scanner::skip_space(bytes, at);
        let end = tex_scanner::short_group(bytes, open)?;
        Some((text.get(open + 1..end - 1)?.trim(), end))
    };
    let what = match &text[at + 1..word] {
        "input" | "include" | "subfile" | "import" | "subimport" => What::Part,
        "usepackage" | "RequirePackage" => What::Package("sty"),
        "documentclass" | "LoadClass" => What::Package("cls"),
        _ => return None,
    };
    let command = &text[at + 1..word];
    let star = usize::from(bytes.get(word) == Some(&b'*'));
    let mut after = tex_scanner::skip_space(bytes, word + star);
    if matches!(what, What::Package(_)) && bytes.get(after) == Some(&b'[') {
        after += bytes[after..].iter().take(4096).position(|b| *b == b']')? + 1;
    }
    if command == "input" && bytes.get(after).is_some_and(|b| b.is_ascii_alphanumeric() || matches!(b, b'.' | b'_')) {
        let length = text[after..]
            .find(|c: char| c.is_whitespace() || matches!(c, '\\' | '}' | '%'))
            .unwrap_or(text.len() - after);
        return Some(Named { what, file: text[after..after + length].to_owned(), end: after + length });
    }
    let (first, end) = group(after)?;
    if command.ends_with("import") {
        let (second, end) = group(end)?;
        return Some(Named { what, file: Path::new(first).join(second).to_string_lossy().into_owned(), end });
    }
    // A name with a parameter stands in a definition.
    (!first.is_empty() && !first.contains(['#', '\\'])).then(|| Named { what, file: first.to_owned(), end })
}

/// The root of a document of which the text is a part, relative to it.
fn root(text: &str) -> Option<&str> {
    let magic = text.lines().take(20).find_map(|line| {
        let comment = line.trim_start().strip_prefix('%')?.trim_start().strip_prefix("!T")?;
        let (key, value) = comment.split_once('=')?;
        key.trim_end().to_ascii_lowercase().ends_with("root").then_some(value.trim())
    });
    magic.or_else(|| {
        let rest = &text[text.find("\\documentclass[")? + "\\documentclass[".len()..];
        let (root, class) = rest.split_once(']')?;
        class.starts_with("{subfiles}").then_some(root.trim())
    })
}
