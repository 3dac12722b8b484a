//! The encodings of text files: UTF-8, UTF-16 with its mark, and Windows-1252, of which Latin-1 is a part.

/// How characters are written as bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Encoding {
    /// UTF-8.
    #[default]
    Utf8,
    /// UTF-16, least byte first, after a mark of two bytes.
    Utf16Little,
    /// UTF-16, greatest byte first, after a mark of two bytes.
    Utf16Big,
    /// Windows-1252. Its printable characters of one byte are those of Latin-1, and 27 more.
    Windows1252,
}

/// The characters of the bytes 0x80 to 0x9f in Windows-1252; NUL where there is none.
const HIGH: [char; 32] = [
    '€', '\0', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\0', 'Ž', '\0', '\0', '‘', '’', '“', '”', '•',
    '–', '—', '˜', '™', 'š', '›', 'œ', '\0', 'ž', 'Ÿ',
];

impl Encoding {
    /// The text of these bytes.
    ///
    /// # Errors
    /// The first byte that is no text in this encoding.
    pub(crate) fn decode(self, bytes: &[u8]) -> Result<String, usize> {
        match self {
            Encoding::Utf8 => std::str::from_utf8(bytes).map(str::to_owned).map_err(|error| error.valid_up_to()),
            Encoding::Windows1252 => bytes.iter().enumerate().map(|(at, &byte)| character(byte).ok_or(at)).collect(),
            Encoding::Utf16Little | Encoding::Utf16Big => {
                let body = bytes.get(2..).unwrap_or_default();
                let units = body.chunks_exact(2).map(|pair| match self {
                    Encoding::Utf16Big => u16::from_be_bytes([pair[0], pair[1]]),
                    _ => u16::from_le_bytes([pair[0], pair[1]]),
                });
                let mut at = 2;
                let text = char::decode_utf16(units).map(|c| {
                    let here = at;
                    at += c.as_ref().map_or(2, |c| 2 * c.len_utf16());
                    c.map_err(|_| here)
                });
                let text: String = text.collect::<Result<_, usize>>()?;
                if body.len() % 2 == 1 { Err(bytes.len() - 1) } else { Ok(text) }
            }
        }
    }

    /// The bytes of a text; none, if a character cannot be written.
    pub(crate) fn encode(self, text: &str) -> Option<Vec<u8>> {
        match self {
            Encoding::Utf8 => Some(text.as_bytes().to_vec()),
            Encoding::Windows1252 => text.chars().map(byte).collect(),
            Encoding::Utf16Little => {
                Some([0xff, 0xfe].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect())
            }
            Encoding::Utf16Big => {
                Some([0xfe, 0xff].into_iter().chain(text.encode_utf16().flat_map(u16::to_be_bytes)).collect())
            }
        }
    }

    /// The number of bytes that precede what follows `before` in a file.
    pub(crate) fn bytes(self, before: &str) -> usize {
        match self {
            Encoding::Utf8 => before.len(),
            Encoding::Windows1252 => before.chars().count(),
            Encoding::Utf16Little | Encoding::Utf16Big => 2 + 2 * before.chars().map(char::len_utf16).sum::<usize>(),
        }
    }
}

fn character(byte: u8) -> Option<char> {
    match byte {
        0x80..=0x9f => Some(HIGH[usize::from(byte - 0x80)]).filter(|c| *c != '\0'),
        byte => Some(char::from(byte)),
    }
}

fn byte(c: char) -> Option<u8> {
    match u8::try_from(u32::from(c)) {
        Ok(byte) if !(0x80..=0x9f).contains(&byte) => Some(byte),
        _ => HIGH.iter().position(|high| *high == c && c != '\0').and_then(|at| u8::try_from(0x80 + at).ok()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_decoded_is_encoded_again_and_bad_bytes_are_named() {
        let text = "Zürich: „α“ €\n";
        for encoding in [Encoding::Utf8, Encoding::Utf16Little, Encoding::Utf16Big] {
            let bytes = encoding.encode(text).unwrap();
            assert_eq!(encoding.decode(&bytes).as_deref(), Ok(text), "{encoding:?}");
            assert_eq!(encoding.bytes(text), bytes.len(), "{encoding:?}");
        }
        assert_eq!(Encoding::Windows1252.encode("α"), None);
        let bytes = Encoding::Windows1252.encode("für „€“").unwrap();
        assert_eq!(Encoding::Windows1252.decode(&bytes).as_deref(), Ok("für „€“"));
        assert_eq!(Encoding::Windows1252.decode(b"ab\x81"), Err(2));
        assert_eq!(Encoding::Utf16Little.decode(&[0xff, 0xfe, 0x61, 0x00, 0x00, 0xd8]), Err(4));
        assert_eq!(Encoding::Utf16Big.decode(&[0xfe, 0xff, 0x00]), Err(2));
    }
}
