//! Values on the command line: those of names, `--set NAME=VALUE`, and the seed of the sampled states.

use crate::{Error, Result};

/// The seed of the sampled states.
///
/// # Errors
/// For what is no whole number, or is negative.
pub(super) fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| "the seed must be a whole number, 0 or larger".to_owned())
}

/// The number of sampled states.
///
/// # Errors
/// For what is no whole number, or is too small or too large.
pub(super) fn points(text: &str) -> Result<u32, String> {
    let points = text.parse().ok().filter(|points| (1..=100_000).contains(points));
    points.ok_or_else(|| "write a whole number from 1 to 100000, such as 24".to_owned())
}

/// What a hint says, from 0 to 3.
///
/// # Errors
/// For what is no whole number from 0 to 3.
pub(super) fn hints(text: &str) -> Result<u8, String> {
    let level = text.parse().ok().filter(|level| *level <= 3);
    level.ok_or_else(|| "write a whole number from 0 to 3".to_owned())
}

/// The port of a server.
///
/// # Errors
/// For what is no whole number from 0 to 65535.
pub(super) fn port(text: &str) -> Result<u16, String> {
    text.parse().map_err(|_| "write a whole number from 0 to 65535".to_owned())
}

/// A name and its value, from `NAME=VALUE`.
///
/// # Errors
/// For a text without an equals sign or without a name, and for a value that is no finite number.
pub(super) fn setting(pair: &str) -> Result<(&str, f64)> {
    let example = |name: &str| format!("write --set '{name}=0.5'");
    let halves = pair.split_once('=').map(|(name, value)| (name.trim(), value.trim()));
    let Some((name, value)) = halves.filter(|(name, _)| !name.is_empty()) else {
        return Err(Error::new(format!("--set {pair} does not have the form NAME=VALUE")).help(example("\\theta")));
    };
    match value.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok((name, number)),
        Ok(number) if number.is_infinite() => {
            Err(Error::new(format!("the value of {name} is too large to compute with")))
        }
        _ => Err(Error::new(format!("“{value}” is not a number in --set {pair}")).help(example(name))),
    }
}
