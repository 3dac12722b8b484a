//! `onshell schema`: the JSON Schema of a file that the program reads or writes.

use super::outcome::Outcome;

/// Prints the JSON Schema of the claims file or of the report
#[derive(clap::Args)]
#[command(after_help = "Example:\n  onshell schema claims > claims.schema.json")]
pub struct Arguments {
    /// `claims`, the file beside the notes, or `report`, what `onshell check --format json` prints
    #[arg(value_name = "FILE")]
    of: Subject,
}

/// What has a schema.
#[derive(Clone, Copy, clap::ValueEnum)]
enum Subject {
    Claims,
    Report,
}

pub(super) fn run(arguments: &Arguments) -> Outcome {
    let schema = match arguments.of {
        Subject::Claims => crate::notes::claims::schema::schema(),
        Subject::Report => crate::report::schema::report(),
    };
    Outcome::done(format!("{schema:#}\n"))
}
