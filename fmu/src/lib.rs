//! The binary inside exported FMUs: FMI 2.0 and FMI 3.0 for co-simulation, as C functions.
//!
//! A thin interface: every function turns its C arguments into Rust values and hands them to
//! [`cordon_cosim::fmi::slave::Slave`], which holds a unit of the co-simulation (the same code that
//! `cordon cosim` runs) and keeps the rules of the standard. Nothing here knows the protocol, a
//! plant or a controller. One binary serves all kinds of unit: the identifier that the importer
//! passes from `modelDescription.xml` says which one to make.
//!
//! No state is global, so that a process can hold any number of instances. No panic crosses
//! the C boundary: it becomes the status *fatal* of the instance it happened in.
//!
//! What every `unsafe` block here relies on is what the FMI standard obliges the importer to:
//! pointers come from the functions that made them, arrays have the stated lengths, strings end
//! in a zero byte, an instance is used by one thread at a time.

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
    let mut place = 0;
    while place < bytes.len() {
        // Within the array: a constant is computed, or the build fails.
        #[allow(clippy::indexing_slicing)]
        {
            bytes[place] = !bytes[place];
        }
        place += 1;
    }
    bytes
};
