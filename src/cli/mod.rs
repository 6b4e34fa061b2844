//! The command line: one file per command, each a thin layer over the library.
//!
//! stdout carries the result only; progress and diagnostics go to stderr.

mod certificates;
mod check;
mod choice;
mod cosim;
pub mod edge;
mod errata;
mod export;
mod figures;
mod fmu;
pub mod help;
mod local;
mod moved;
mod own_protocol;
pub mod progress;
mod prove;
pub mod refute;
mod replay;
pub mod scenario_args;
pub mod select;
mod separation;
mod settle;
mod setup;
mod swarm;
mod sweep;
mod table;
mod theorems;
mod threshold;
mod trace;

use std::io::Write;

use clap::{Parser, Subcommand};

use cordon_core::{Outcome, Result};

/// Verification toolkit for a drone coverage protocol: one executable spec, simulated, swept
/// and proved.
#[derive(Parser, Debug)]
#[command(name = "cordon", version, about, long_about = None, after_help = EXIT_CODES)]
pub struct Cli {
    /// The command to run.
    #[command(subcommand)]
    pub command: Command,
}

const EXIT_CODES: &str = "Exit codes: 0 holds or done, 1 refuted, 2 bad usage or input, \
                          3 inconclusive or not run, 4 certificate rejected, 70 internal fault, 74 I/O error";

/// The program's commands.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Print the trace of a scenario: the placement after every protocol step or tick
    Trace(Box<trace::Args>),
    /// Run N local machines that exchange positions and compare with the global protocol
    Local(Box<local::Args>),
    /// Run a very large swarm in doubles, with a proved bound of the error
    Swarm(swarm::Args),
    /// Fly the scenario: plant, controller and coordination of every drone, co-simulated
    Cosim(Box<cosim::Args>),
    /// Certify how close two drones ever come in flight, between the samples too
    Separation(Box<separation::Args>),
    /// Draw the paper's figures 8 to 16 from new runs
    Figures(figures::Args),
    /// Write a run as one HTML page to look at: play, pause, scrub, collisions marked
    Replay(Box<replay::Args>),
    /// Write the units of the co-simulation as FMUs
    Fmu(Box<fmu::Args>),
    /// List the theorems: hypotheses and conclusions, in the paper's form and the sharp form
    Theorems(theorems::Args),
    /// Re-establish the paper's errors by computation
    Errata(errata::Args),
    /// Try theorems on every start of a grid, or decide them for all real starts
    Sweep(Box<sweep::Args>),
    /// Search for the smallest counterexample to a theorem
    Refute(refute::Args),
    /// Search certificates for theorems: for every N, every step and every weight in the range
    Prove(prove::Args),
    /// Check certificates with the independent checker
    Check(check::Args),
    /// Bracket the critical weight of a property from both sides, with a certificate on each
    Threshold(threshold::Args),
    /// Find the step from which every drone stays within a distance of its target: proved and exact
    Settle(settle::Args),
    /// Moved to `cargo xtask kani`
    #[command(hide = true)]
    Kani(moved::Args),
    /// Moved to `cargo xtask verify`
    #[command(hide = true)]
    Verify(moved::Args),
    /// Write the protocol, its theorems or a scenario for other tools
    Export(Box<export::Args>),
    /// Print a completion script for a shell
    Completions(setup::Args),
    /// Print the manual page (roff; read it with `cordon man | man -l -`)
    Man,
}

impl Cli {
    /// Runs the command, its result going to `out` and everything else to stderr.
    ///
    /// # Errors
    /// Bad input, or a file or stream that cannot be read or written.
    pub fn run(self, out: &mut dyn Write) -> Result<Outcome> {
        match self.command {
            Command::Trace(args) => trace::run(&args, out),
            Command::Local(args) => local::run(&args, out),
            Command::Swarm(args) => swarm::run(&args, out),
            Command::Cosim(args) => cosim::run(&args, out),
            Command::Separation(args) => separation::run(&args, out),
            Command::Figures(args) => figures::run(&args, out),
            Command::Replay(args) => replay::run(&args, out),
            Command::Fmu(args) => fmu::run(&args, out),
            Command::Theorems(args) => theorems::run(&args, out),
            Command::Errata(args) => errata::run(&args, out),
            Command::Sweep(args) => sweep::run(&args, out),
            Command::Refute(args) => refute::run(&args, out),
            Command::Prove(args) => prove::run(&args, out),
            Command::Check(args) => check::run(&args, out),
            Command::Threshold(args) => threshold::run(&args, out),
            Command::Settle(args) => settle::run(&args, out),
            Command::Kani(_) => Err(moved::to("kani")),
            Command::Verify(_) => Err(moved::to("verify")),
            Command::Export(args) => export::run(&args, out),
            Command::Completions(args) => setup::completions(&args, out),
            Command::Man => setup::man(out),
        }
    }
}
