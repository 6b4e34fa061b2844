//! What a harness is, and the macro that makes one of a body.

use crate::source::{Bytes, Case, Enumerator, Witness};

/// What a harness has to come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expected {
    /// No assertion fails.
    Holds,
    /// Some assertion fails: a counterexample is found (`#[kani::should_panic]`).
    Fails,
}

/// One harness. Every one has a cover, which only a run that the [`Witness`] speaks of meets.
#[derive(Clone, Copy, Debug)]
pub struct Harness {
    /// Path of the proof within this crate: what Kani calls it.
    pub name: &'static str,
    /// Number of the theorem it is about (`7.2`), or what else (`arithmetic`).
    pub subject: &'static str,
    /// What it says.
    pub claim: &'static str,
    /// What it covers.
    pub bounds: fn() -> String,
    /// What it has to come to.
    pub expected: Expected,
    /// The spec's functions that it executes, by path: `coverage::exec_cvg`.
    pub functions: &'static [&'static str],
    /// Its body, on every combination of small values.
    pub exhaustive: fn(&mut Enumerator) -> Case,
    /// Its body, on values read from bytes.
    pub from_bytes: fn(&mut Bytes<'_>) -> Case,
}

/// How the cases of a run ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// An assumption was not met.
    pub discarded: u64,
    /// The assertions were reached, and held.
    pub checked: u64,
    /// Of these: the state that the harness wants seen was.
    pub witnessed: u64,
}

impl Tally {
    /// Counts a case.
    pub fn count(&mut self, case: Case) {
        match case {
            None => self.discarded += 1,
            Some(Witness(seen)) => {
                self.checked += 1;
                self.witnessed += u64::from(seen);
            }
        }
    }
}

impl Harness {
    /// Runs the body on every combination of small values.
    pub fn enumerate(&self) -> Tally {
        let mut tally = Tally::default();
        let mut source = Enumerator::default();
        loop {
            tally.count((self.exhaustive)(&mut source));
            if !source.advance() {
                return tally;
            }
        }
    }
}

/// The text of what a harness without weights covers.
macro_rules! covering {
    ($($part:tt)*) => { || format!($($part)*) };
}

/// Declares harnesses: for each the `#[kani::proof]`, and its entry in the module's `HARNESSES`.
///
/// `unwind` is one more than the longest loop: mostly the number of drones plus one.
macro_rules! harnesses {
    (
        functions $functions:expr;
        $(
            $(#[doc = $claim:literal])+
            $name:ident($subject:literal, unwind $unwind:literal $(, $fails:ident)?):
                $bounds:expr => $body:expr;
        )+
    ) => {
        /// The harnesses of this module.
        pub const HARNESSES: &[$crate::harness::Harness] = &[$(
            $crate::harness::Harness {
                name: $crate::harness::path(concat!(module_path!(), "::", stringify!($name))),
                subject: $subject,
                claim: concat!($($claim),+).trim_ascii(),
                bounds: $bounds,
                expected: harnesses!(@expected $($fails)?),
                functions: $functions,
                exhaustive: $body,
                from_bytes: $body,
            },
        )+];

        $(
            harnesses!(@proof $name $unwind [$($fails)?] $body);
        )+
    };
    (@expected) => { $crate::harness::Expected::Holds };
    (@expected fails) => { $crate::harness::Expected::Fails };
    (@proof $name:ident $unwind:literal [] $body:expr) => {
        #[cfg(kani)]
        #[kani::proof]
        #[kani::unwind($unwind)]
        #[kani::solver(minisat)]
        fn $name() {
            let body: fn(&mut $crate::source::Any) -> $crate::source::Case = $body;
            let case = body(&mut $crate::source::Any);
            kani::cover!(case == Some($crate::source::Witness(true)), "the witness is reached");
        }
    };
    (@proof $name:ident $unwind:literal [fails] $body:expr) => {
        #[cfg(kani)]
        #[kani::proof]
        #[kani::unwind($unwind)]
        #[kani::solver(minisat)]
        #[kani::should_panic]
        fn $name() {
            let body: fn(&mut $crate::source::Any) -> $crate::source::Case = $body;
            let case = body(&mut $crate::source::Any);
            kani::cover!(case == Some($crate::source::Witness(true)), "the witness is reached");
        }
    };
}

pub(crate) use {covering, harnesses};

/// The path below this crate; whole where it is none of this crate's.
pub(crate) const fn path(full: &'static str) -> &'static str {
    match full.as_bytes().split_at_checked("cordon_kani::".len()) {
        Some((_, below)) => match core::str::from_utf8(below) {
            Ok(below) => below,
            Err(_) => full,
        },
        None => full,
    }
}
