//! Maps from drone identifiers to values: the paper's `dmap` (Listing 3).

#[cfg(feature = "contracts")]
use crate::model::*;

/// A map from drone identifiers `0 .. N-1` to values.
///
/// The paper builds such a map with `LAMBDA (i: drone_id): ...`; so does [`lambda`]. Arrays
/// `[T; N]` need no heap (the model checker wants that); with the feature `alloc`, `Vec<T>`
/// serves where N is known at run time only.
///
/// [`lambda`]: DroneMap::lambda
pub trait DroneMap<T>: AsRef<[T]> + Sized {
    /// The values in the order of the identifiers, for the contracts.
    #[cfg(feature = "contracts")]
    #[logic]
    fn seq(self) -> Seq<T>;

    /// `as_ref` gives these values.
    #[cfg(feature = "contracts")]
    #[logic(law)]
    #[requires(inv(self))]
    #[ensures(self.seq().len() <= usize::MAX@)]
    #[ensures(forall<r: &[T]> <Self as AsRef<[T]>>::as_ref.postcondition_once((&self,), r) ==> r@ == self.seq())]
    fn as_ref_is_seq(self);

    /// The map `i -> f(i)` over the same drone identifiers as `self`.
    #[cfg_attr(feature = "contracts", requires(forall<i: usize> i@ < self.seq().len() ==> f.precondition((i,))))]
    #[cfg_attr(feature = "contracts", ensures(lists(f, self.seq().len(), result.seq())))]
    fn lambda(&self, f: impl Fn(usize) -> T) -> Self;

    /// The number of drones N.
    #[cfg_attr(feature = "contracts", ensures(result@ == self.seq().len()))]
    fn count(&self) -> usize {
        #[cfg(creusot)]
        proof_assert!({
            self.as_ref_is_seq();
            true
        });
        self.as_ref().len()
    }
}

impl<T, const N: usize> DroneMap<T> for [T; N] {
    #[cfg(feature = "contracts")]
    #[logic(open)]
    fn seq(self) -> Seq<T> {
        View::view(self)
    }

    #[cfg(feature = "contracts")]
    #[logic(law)]
    #[requires(inv(self))]
    #[ensures(self.seq().len() <= usize::MAX@)]
    #[ensures(forall<r: &[T]> <Self as AsRef<[T]>>::as_ref.postcondition_once((&self,), r) ==> r@ == self.seq())]
    fn as_ref_is_seq(self) {}

    #[cfg_attr(feature = "contracts", requires(forall<i: usize> i@ < N@ ==> f.precondition((i,))))]
    #[cfg_attr(feature = "contracts", ensures(lists(f, N@, result.seq())))]
    fn lambda(&self, f: impl Fn(usize) -> T) -> Self {
        core::array::from_fn(f)
    }
}

#[cfg(feature = "alloc")]
impl<T> DroneMap<T> for alloc::vec::Vec<T> {
    fn lambda(&self, f: impl Fn(usize) -> T) -> Self {
        (0..self.len()).map(f).collect()
    }
}
