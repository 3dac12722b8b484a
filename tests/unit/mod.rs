//! Tests of what is not public: reading, printing, documents, derived formulas, units.
//!
//! They stand here and not in `src`, because they are long; they are compiled into the library's own test binary.

mod derivative;
mod derive;
mod notes;
mod printing;
mod reading;
mod snippets;
mod units;
mod values;
