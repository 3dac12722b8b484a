//! Reading of text files, with an error for what is no readable text.

use std::path::Path;
use std::sync::Arc;

use crate::code::Code;
use crate::error::reason;
use crate::source::{Encoding, Source};
use crate::{Error, Result};

/// The most bytes of a file.
const LARGEST: u64 = 64 << 20;

/// Reads a text file: too large, unreadable and bytes that are no text are errors.
pub(super) fn read_text(path: &Path, shown_as: &str) -> Result<Arc<Source>> {
    let failed = |error: std::io::Error| Error::new(format!("cannot read {shown_as}: {}", reason(&error)));
    let about = std::fs::metadata(path).map_err(failed)?;
    if about.is_dir() {
        return Err(Error::new(format!("cannot read {shown_as}: it is a folder")));
    }
    if !about.is_file() {
        return Err(Error::new(format!("cannot read {shown_as}: it is not a regular file")));
    }
    if about.len() > LARGEST {
        let size = about.len() >> 20;
        return Err(Error::new(format!("{shown_as} has {size} MB; the limit is {} MB", LARGEST >> 20))
            .with_code(Code::TooLarge)
            .help("split the file"));
    }
    let bytes = std::fs::read(path).map_err(failed)?;
    let is_utf16 = matches!(bytes.as_slice(), [0xff, 0xfe, ..] | [0xfe, 0xff, ..]);
    // No text has a character with the number 0.
    if !is_utf16 && bytes.contains(&0) {
        return Err(Error::new(format!("{shown_as} is not a text file")).help("name the file with the notes"));
    }
    let encoding = match bytes.as_slice() {
        [0xff, 0xfe, ..] => Encoding::Utf16Little,
        [0xfe, 0xff, ..] => Encoding::Utf16Big,
        _ if declares_one_byte(&bytes) && std::str::from_utf8(&bytes).is_err() => Encoding::Windows1252,
        _ => Encoding::Utf8,
    };
    encoding.decode(&bytes).map(|text| Arc::new(Source::new(shown_as, text).encoded(encoding))).map_err(|at| {
        let line = bytes[..at].iter().filter(|&&b| b == b'\n').count() + 1;
        let name = match encoding {
            Encoding::Utf8 => "UTF-8",
            Encoding::Windows1252 => "Windows-1252",
            Encoding::Utf16Little | Encoding::Utf16Big => "UTF-16",
        };
        let byte = bytes.get(at).copied().unwrap_or_default();
        Error::new(format!("{shown_as} is not {name}: byte {at} (0x{byte:02x}, line {line})"))
            .help("save the file as UTF-8")
    })
}

/// Whether a TeX file says that its characters are bytes of Latin-1 or Windows-1252.
fn declares_one_byte(bytes: &[u8]) -> bool {
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(1 << 16)]);
    let names = ["latin1", "ansinew", "cp1252"];
    head.contains("inputenc") && names.iter().any(|name| head.contains(&format!("[{name}]")))
        || names.iter().any(|name| head.contains(&format!("\\inputencoding{{{name}}}")))
}
