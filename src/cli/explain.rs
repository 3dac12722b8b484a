//! `onshell explain`: what a verdict or the code of a message means.

use crate::report::explain::{Topic, all, example, topic};
use crate::{Error, suggest};

use super::outcome::{Format, Outcome, Screen};

/// Explains a verdict, the outcome of a mutant, or the code of a message
///
/// It prints what the word means, what to do, and an example to try. Without a word, it lists everything that it explains.
#[derive(clap::Args)]
#[command(after_help = "Example:\n  onshell explain refuted")]
pub struct Arguments {
    /// A verdict such as `refuted`, an outcome such as `survived`, or a code as it stands in `error[…]`
    #[arg(value_name = "VERDICT-OR-CODE")]
    word: Option<String>,
}

pub(super) fn run(arguments: &Arguments, screen: Screen) -> Outcome {
    let Some(word) = &arguments.word else { return Outcome::done(all(screen.out)) };
    match Topic::named(word).as_slice() {
        [] => {
            let unknown = Error::new(format!(
                "“{word}” is neither a verdict, nor an outcome of a mutant, nor a code of a message"
            ));
            let error = match suggest::nearest(word, Topic::all().map(Topic::word)) {
                Some(near) => unknown.help(format!("did you mean {near}?")),
                None => unknown.help("`onshell explain` without a word lists all that it explains"),
            };
            Outcome::failed(&error, Format::Text, screen)
        }
        named => {
            let texts: Vec<String> = named.iter().map(|named| topic(*named, screen.out)).collect();
            Outcome::done(texts.join("\n") + &example(word, screen.out))
        }
    }
}
