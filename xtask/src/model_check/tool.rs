//! Finding Kani, and the versions that the harnesses are written for.

use std::fmt;
use std::process::{Command, Stdio};

use super::NotRun;

/// The versions of Kani that the harnesses are written for: major and minor.
pub const SUPPORTED: [(u32, u32); 2] = [(0, 67), (0, 68)];

/// How to install it.
const HOW: &str = "install it with `cargo install --locked kani-verifier --version 0.68.0` and \
                   `cargo kani setup`, or set it up with \
                   `cargo run -p cordon-kani --example kani -- setup` (kani/README.md)";

/// The installed Kani.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kani {
    /// Its version, as `0.67.0`.
    pub version: String,
}

impl fmt::Display for Kani {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Kani {}", self.version)
    }
}

impl Kani {
    /// The Kani that `cargo kani` starts, if it is a supported version.
    ///
    /// # Errors
    /// There is none, or another version; the error is the reason.
    pub fn find() -> Result<Self, NotRun> {
        let answer = Command::new("cargo")
            .args(["kani", "--version"])
            .stdin(Stdio::null())
            .stderr(Stdio::null())
            .output();
        let said = match answer {
            Ok(out) if out.status.success() => String::from_utf8_lossy(&out.stdout).into_owned(),
            _ => return Err(NotRun(format!("Kani is not installed: {HOW}"))),
        };
        Self::of(&said)
    }

    /// Parses the output of `cargo kani --version`: `cargo-kani 0.67.0`.
    fn of(said: &str) -> Result<Self, NotRun> {
        let known = SUPPORTED.map(|(major, minor)| format!("{major}.{minor}")).join(" or ");
        let first = said.lines().next().unwrap_or_default().trim();
        let version = first.rsplit(' ').next().unwrap_or_default();
        let mut parts = version.split('.').map(str::parse::<u32>);
        let (Some(Ok(major)), Some(Ok(minor))) = (parts.next(), parts.next()) else {
            return Err(NotRun(format!("`{first}` is not a version of Kani: expected {known}")));
        };
        if !SUPPORTED.contains(&(major, minor)) {
            return Err(NotRun(format!(
                "Kani {version}: the harnesses are written for {known}; {HOW}"
            )));
        }
        Ok(Self { version: version.to_owned() })
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    #[test]
    fn versions_are_read_and_others_refused() {
        assert_eq!(Kani::of("cargo-kani 0.67.0\n").unwrap().version, "0.67.0");
        assert_eq!(Kani::of("cargo-kani 0.68.1").unwrap().to_string(), "Kani 0.68.1");
        for other in ["cargo-kani 0.66.0", "cargo-kani 0.69.0", "cargo-kani 1.67.0"] {
            let NotRun(why) = Kani::of(other).unwrap_err();
            assert!(why.contains("0.67 or 0.68") && why.contains("cargo install"), "{why}");
        }
        for nonsense in ["", "cargo-kani", "kani x.y"] {
            let NotRun(why) = Kani::of(nonsense).unwrap_err();
            assert!(why.contains("is not a version of Kani"), "{why}");
        }
    }
}
