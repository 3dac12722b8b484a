//! The `onshell` command: arguments in, exit code out.

use std::process::ExitCode;

use onshell::systems::Registry;

fn main() -> ExitCode {
    onshell::cli::run(&Registry::standard())
}
