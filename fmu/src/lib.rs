//! The binary inside exported FMUs: FMI 2.0 and FMI 3.0 for co-simulation, as C functions.
//!
//! A thin interface: every function converts its C arguments into Rust values and passes them to
//! [`cordon_cosim::fmi::slave::Slave`], which holds a unit of the co-simulation (the same code that
//! `cordon cosim` runs) and enforces the rules of the standard. Nothing here depends on the protocol,
//! the plant or the controller. One binary serves all kinds of units: the identifier that the importer
//! passes from `modelDescription.xml` selects the unit.
//!
//! There is no global state, so a process can hold any number of instances. No panic crosses the C
//! boundary: it becomes the status *fatal* of its instance.
//!
//! Every `unsafe` block here relies on the importer's obligations under the FMI standard: pointers come
//! from the functions that created them, arrays have the stated lengths, strings are zero-terminated,
//! an instance is used by one thread at a time.

// The names are the standard's.
#![allow(non_snake_case)]

use cordon_cosim::fmi::interface::BINARY_MARK;

mod component;
mod convert;
mod fmi2;
mod fmi3;
mod fmi3_unsupported;

/// The complement of [`BINARY_MARK`].
#[unsafe(no_mangle)]
pub static CORDON_FMU: [u8; BINARY_MARK.len()] = {
    let mut bytes = [0; BINARY_MARK.len()];
    bytes.copy_from_slice(BINARY_MARK.as_bytes());
    let mut index = 0;
    while index < bytes.len() {
        // Within the array: this is evaluated at compile time, or the build fails.
        #[allow(clippy::indexing_slicing)]
        {
            bytes[index] = !bytes[index];
        }
        index += 1;
    }
    bytes
};
