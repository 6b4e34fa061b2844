//! `--protocol FILE` of the commands that decide: a user's own protocol.

mod convergence;
mod every_number;
mod flow;
mod page;
mod prove;
mod refute;
mod settle;
mod show;
mod sweep;
mod theorems;
mod threshold;

use std::path::{Path, PathBuf};

pub use flow::prove as prove_flow;
pub use prove::prove;
pub use refute::{DENOMINATORS, Search, refute};
pub use settle::settle;
pub use sweep::{Extent, sweep};
pub use theorems::theorems;
pub use threshold::{Asked, threshold};

use super::table::abridged;
use cordon_core::exact::shortened;
use cordon_core::system::{Flow, Parameter, ParameterKind, System};
use cordon_core::text::shell_word;
use cordon_core::{Error, Rational, Result, range};
use cordon_proof::claims;
use cordon_run::protocol::{Family, ProtocolFile, read};

/// A protocol file, and what of it is fixed.
#[derive(clap::Args, Clone, Debug, Default)]
pub struct ProtocolArgs {
    /// The claims of a protocol of your own instead (TOML, see `scenarios/own/`)
    #[arg(long, value_name = "FILE", help_heading = "Own protocol")]
    pub protocol: Option<PathBuf>,
    /// Of a protocol for any number of agents, this number [default: in `prove` every number, else the
    /// fewest]
    #[arg(long, value_name = "N", help_heading = "Own protocol")]
    pub agents: Option<usize>,
    /// A parameter's value or range in the place of the file's: `eps=1/3`, `gain=0..2`
    #[arg(
        long,
        value_name = "NAME=X|LO..HI",
        allow_hyphen_values = true,
        help_heading = "Own protocol"
    )]
    pub set: Vec<String>,
}

/// How many more agents than the fewest a start is looked for with, where claims are about every number.
const MORE_AGENTS: usize = 8;

impl ProtocolArgs {
    /// The file and its system, where one is named.
    ///
    /// # Errors
    /// The file is wrong, a parameter is not there, or no start meets the assumptions.
    pub fn system(&self) -> Result<Option<(ProtocolFile, System)>> {
        let Some(path) = &self.protocol else { return Ok(None) };
        let file = opened(path)?;
        let system = self.sized(&file, self.agents.unwrap_or(file.agents.fewest()))?;
        expect_claim(&file, &system)?;
        expect_start(&file, &system, "")?;
        Ok(Some((file, system)))
    }

    /// The system in continuous time, where a file of one is named.
    ///
    /// # Errors
    /// As for [`system`](Self::system).
    pub fn flow(&self) -> Result<Option<(ProtocolFile, Flow)>> {
        let Some(path) = &self.protocol else { return Ok(None) };
        let file = opened(path)?;
        if !file.is_continuous {
            return Ok(None);
        }
        let mut flow = file.flow(self.agents.unwrap_or(file.agents.fewest()))?;
        self.narrow(&mut flow.system.parameters)?;
        expect_claim(&file, &flow.system)?;
        Ok(Some((file, flow)))
    }

    /// The system of a file with so many agents.
    ///
    /// # Errors
    /// The file is wrong, or a parameter is not there.
    fn sized(&self, file: &ProtocolFile, agents: usize) -> Result<System> {
        let mut system = file.with_agents(agents)?;
        self.narrow(&mut system.parameters)?;
        Ok(system)
    }

    /// The parameters with the values and ranges of `--set`.
    fn narrow(&self, parameters: &mut [Parameter]) -> Result<()> {
        for (index, set) in self.set.iter().enumerate() {
            let (name, values) = set.split_once('=').ok_or_else(|| {
                Error::input(format!(
                    "set: `{}`: expected a parameter and its value, like `eps=1/3`",
                    shortened(set)
                ))
            })?;
            let (low, high) = range::closed(&format!("set: {}", shortened(name)), values)?;
            let again = |other: &String| other.split_once('=').is_some_and(|(n, _)| n == name);
            if self.set.iter().take(index).any(again) {
                let name = shortened(name);
                return Err(Error::input(format!("set: `{name}` occurs twice: expected it once")));
            }
            let known: Vec<&str> = parameters.iter().map(|p| p.name.as_str()).collect();
            let among = match known.as_slice() {
                [] => "none: the file has no parameters".to_owned(),
                _ => format!("one of {}", abridged_words(&known)),
            };
            let unknown =
                format!("set: `{}` is not a parameter: expected {among}", shortened(name));
            match parameters.iter_mut().find(|p| p.name == name) {
                Some(p) => (p.low, p.high) = (low, high),
                None => return Err(Error::input(unknown)),
            }
        }
        Ok(())
    }

