//! Reading of text files, with an error for what is no readable UTF-8 text.

use std::path::Path;
use std::sync::Arc;

use crate::code::Code;
use crate::error::reason;
use crate::source::Source;
use crate::{Error, Result};

/// The most bytes of a file.
const LARGEST: u64 = 64 << 20;

/// Reads a text file: too large, unreadable and not UTF-8 are errors.
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
    match String::from_utf8(bytes) {
        Ok(text) => Ok(Arc::new(Source::new(shown_as, text))),
        Err(error) => {
            let at = error.utf8_error().valid_up_to();
            let bytes = error.as_bytes();
            let line = bytes[..at].iter().filter(|&&b| b == b'\n').count() + 1;
            Err(Error::new(format!("{shown_as} is not UTF-8: byte {at} (0x{:02x}, line {line})", bytes[at]))
                .help("save the file as UTF-8"))
        }
    }
}
