//! Users' own protocols.
use std::path::Path;

use cordon_check::Verdict;
use cordon_core::system::System;
use cordon_run::protocol::{parse, read};

mod agreement;
mod claims;
mod convergence;
mod mistakes;

fn own(name: &str, agents: Option<usize>) -> System {
    let file = read(Path::new(&format!("scenarios/own/{name}.toml"))).unwrap();
    file.with_agents(agents.unwrap_or(file.agents.fewest())).unwrap()
}

fn system(text: &str) -> System {
    parse("own", text).unwrap().system().unwrap()
}

fn is_valid(certificate: &serde_json::Value) -> bool {
    matches!(cordon_check::check(&certificate.to_string()), Verdict::Valid { .. })
}
