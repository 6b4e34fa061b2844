//! What to run, from a TOML file or from flags: [`scenario`]s, and the [`protocol`]s of users.

pub mod protocol;
pub mod scenario;
