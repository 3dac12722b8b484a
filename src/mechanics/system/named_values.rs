//! Parameters and coordinates by name, for callers who do not want to depend on their order.

use super::traced_system::System;
use crate::{Error, Result};

impl System {
    /// The parameters in the order of [`System::parameters`], from pairs of a name in LaTeX and a value in any order.
    ///
    /// ```
    /// use onshell::mechanics::System;
    /// use onshell::systems::Pendulum;
    ///
    /// let pendulum = System::new(&Pendulum::<1>::new())?;
    /// assert_eq!(pendulum.parameter_values(&[("g", 9.8), ("m", 1.0), ("l", 2.0)])?, [1.0, 2.0, 9.8]);
    /// assert!(pendulum.parameter_values(&[("g", 9.8), ("m", 1.0)]).is_err());
    /// # Ok::<(), onshell::Error>(())
    /// ```
    ///
    /// # Errors
    /// When a name is unknown, given twice, or missing.
    pub fn parameter_values<D: Copy>(&self, values: &[(&str, D)]) -> Result<Vec<D>> {
        let all = || format!("the parameters are {}", self.parameters().join(", "));
        let error = |what: String| Error::new(format!("{what} of the system \"{}\"", self.name())).help(all());
        let is_known = |name: &str| self.parameters().iter().any(|known| known == name);
        if let Some((name, _)) = values.iter().find(|(name, _)| !is_known(name)) {
            return Err(error(format!("{name} is not a parameter")));
        }
        let value = |name: &String| {
            let mut given = values.iter().filter(|(known, _)| known == name);
            match (given.next(), given.next()) {
                (Some(&(_, value)), None) => Ok(value),
                (None, _) => Err(error(format!("no value is given for the parameter {name}"))),
                (Some(_), Some(_)) => Err(error(format!("two values are given for the parameter {name}"))),
            }
        };
        self.parameters().iter().map(value).collect()
    }

    /// The index of a coordinate in all slices, by its name in LaTeX.
    pub fn coordinate_index(&self, name: &str) -> Option<usize> {
        self.coordinates().iter().position(|coordinate| coordinate == name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::systems::HeavyTop;

    #[test]
    fn parameters_are_ordered_by_name() {
        let top = System::new(&HeavyTop).unwrap();
        let values = [("R", 5), ("g", 4), ("M", 3), ("\\lambda_3", 2), ("\\lambda_1", 1)];
        assert_eq!(top.parameter_values(&values).unwrap(), [1, 2, 3, 4, 5]);
        assert_eq!((top.coordinate_index("\\psi"), top.coordinate_index("x")), (Some(2), None));
        let message = |values: &[(&str, i32)]| top.parameter_values(values).unwrap_err().message().to_owned();
        assert_eq!(message(&values[1..]), "no value is given for the parameter R of the system \"heavy_top\"");
        let [twice, unknown] = [("R", 6), ("r", 6)].map(|more| message(&[&values[..], &[more]].concat()));
        assert_eq!(twice, "two values are given for the parameter R of the system \"heavy_top\"");
        assert_eq!(unknown, "r is not a parameter of the system \"heavy_top\"");
    }
}
