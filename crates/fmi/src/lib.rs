//! FMUs of other tools: loading and calling them, for FMI 2.0 and 3.0 co-simulation.
//!
//! An [`Fmu`](fmu::Fmu) is an unpacked archive with the data of its model description; an
//! [`Instance`](instance::Instance) of it runs in this process. Foreign code may crash, hang or end the
//! process it runs in: a [`Remote`](remote::Remote) has the instance in a child process whose program
//! calls [`host::serve`]. Both take the same [`Order`](message::Order)s.
//!
//! Nothing here depends on drones, units or scenarios.

mod c;
pub mod fmu;
pub mod host;
pub mod instance;
mod library;
mod log;
pub mod message;
#[cfg(unix)]
pub mod remote;
