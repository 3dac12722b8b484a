//! `onshell plot`: pictures of a system as SVG.

use clap::ValueEnum;

use crate::formula::text;
use crate::latex::names;
use crate::plot::{self, Kind, Start};
use crate::systems::Registry;
use crate::{Error, Result};

use super::subject::Subject;
use crate::cli::outcome::{Format, Outcome, Screen};
use crate::cli::values;

/// Draws a system as SVG: its motion, its effective potential, the axis of a top
///
/// All parameters are 1, and those of a free body 1, 2 and 3, unless --set gives others. --set also gives the
/// coordinates and rates at the start.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  onshell plot kepler > orbit.svg\n  onshell plot heavy_top --as axis --set '\\dot\\psi=5' > axis.svg"
)]
pub struct Arguments {
    /// The system, e.g. heavy_top, or notes that define a Lagrangian
    system: String,
    /// What to draw
    #[arg(long = "as", value_enum, default_value_t = Picture::Motion, value_name = "PICTURE")]
    picture: Picture,
    /// The value of a parameter, a coordinate or a rate, e.g. '\theta=0.5'
    #[arg(long = "set", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    values: Vec<String>,
    /// The time at which the motion ends
    #[arg(long, default_value_t = 20.0, allow_negative_numbers = true)]
    until: f64,
}

/// A [`Kind`] by the name that it has on the command line.
#[derive(Clone, Copy, ValueEnum)]
enum Picture {
    /// The coordinates against the time
    Motion,
    /// The change of the energy along the integrated motion
    Drift,
    /// The effective potential with the energy and the turning points
    Potential,
    /// The axis of a top: steady precession and three kinds of nutation
    Axis,
    /// The rates of steady precession against the spin
    Rates,
    /// The angular velocity of a free body
    Polhodes,
}

pub(crate) fn run(arguments: &Arguments, registry: &Registry, screen: Screen) -> Outcome {
    match drawn(arguments, registry) {
        Ok(svg) => Outcome::done(svg),
        Err(error) => Outcome::failed(&error, Format::Text, screen),
    }
}

fn drawn(arguments: &Arguments, registry: &Registry) -> Result<String> {
    let system = Subject::of(&arguments.system, registry)?.system;
    // `\dot\theta` and `\dot{\theta}` are one name.
    let named = |name: &str| match names::parse(name) {
        Some((parsed, dots)) => text::with_dots(&parsed.to_string(), dots),
        None => name.to_owned(),
    };
    let setting = |pair: &String| values::setting(pair).map(|(name, value)| (named(name), value));
    let values = arguments.values.iter().map(setting).collect::<Result<Vec<_>>>()?;
    if !arguments.until.is_finite() || arguments.until <= 0.0 {
        return Err(Error::new("--until must be a number above 0").help("write --until 20"));
    }
    let kind = match arguments.picture {
        Picture::Motion => Kind::Motion,
        Picture::Drift => Kind::Drift,
        Picture::Potential => Kind::Potential,
        Picture::Axis => Kind::Axis,
        Picture::Rates => Kind::Rates,
        Picture::Polhodes => Kind::Polhodes,
    };
    plot::picture(kind, &system, &Start::of(&system, &values, arguments.until)?)
}
