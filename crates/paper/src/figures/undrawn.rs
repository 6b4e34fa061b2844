//! A replacement for the drawing code in a build without the feature `figures`.

use super::{Format, Plot};
use cordon_core::{Error, Result};

impl Plot {
    /// Nothing is drawn.
    ///
    /// # Errors
    /// Always; the message says which build has figures.
    pub(super) fn drawn(&self, _: Format) -> Result<Vec<u8>> {
        Err(missing())
    }
}

pub(super) fn missing() -> Error {
    Error::input(
        "figures: this build draws none: `cargo run --release --features figures -- figures` \
         has them",
    )
}