    /// The system with its claims up to a step, and none of later ones; with the number of agents that it has.
    ///
    /// # Errors
    /// There is no claim about these steps, or they are too many.
    pub fn up_to(
        &self,
        file: &ProtocolFile,
        mut system: System,
        last: usize,
    ) -> Result<(Self, System)> {
        let most = claims::PROOF.steps;
        if last >= most {
            return Err(Error::input(format!("steps: `{last}`: expected less than {most}")));
        }
        if system.claims.is_empty() {
            return Err(self.misses("claims", "`claims`: it has `converges` only"));
        }
        system.claims.retain(|claim| claim.from <= last);
        if system.claims.is_empty() {
            return Err(Error::input(format!(
                "steps: `{last}`: expected more, since no claim is about a step up to that"
            )));
        }
        for claim in &mut system.claims {
            claim.until = Some(claim.until.map_or(last, |until| until.min(last)));
        }
        system.converges = None;
        let agents = if file.is_family() { Some(system.agents) } else { self.agents };
        Ok((Self { agents, ..self.clone() }, system))
    }

    /// The family of a protocol for every number of agents, where no number is named; or why there is
    /// none.
    ///
    /// # Errors
    /// The file is wrong, a parameter is not there, or no start of some more agents than the fewest meets the assumptions.
    fn family(&self, file: &ProtocolFile) -> Result<Option<std::result::Result<Family, String>>> {
        if self.agents.is_some() || !file.is_family() {
            return Ok(None);
        }
        // What is proved of every number is empty where there are no starts.
        let fewest = file.agents.fewest();
        for more in fewest + 1..=fewest + MORE_AGENTS {
            expect_start(file, &self.sized(file, more)?, &format!(" of {more} agents"))?;
        }
        let mut parameters = file.parameters()?;
        self.narrow(&mut parameters)?;
        file.family(&parameters).map(Some)
    }

    /// The error where the file does not have a key that a command is about.
    fn misses(&self, key: &str, expected: &str) -> Error {
        Error::input(format!("{}: {key}: none: expected {expected}", self.path().display()))
    }

    fn path(&self) -> &Path {
        self.protocol.as_deref().unwrap_or(Path::new(""))
    }

    /// The flags that name this system again.
    fn flags(&self, system: &System) -> String {
        // What begins with a dash would be taken for a flag.
        let path = self.path();
        let path = if path.as_os_str().as_encoded_bytes().starts_with(b"-") {
            Path::new(".").join(path)
        } else {
            path.to_owned()
        };
        let mut flags = format!("--protocol {}", shell_word(&path.display().to_string()));
        if let Some(n) = self.agents {
            flags += &format!(" --agents {n}");
        }
        // Constants are named with the values of the run; what varies keeps the range that it was given.
        let varies = |name: &str| {
            let kind = system.parameters.iter().find(|p| p.name == name).map(|p| p.kind);
            kind.is_some_and(|kind| kind != ParameterKind::Constant)
        };
        for set in self.set.iter().filter(|s| s.split_once('=').is_some_and(|(n, _)| varies(n))) {
            flags += &format!(" --set {}", shell_word(set));
        }
        flags
    }
}

/// Reads a protocol file; elsewhere the flag also takes the name of a built-in protocol.
fn opened(path: &Path) -> Result<ProtocolFile> {
    let name = path.to_string_lossy();
    match ["coverage", "consensus", "formation"].contains(&name.as_ref()) && !path.exists() {
        true => Err(Error::input(format!(
            "protocol: `{name}`: expected a protocol file here; without --protocol this command is about \
             the built-in coverage"
        ))),
        false => read(path),
    }
}

/// A file without claims can be run; there is nothing in it to decide.
fn expect_claim(file: &ProtocolFile, system: &System) -> Result<()> {
    match system.claims.is_empty() && system.converges.is_none() {
        true => Err(file.error("claims", "none: expected `claims` or `converges`")),
        false => Ok(()),
    }
}

/// Some start meets the assumptions.
fn expect_start(file: &ProtocolFile, system: &System, agents: &str) -> Result<()> {
    if !claims::is_vacuous(system) {
        return Ok(());
    }
    let (key, assumptions) = match file.has_start() {
        true => ("start", "the assumptions"),
        false => ("claims", "the claims, which are assumed where `start` is left out"),
    };
    Err(file.error(key, &format!("no start{agents} meets {assumptions}: expected one that does")))
}

fn abridged_words(words: &[&str]) -> String {
    match words {
        [] => "none".to_owned(),
        _ => abridged(&words.iter().map(|w| (*w).to_owned()).collect::<Vec<_>>()),
    }
}

/// The whole state of a start that the assumptions allow.
fn assumed(system: &System, start: &[Rational]) -> Result<Vec<Rational>> {
    let state = system.at_rest(start).ok_or_else(|| {
        Error::input(format!(
            "start: {} numbers: expected {}, one a state variable: {}",
            start.len(),
            system.state.len() - system.past.len(),
            abridged(&system.state)
        ))
    })?;
    match system.starts.iter().find(|p| !p.holds(&state)) {
        Some(broken) => Err(Error::input(format!(
            "start: does not meet `{}`: expected a start that the protocol assumes",
            broken.text
        ))),
        None => Ok(state),
    }
}
