//! `onshell derive`: what follows from a Lagrangian, as formulas.

use clap::ValueEnum;

use crate::derive::{Derivation, Equation, Quantity};
use crate::lecture::{self, Lecture};
use crate::page;
use crate::plot;
use crate::report::wrap;
use crate::systems::Registry;
use crate::{Error, Result};

use super::subject::Subject;
use crate::cli::outcome::{Format, Outcome, Screen};
use crate::cli::values;

/// Prints what follows from the Lagrangian of a system, or of notes
///
/// Without --as, it prints the Lagrangian, the momenta and the Euler–Lagrange equations. With --steps it prints the way
/// there, each line certified against those before it, with its value at a sampled state.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  onshell derive heavy_top --as hamiltonian\n  onshell derive heavy_top --steps\n  onshell derive notes.md --steps\n  \
                  onshell derive heavy_top --steps --format latex > top.md"
)]
pub struct Arguments {
    /// The system, e.g. heavy_top, or notes that define a Lagrangian
    system: String,
    /// What to derive
    #[arg(long = "as", value_enum, value_name = "QUANTITY")]
    quantity: Option<Wanted>,
    /// Print the derivation line by line, from the parts of the system on
    #[arg(long, conflicts_with = "quantity")]
    steps: bool,
    /// The seed of the sampled states of --steps
    #[arg(long, default_value_t = 1, requires = "steps", allow_negative_numbers = true, value_parser = values::seed)]
    seed: u64,
    /// The form of the output
    #[arg(long, value_enum, default_value_t = Form::Text)]
    format: Form,
}

/// A [`Quantity`] by the name that it has on the command line.
#[derive(Clone, Copy, ValueEnum)]
enum Wanted {
    Lagrangian,
    Momenta,
    EulerLagrange,
    Energy,
    Hamiltonian,
    Hamilton,
    Accelerations,
    MassMatrix,
}

/// How the equations are written.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Form {
    /// For people, no wider than the terminal
    Text,
    /// LaTeX that onshell reads, one equation a line
    Latex,
    /// For programs: the name, the LaTeX and the text of each equation
    Json,
    /// The source of a Rust function that computes the accelerations
    Rust,
    /// With --steps: a page to read in a browser
    Html,
}

impl Wanted {
    fn quantity(self) -> Quantity {
        match self {
            Wanted::Lagrangian => Quantity::Lagrangian,
            Wanted::Momenta => Quantity::Momenta,
            Wanted::EulerLagrange => Quantity::EulerLagrange,
            Wanted::Energy => Quantity::Energy,
            Wanted::Hamiltonian => Quantity::Hamiltonian,
            Wanted::Hamilton => Quantity::Hamilton,
            Wanted::Accelerations => Quantity::Accelerations,
            Wanted::MassMatrix => Quantity::MassMatrix,
        }
    }
}

pub(crate) fn run(arguments: &Arguments, registry: &Registry, screen: Screen) -> Outcome {
    let format = if arguments.format == Form::Json { Format::Json } else { Format::Text };
    if arguments.steps {
        return match steps(arguments, registry, screen.out.width) {
            Ok((output, code)) => Outcome { output, code, ..Outcome::default() },
            Err(error) => Outcome::failed(&error, format, screen),
        };
    }
    match derived(arguments, registry, screen.out.width) {
        Ok(output) => Outcome::done(output),
        Err(error) => Outcome::failed(&error, format, screen),
    }
}

/// The derivation line by line, and the exit code.
fn steps(arguments: &Arguments, registry: &Registry, width: usize) -> Result<(String, u8)> {
    let subject = Subject::of(&arguments.system, registry)?;
    let lecture = Lecture::new(&subject.system, &subject.derivation()?, arguments.seed)?;
    let output = match arguments.format {
        Form::Text => lecture::text::text(&lecture, width),
        Form::Latex => lecture.notes.clone(),
        Form::Json => format!("{:#}\n", lecture::json::value(&lecture)),
        Form::Html => page::lecture(&lecture, &plot::gallery(&subject.system)),
        Form::Rust => {
            return Err(Error::new("the steps cannot be written as Rust").help("leave out --steps, or --format"));
        }
    };
    Ok((output, lecture.exit_code()))
}

fn derived(arguments: &Arguments, registry: &Registry, width: usize) -> Result<String> {
    let system = Subject::of(&arguments.system, registry)?.system;
    if arguments.format == Form::Rust {
        return match arguments.quantity {
            None | Some(Wanted::Accelerations) => Ok(system.rust_source()),
            Some(_) => Err(Error::new("only the accelerations can be written as Rust").help("leave out --as")),
        };
    }
    if arguments.format == Form::Html {
        return Err(Error::new("only the steps of a derivation are written as a page").help("add --steps"));
    }
    let derivation = Derivation::new(&system)?;
    let usual = [Quantity::Lagrangian, Quantity::Momenta, Quantity::EulerLagrange];
    let wanted = arguments.quantity.map_or(usual.to_vec(), |wanted| vec![wanted.quantity()]);
    let mut equations = Vec::new();
    for quantity in wanted {
        equations.extend(derivation.equations(quantity)?);
    }
    let lines = |spell: &dyn Fn(&Equation) -> String| {
        equations.iter().map(|equation| spell(equation) + "\n").collect::<String>()
    };
    Ok(match arguments.format {
        Form::Text => lines(&|equation| wrap("", &derivation.text(equation), 4, width)),
        Form::Latex => lines(&|equation| derivation.latex(equation)),
        Form::Json => {
            let each = |equation: &Equation| {
                serde_json::json!({
                    "name": equation.name,
                    "latex": derivation.latex(equation),
                    "text": derivation.text(equation),
                })
            };
            let output = serde_json::json!({
                "system": system.name(),
                "coordinates": system.coordinates(),
                "parameters": system.parameters(),
                "equations": equations.iter().map(each).collect::<Vec<_>>(),
            });
            format!("{output:#}\n")
        }
        Form::Rust | Form::Html => system.rust_source(),
    })
}
