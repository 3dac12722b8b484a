//! How often a mark such as d stands before a name, and alone.

use crate::formula::symbols::Name;

#[derive(Default)]
pub(super) struct Marks {
    pub(super) names: Vec<Name>,
    pub(super) alone: bool,
    pub(super) upright: bool,
    /// How often it stands before a logarithm. One of them may be a product, `d\ln 2`; two are changes, `d\ln p = \gamma\,d\ln\rho`.
    pub(super) logarithms: usize,
}

impl Marks {
    pub(super) fn are_sure(&self, least: usize) -> bool {
        let known = self.names.len() + self.logarithms / 2;
        !self.alone && (known >= least || self.upright && known + self.logarithms > 0)
    }

    pub(super) fn note(&mut self, name: Option<Name>) {
        match name {
            Some(name) if !self.names.contains(&name) => self.names.push(name),
            Some(_) => {}
            None => self.alone = true,
        }
    }
}
