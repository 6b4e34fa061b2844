//! The forms a trace is shown in: one file a form.

mod csv;
mod itf;
mod json;
mod plot;
mod table;

pub use csv::csv;
pub use itf::itf;
pub use json::json;
pub use plot::plot;
pub use table::table;

use cordon_core::exact::{self, Rational};

/// How numbers are written.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Numbers {
    /// Rounded decimals.
    Decimal,
    /// Exact fractions.
    Fraction,
    /// Both.
    Both,
}

impl Numbers {
    /// One number; with `Both` the fraction follows where it is not the decimal itself.
    fn write(self, x: &Rational, digits: usize) -> String {
        // Long fractions take long to write: only those that are shown.
        match self {
            Self::Decimal => exact::decimal_string(x, digits),
            Self::Fraction => exact::fraction(x),
            Self::Both if x.is_integer() => exact::fraction(x),
            Self::Both => format!("{} = {}", exact::decimal_string(x, digits), exact::fraction(x)),
        }
    }
}
