//! The typeface of the figures, embedded so that they look the same on every machine.

use std::sync::OnceLock;

use plotters::style::FontStyle;
use plotters::style::register_font;

use cordon_core::{Error, Result};

/// Its name in the figures. An SVG viewer without it uses its default sans-serif font.
pub(super) const NAME: &str = "sans-serif";

/// Registers the typeface with the plotting library, once.
pub(super) fn register() -> Result<()> {
    static DONE: OnceLock<bool> = OnceLock::new();
    let done = DONE.get_or_init(|| {
        let bytes = epaint_default_fonts::UBUNTU_LIGHT;
        [FontStyle::Normal, FontStyle::Bold]
            .into_iter()
            .all(|style| register_font(NAME, style, bytes).is_ok())
    });
    if *done { Ok(()) } else { Err(Error::internal("figures: the embedded typeface is damaged")) }
}
