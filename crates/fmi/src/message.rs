//! Orders to an instance, and its replies.

use std::io::{self, Read, Write};

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::fmu::{Datum, Fmu, Variable};

/// What an instance is asked to do.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Order {
    /// Load the binary and make the instance: the first order.
    Load(Fmu),
    /// Begin at time 0; from here on every reply has the values of these outputs.
    Initialise(Beginning),
    /// Advance. The values are those of the inputs, in the order given at initialisation.
    Step {
        /// Beginning of the step, in seconds.
        from: f64,
        /// Length of the step, in seconds.
        size: f64,
        /// Values of the inputs.
        inputs: Vec<Datum>,
    },
    /// Terminate and free the instance: the last order.
    Finish,
}

/// The variables and values at the beginning of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Beginning {
    /// Parameters with their values.
    pub parameters: Vec<(Variable, Datum)>,
    /// Inputs, in the order of their values in steps, with their values before the first step.
    pub inputs: Vec<(Variable, Datum)>,
    /// Outputs, in the order of their values in replies.
    pub outputs: Vec<Variable>,
    /// End of the run in seconds.
    pub stop: f64,
}

/// The result of an order: values of the outputs, or why it failed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reply {
    /// Values of the outputs, after the initialisation and after steps.
    pub result: Result<Vec<Datum>, String>,
    /// Further notes for the user: warnings, discarded values.
    pub notes: Vec<String>,
}

impl Reply {
    /// A failure without further notes.
    pub fn failed(why: String) -> Self {
        Self { result: Err(why), notes: Vec::new() }
    }
}

/// Typical size of the message of a step, in bytes.
const USUAL: usize = 512;

/// Longest message in bytes: anything longer is not one of ours.
const LONGEST: u32 = 1 << 26;

/// Writes a message: its length, then its bytes.
pub(crate) fn write(stream: &mut impl Write, message: &impl Serialize) -> io::Result<()> {
    // The length goes into the first four bytes, so that there is one write per message.
    let mut bytes = Vec::with_capacity(USUAL);
    bytes.extend([0; 4]);
    let mut bytes = postcard::to_extend(message, bytes).map_err(io::Error::other)?;
    let length = u32::try_from(bytes.len() - 4).ok().filter(|l| *l <= LONGEST);
    let length = length.ok_or_else(|| io::Error::other("a message that is too long"))?;
    if let Some(head) = bytes.first_chunk_mut::<4>() {
        *head = length.to_le_bytes();
    }
    stream.write_all(&bytes)
}

/// Reads a message written by [`write`].
pub(crate) fn read<T: DeserializeOwned>(stream: &mut impl Read) -> io::Result<T> {
    let mut head = [0; 4];
    stream.read_exact(&mut head)?;
    let length = u32::from_le_bytes(head);
    if length > LONGEST {
        return Err(io::Error::other("a message that is too long"));
    }
    let mut bytes = vec![0; usize::try_from(length).map_err(io::Error::other)?];
    stream.read_exact(&mut bytes)?;
    postcard::from_bytes(&bytes).map_err(io::Error::other)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    #[test]
    fn messages_come_back_to_the_last_bit_and_a_cut_one_is_refused() {
        let values = [0.1 + 0.2, -0.0, f64::INFINITY, f64::MIN_POSITIVE / 4.0].map(Datum::Real);
        let order = Order::Step { from: 1.05, size: 0.05, inputs: values.to_vec() };
        let mut bytes = Vec::new();
        write(&mut bytes, &order).unwrap();
        assert_eq!(read::<Order>(&mut bytes.as_slice()).unwrap(), order);
        let cut = bytes.get(..bytes.len() - 1).unwrap();
        let failed = read::<Order>(&mut &*cut).unwrap_err();
        assert_eq!(failed.kind(), io::ErrorKind::UnexpectedEof);
        assert!(read::<Order>(&mut [0xff; 8].as_slice()).is_err());
    }
}
