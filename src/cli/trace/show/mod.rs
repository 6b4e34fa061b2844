//! The output formats of a trace: one file each.

mod csv;
mod itf;
mod json;
mod page;
mod plot;
mod table;

pub use csv::csv;
pub use itf::itf;
pub use json::json;
pub use plot::plot;
pub use table::{heading, table};

use cordon_core::exact;
use cordon_run::trace::Positions;

/// How numbers are written.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Numbers {
    /// Decimals, rounded to the places asked for.
    Decimal,
    /// Exact fractions.
    Fraction,
    /// Fractions beside their decimals.
    Both,
}

impl Numbers {
    /// The positions of a row; with `Both` the fraction follows unless it equals the decimal.
    fn write(self, positions: &Positions, digits: usize) -> Vec<String> {
        // Long fractions are slow to format: only those that are shown.
        let fractions = || positions.lowest();
        match self {
            Self::Decimal => positions.decimals(digits),
            Self::Fraction => fractions().iter().map(exact::fraction).collect(),
            Self::Both => {
                let both = |(decimal, x)| match exact::fraction(&x) {
                    whole if x.is_integer() => whole,
                    fraction => format!("{decimal} = {fraction}"),
                };
                positions.decimals(digits).into_iter().zip(fractions()).map(both).collect()
            }
        }
    }
}
