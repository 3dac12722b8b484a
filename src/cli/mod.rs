//! The command line: arguments to calls, and results to output and exit codes. No mathematics.
//!
//! Each command is a file, takes its arguments, and returns an [`Outcome`]: what to print and the exit code. Nothing is
//! printed before a command is done, but the line of progress and the question that `--fix` asks. It may know all other
//! folders; `main` alone may know it.
//!
//! Exit codes of every command: 0 when all is as it should be, 1 when something is wrong, 2 when something could not be
//! checked, read or written.
//!
//! Offers `run`, the whole command.

mod check;
mod equal;
mod eval;
mod explain;
mod files;
mod fix;
mod init;
mod mark;
mod mutate;
mod outcome;
mod pages;
mod progress;
mod read;
mod schema;
mod system;
mod terminal;
mod values;

use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

use crate::parallel::on_deep_stacks;
use crate::systems::Registry;

use outcome::Outcome;
use pages::{report, watch};
use system::{derive, plot};

/// Checks the equations in physics notes against what automatic differentiation derives.
#[derive(Parser)]
#[command(
    version,
    about,
    after_help = "Exit codes: 0 all is as expected, 1 something is wrong, 2 something could not be checked.\n\n\
                  Example:\n  onshell check notes.md"
)]
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
    Explain(explain::Arguments),
    Init(init::Arguments),
    Mark(mark::Arguments),
    Mutate(mutate::Arguments),
    Plot(plot::Arguments),
    Read(read::Arguments),
    Report(report::Arguments),
    Schema(schema::Arguments),
    Watch(watch::Arguments),
}

/// The command, with the systems in the help of the subcommands that take one.
fn with_systems(command: clap::Command, registry: &Registry) -> clap::Command {
    let systems = format!("Systems: {}", registry.names().collect::<Vec<_>>().join(", "));
    ["derive", "plot"].into_iter().fold(command, |command, name| {
        command.mut_subcommand(name, |subcommand| {
            let examples = subcommand.get_after_help().map(ToString::to_string).unwrap_or_default();
            subcommand.after_help(format!("{examples}\n\n{systems}"))
        })
    })
}

/// Runs the command that the program was started with, with the systems of a registry.
///
/// A crate with systems of its own calls this from its `main` with its own registry, and so has the whole command.
pub fn run(registry: &Registry) -> ExitCode {
    let screen = terminal::screen();
    let command = with_systems(Arguments::command(), registry).term_width(screen.out.width);
    let parsed = command.try_get_matches().and_then(|matches| Arguments::from_arg_matches(&matches));
    let outcome = on_deep_stacks(|| match parsed.map(|arguments| arguments.command) {
        Ok(Command::Check(arguments)) => check::run(&arguments, registry, screen),
        Ok(Command::Derive(arguments)) => derive::run(&arguments, registry, screen),
        Ok(Command::Equal(arguments)) => equal::run(&arguments, screen),
        Ok(Command::Eval(arguments)) => eval::run(&arguments, screen),
        Ok(Command::Explain(arguments)) => explain::run(&arguments, screen),
        Ok(Command::Init(arguments)) => init::run(&arguments, registry, screen),
        Ok(Command::Mark(arguments)) => mark::run(&arguments, registry, screen),
        Ok(Command::Mutate(arguments)) => mutate::run(&arguments, registry, screen),
        Ok(Command::Plot(arguments)) => plot::run(&arguments, registry, screen),
        Ok(Command::Read(arguments)) => read::run(&arguments, screen),
        Ok(Command::Report(arguments)) => report::run(&arguments, registry, screen),
        Ok(Command::Schema(arguments)) => schema::run(&arguments),
        Ok(Command::Watch(arguments)) => watch::run(&arguments, registry, screen),
        // Help and the version are no failure.
        Err(help) if !help.use_stderr() => Outcome::done(help.render().to_string()),
        Err(error) => Outcome { messages: error.render().to_string(), code: 2, ..Outcome::default() },
    });
    outcome.write(std::io::stdout(), std::io::stderr())
}
