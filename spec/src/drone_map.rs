//! Maps from drone identifiers to values: the paper's `dmap` (Listing 3).

#[cfg(feature = "contracts")]
#[allow(unused_imports)] // the erased macros swallow each other's attributes
use creusot_contracts::prelude::{ensures, requires};

/// A map from drone identifiers `0 .. N-1` to values.
///
/// The paper builds such a map with `LAMBDA (i: drone_id): ...`; so does [`lambda`]. Arrays
/// `[T; N]` need no heap (the model checker wants that); with the feature `alloc`, `Vec<T>`
/// serves where N is known at run time only.
///
/// [`lambda`]: DroneMap::lambda
pub trait DroneMap<T>: AsRef<[T]> + Sized {
    /// The map `i -> f(i)` over the same drone identifiers as `self`.
    #[cfg_attr(feature = "contracts", ensures(result.as_ref()@.len() == self.as_ref()@.len()))]
    fn lambda(&self, f: impl FnMut(usize) -> T) -> Self;

    /// The number of drones N.
    #[cfg_attr(feature = "contracts", ensures(result@ == self.as_ref()@.len()))]
    fn count(&self) -> usize {
        self.as_ref().len()
    }
}

impl<T, const N: usize> DroneMap<T> for [T; N] {
    fn lambda(&self, f: impl FnMut(usize) -> T) -> Self {
        core::array::from_fn(f)
    }
}

#[cfg(feature = "alloc")]
impl<T> DroneMap<T> for alloc::vec::Vec<T> {
    fn lambda(&self, f: impl FnMut(usize) -> T) -> Self {
        (0..self.len()).map(f).collect()
    }
}
