//! The parts of `--help` and completions beyond the flags: examples, limits, files and numbers.

use clap::builder::{PossibleValue, StringValueParser, TypedValueParser, ValueParser};
use clap::{Arg, Command, CommandFactory, ValueHint};

use cordon_spec::theorems::Theorem;

use super::Cli;

/// The command line with its full help.
pub fn command() -> Command {
    completed(Cli::command(), "")
}

/// Examples and limits, by the words of the command.
const EXAMPLES: [(&str, &str); 24] = [
    (
        "trace",
        "Examples:
  cordon trace scenarios/paper.toml --check 7.2
  cordon trace --start 0,10,20,30,100 --eps 1/5 --steps 40 --every 10
  cordon trace scenarios/paper.toml --at 1000,1000000 --engine digits

Limits: 3 to 1,000,000 drones (20,000 with --engine digits), 10,000,000 rows, 10,000 decimal places, exact \
answers of 1 GiB, scenario files of 64 MiB.",
    ),
    (
        "local",
        "Examples:
  cordon local scenarios/paper.toml
  cordon local scenarios/paper.toml --exchange-every 3

Limits: 3 to 1,000,000 drones, 100,000 ticks, 10,000 decimal places.",
    ),
    (
        "swarm",
        "Example:
  cordon swarm --drones 1000000 --steps 1000

Limits: 3 to 100,000,000 drones, 1,000,000,000,000 drone updates.",
    ),
    (
        "cosim",
        "Examples:
  cordon cosim scenarios/paper.toml
  cordon cosim scenarios/faults.toml --out run.csv
  cordon cosim scenarios/paper.toml --format csv | head

Limits: 67,108,864 positions in one run, 10,000,000,000 steps, FMUs of 100,000 files and 1 GiB unpacked.",
    ),
    (
        "separation",
        "Examples:
  cordon separation scenarios/paper.toml
  cordon separation scenarios/paper.toml --wind 1/4 --integrator exact

Limits: coverage without faults or FMUs; certificates of desired positions for up to 198 drones.",
    ),
    (
        "figures",
        "Examples:
  cordon figures
  cordon figures 8,9 --out pictures --format png",
    ),
    (
        "replay",
        "Examples:
  cordon replay scenarios/paper.toml --out page.html
  cordon replay run.csv --out page.html

Limits: run files of 1 GiB; of more than 400,000 positions every second one, or fewer, is shown.",
    ),
    ("fmu", "Example:\n  cordon fmu export plant --out plant.fmu"),
    (
        "fmu export",
        "Examples:
  cordon fmu export plant --out plant.fmu
  cordon fmu export coordination --fmi 3 --positions double --out coordination.fmu",
    ),
    ("theorems", "Examples:\n  cordon theorems\n  cordon theorems 7.2,7.6ii --format json"),
    ("errata", "Examples:\n  cordon errata\n  cordon errata 1,4"),
    (
        "sweep merge",
        "Example:
  cordon sweep merge part-1.jsonl part-2.jsonl --audit 5 --out whole.jsonl

Limits: result files of 1 GiB. Exit codes: as for `cordon sweep`; 2 where files contradict each other.",
    ),
    (
        "sweep status",
        "Example:
  cordon sweep status big

Exit codes: 0 every part is finished, 3 some part is not, 2 no folder of a submitted sweep",
    ),
    (
        "refute",
        "Examples:
  cordon refute 7.2 --drones 4 --eps 3/5
  cordon refute all --drones 3..5
  cordon refute 7.2 --activation --drones 4
  cordon refute --protocol scenarios/own/hasty-coverage.toml

Limits: 3 to 50 drones, 600 positions with those that late messages are about, 1,000 steps, denominators up to \
100, ranges of eps of length 100; numbers of 2,100 characters, which the independent checker reads.",
    ),
    (
        "prove",
        "Examples:
  cordon prove 7.2
  cordon prove all --out certificates
  cordon prove 7.2 --drones 4 --eps 0..1
  cordon prove --protocol scenarios/own/weighted-coverage.toml

Limits: one N up to 1,000,000; protocol files of 4 MiB and 600 state variables, of which up to 200 have to vanish where \
convergence is claimed.",
    ),
    (
        "check",
        "Example:
  cordon check proofs/certificates/*.json

Limits: files of 4 MiB, numbers of 2,100 characters. Exit codes: 0 all valid, 2 no certificate, 3 incomplete, 4 rejected, 74 not read.",
    ),
    (
        "threshold",
        "Examples:
  cordon threshold --property convergence --drones 5 --digits 20
  cordon threshold --property separation --lambda-a 4 --tau 0.05
  cordon threshold --protocol scenarios/own/hasty-coverage.toml

Limits: 3 to 1,000 drones, 1,000 decimal places; of convergence both together as far as the independent \
checker's bound on its work allows (1,000 drones with 400 places, 300 with 1,000). Certificates of the safe side of \
ordering and bound up to 198 drones.",
    ),
    (
        "settle",
        "Examples:
  cordon settle --drones 5 --eps 1/4 --within 0.01
  cordon settle --drones 5 --eps 1/4 --within 0.01 --start 0,1,2,3,5

Limits: 3 to 10,000 drones; 5,000,000 drone updates where runs are executed. Longer ones are jumped over where eps is at most 1/2, and else left undetermined.",
    ),
    ("export", "Example:\n  cordon export smt2 7.2 --drones 4 | z3 -in"),
    (
        "export smt2",
        "Example:
  cordon export smt2 7.2 --drones 3..5 --out steps.smt2

Limits: 3 to 9 drones, 8 steps, answers of 64 MiB.",
    ),
    (
        "export pvs",
        "Example:
  cordon export pvs --scenario scenarios/paper.toml --out pvs
  cordon export pvs --protocol scenarios/own/weighted-coverage.toml --out pvs

Limits: 1,000 drones; of a protocol file 20,000 ends of ranges in the proofs.",
    ),
    (
        "export into-cps",
        "Example:
  cordon export into-cps scenarios/paper.toml --out swarm

Positions travel as doubles unless the scenario or --exchange says otherwise. Limits: 10,000,000,000 steps.",
    ),
    (
        "export ssp",
        "Example:
  cordon export ssp scenarios/paper.toml --out swarm.ssp

Positions travel as doubles unless the scenario or --exchange says otherwise. Limits: 10,000,000,000 steps.",
    ),
    (
        "completions",
        "Example:
  cordon completions bash > ~/.local/share/bash-completion/completions/cordon",
    ),
];

/// The command called `words` and its subcommands, with examples, hints and numbers.
fn completed(command: Command, words: &str) -> Command {
    let command = command.mut_args(hinted).mut_subcommands(|sub| {
        let words = format!("{words} {}", sub.get_name());
        completed(sub, words.trim_start())
    });
    match EXAMPLES.iter().find(|(of, _)| *of == words) {
        None => command,
        Some((_, examples)) => {
            let before = command.get_after_help().map(ToString::to_string);
            let text = before.map_or((*examples).to_owned(), |b| format!("{b}\n\n{examples}"));
            command.after_help(text)
        }
    }
}

fn hinted(arg: Arg) -> Arg {
    let names = arg.get_value_names().unwrap_or_default();
    let hint = match names.first().map(|n| n.as_str()) {
        Some("DIR") => ValueHint::DirPath,
        Some("FILE" | "FILES" | "FILE.fmu" | "RUN" | "SCENARIO" | "PATH") => ValueHint::FilePath,
        _ => ValueHint::Unknown,
    };
    let names_theorems = matches!(arg.get_id().as_str(), "theorems" | "theorem" | "check");
    let is_theorems = names_theorems && arg.get_action().takes_values()
        || names.first().is_some_and(|n| n.as_str() == "NUMBERS") && is_text(&arg);
    // `-1` is a number out of range, not a flag.
    let takes_number = arg.get_action().takes_values() && !arg.is_positional();
    let arg = if takes_number { arg.allow_negative_numbers(true) } else { arg };
    let arg = arg.value_hint(hint);
    if is_theorems {
        arg.value_parser(ValueParser::new(Theorems)).hide_possible_values(true)
    } else {
        arg
    }
}

/// Whether the flag takes a text other than a list of numbers.
fn is_text(arg: &Arg) -> bool {
    arg.get_value_parser().type_id() == std::any::TypeId::of::<String>()
}

/// The parser of lists of theorems: any text is accepted and checked later; completions offer the
/// numbers.
#[derive(Clone)]
struct Theorems;

impl TypedValueParser for Theorems {
    type Value = String;

    fn parse_ref(
        &self,
        command: &Command,
        arg: Option<&Arg>,
        value: &std::ffi::OsStr,
    ) -> Result<String, clap::Error> {
        StringValueParser::new().parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let numbers = Theorem::ALL.iter().map(|t| PossibleValue::new(t.number()));
        Some(Box::new(numbers.chain([PossibleValue::new("all")])))
    }
}
