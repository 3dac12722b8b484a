//! The command line: flags to calls, results to output and exit codes. No mathematics.
//!
//! Exit codes of every command: 0 when all is as it should be, 1 when something is wrong, 2 when something could not be
//! checked or read.

mod check;
mod derive;
mod documents;
mod equal;
mod eval;
mod fix;
mod mutate;
mod progress;
mod read;

use std::io::{IsTerminal, Write};
use std::process::ExitCode;

use clap::{Parser, Subcommand, ValueEnum};

use crate::systems::Registry;

/// Checks the equations in physics notes against what automatic differentiation derives.
#[derive(Parser)]
#[command(version, about, max_term_width = 100)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Check(check::Arguments),
    Derive(derive::Arguments),
    Equal(equal::Arguments),
    Eval(eval::Arguments),
    Mutate(mutate::Arguments),
    Read(read::Arguments),
}

/// The form of the output.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people.
    Text,
    /// For machines.
    Json,
}

/// Runs the command that the program was started with, with the systems of a registry.
///
/// A crate with systems of its own calls this from its `main` with its own registry, and so has the whole command.
pub fn run(registry: &Registry) -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            let _ = error.print();
            return ExitCode::from(if error.use_stderr() { 2 } else { 0 });
        }
    };
    let outcome = match arguments.command {
        Command::Check(arguments) => check::run(&arguments, registry),
        Command::Derive(arguments) => derive::run(&arguments, registry),
        Command::Equal(arguments) => equal::run(&arguments),
        Command::Eval(arguments) => eval::run(&arguments),
        Command::Mutate(arguments) => mutate::run(&arguments, registry),
        Command::Read(arguments) => read::run(&arguments),
    };
    // A reader that closes the pipe early has seen what it wanted.
    let _ = write!(std::io::stdout(), "{}", outcome.output);
    let _ = write!(std::io::stderr(), "{}", outcome.errors);
    ExitCode::from(outcome.code)
}

/// What a command prints and returns.
#[derive(Default)]
struct Outcome {
    output: String,
    errors: String,
    code: u8,
}

impl Outcome {
    /// Something that could not be done.
    fn failed(message: String) -> Outcome {
        Outcome { errors: format!("{message}\n"), code: 2, ..Outcome::default() }
    }
}

/// Whether a stream wants colours.
fn colours(stream: &impl IsTerminal) -> bool {
    stream.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
}
