//! FMUs of other tools: loading them and calling them, FMI 2.0 and 3.0 for co-simulation.
//!
//! An [`Fmu`](fmu::Fmu) is an unpacked archive with what its model description says; an
//! [`Instance`](instance::Instance) of it is called in this process. Foreign code may crash, hang
//! or end the process it runs in: a [`Remote`](remote::Remote) has the instance in a child process
//! whose program calls [`host::serve`]. Both take the same [`Order`](message::Order)s.
//!
//! Nothing here knows drones, units or scenarios.

mod c;
pub mod fmu;
pub mod host;
pub mod instance;
mod library;
mod log;
pub mod message;
#[cfg(unix)]
pub mod remote;
