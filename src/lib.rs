//! A line of drones spreads evenly along a segment: the two ends stay, every other drone moves by
//! `x_i' = eps*x_{i-1} + (1-2*eps)*x_i + eps*x_{i+1}`. Cordon runs this coverage protocol exactly,
//! and says of its theorems (7.2 to 7.8 of the paper) whether they hold: along one run, from no
//! start at all, or for every swarm, step and real weight.
//!
//! This page is the library behind the program `cordon`: a function for each question.
//!
//! | question | function | its evidence |
//! |---|---|---|
//! | Where is every drone after each step? | [`trace()`] | the spec, executed on rationals |
//! | And after step 1,000,000? | [`jump`] | the same fractions, without the steps between |
//! | Does a theorem hold along this run? | [`check_run`] | this run only |
//! | Is there a start from which it fails? | [`refute()`] | a counterexample that replays |
//! | Is it true for every swarm? | [`prove`], [`check_certificate`] | a certificate, and the independent checker's word on it |
//! | Does my own protocol keep what I claim? | [`protocol_file`], [`prove_claims`], [`refute_claims`] | a certificate, or an exact run |
//! | How do the drones fly? | [`fly`] | one co-simulated run |
//!
//! # Running a scenario
//!
//! A [`Scenario`] is read from TOML. Numbers are read exactly: `0.2` is 1/5.
//!
//! ```
//! # fn main() -> cordon::Result<()> {
//! let scenario = cordon::scenario(
//!     r#"
//!     start = [0, 10, 20, 30, 100]
//!     weight = 0.2
//!     "#,
//! )?;
//! let placements = cordon::trace(&scenario, 3)?;
//! assert_eq!(placements[1][3].to_string(), "42");
//! # Ok(())
//! # }
//! ```
//!
//! # What is believed
//!
//! The protocol is defined once, in [`spec`], and everything here executes that definition. The
//! checker of certificates shares no code with the search. `TRUST.md` in the repository says what
//! each kind of evidence rests on.

pub use cordon_check::Verdict as CertificateVerdict;
/// User-defined protocols, as the engines see them. [`protocol_file`] reads one from TOML,
/// [`system::System::of`] takes one from a Rust type (`examples/own.rs`).
pub use cordon_core::system;
pub use cordon_core::{Error, Outcome, Rational, Result};
pub use cordon_cosim::record::Record;
pub use cordon_proof::claims::Run as ClaimRun;
pub use cordon_proof::counterexample::Counterexample;
pub use cordon_run::scenario::{Flight, Protocol, Scenario};
pub use cordon_run::trace::Checked;
/// The protocol and its theorems: the only definition, generic in its numbers.
pub use cordon_spec as spec;
pub use cordon_spec::theorems::{Form, Theorem};

use cordon_cosim::cosimulation::Cosimulation;
use cordon_proof::prove::{CLAIMS, Scope};
use cordon_proof::refute;
use cordon_run::fast::{Engine, Motion};
use cordon_run::trace::{self as rows, Counted, Selection, shown};

/// The scenario that a TOML text describes.
///
/// # Errors
/// The text is not TOML, or a field is unknown, missing or meaningless: with line and column.
///
/// ```
/// let wrong = cordon::scenario("start = [0, 10, 20]\nweight = \"one fifth\"").unwrap_err();
/// assert!(wrong.to_string().starts_with("scenario:2:10: weight: `one fifth` is not a number"));
/// assert_eq!(wrong.code(), 2);
/// ```
pub fn scenario(toml: &str) -> Result<Scenario> {
    cordon_run::scenario::parse("scenario", toml)?.finish()
}

/// The scenario that a TOML text describes, including its flight.
///
/// # Errors
/// As for [`scenario`].
pub fn scenario_and_flight(toml: &str) -> Result<(Scenario, Flight)> {
    let draft = cordon_run::scenario::parse("scenario", toml)?;
    let flight = draft.flight.clone();
    Ok((draft.finish()?, flight))
}

/// The exact positions after the protocol steps 0 to `last`: a list for each step, with one position
/// per drone.
///
/// # Errors
/// The run is too long to step through.
pub fn trace(scenario: &Scenario, last: u64) -> Result<Vec<Vec<Rational>>> {
    let selection = Selection { unit: Counted::Steps, from: 0, to: last, every: 1 };
    Ok(rows::select(scenario, selection)?.map(|row| row.positions.lowest()).collect())
}

/// The exact positions after each of the protocol steps `steps`, without the steps in between: a list
/// for each step, with one position per drone.
///
/// # Errors
/// The protocol is neither coverage, nor consensus along the line, nor a protocol file; or the
/// fractions would not fit in memory.
///
/// ```
/// # fn main() -> cordon::Result<()> {
/// let scenario = cordon::scenario("start = [0, 10, 20, 30, 100]\nweight = 0.2")?;
/// let after = cordon::jump(&scenario, &[3, 2000])?;
/// assert_eq!(after[0], cordon::trace(&scenario, 3)?[3]);
/// // At step 2000 the inner drones are within 1/10^100 of 25, 50 and 75, and not there.
/// assert!(after[1][2] != cordon::Rational::from_integer(50.into()));
/// # Ok(())
/// # }
/// ```
pub fn jump(scenario: &Scenario, steps: &[u64]) -> Result<Vec<Vec<Rational>>> {
    let last = steps.iter().copied().max().unwrap_or(0);
    let answers = Motion::of(scenario, last)?.positions(steps, Engine::Jump)?;
    Ok(answers.into_iter().map(|answer| shown(scenario, answer).lowest()).collect())
}

/// Checks a theorem at every protocol step of the run from 0 to `last`.
///
/// # Errors
/// The protocol is not coverage, or the theorem does not apply to the start.
///
/// ```
/// use cordon::{Form, Outcome, Theorem};
///
/// # fn main() -> cordon::Result<()> {
/// // A weight beyond 1/2 lets drones cross.
/// let scenario = cordon::scenario("start = [0, 10, 20, 30, 100]\nweight = 0.7")?;
/// let found = cordon::check_run(&scenario, Theorem::Ordering, Form::Sharp, 10)?;
/// assert_eq!(found.outcome(), Outcome::Refuted);
/// assert!(!found.weight_in_range, "which contradicts no theorem");
/// # Ok(())
/// # }
/// ```
pub fn check_run(scenario: &Scenario, theorem: Theorem, form: Form, last: u64) -> Result<Checked> {
    let checked = rows::check(scenario, &[theorem], form, last)?;
    checked
        .into_iter()
        .next()
        .ok_or_else(|| Error::internal("a theorem was checked without result"))
}

/// Searches for the smallest counterexample to a theorem with one of these weights, among swarms with
/// these numbers of drones (ascending) and protocol steps up to `steps`. `None`: none was found.
///
/// ```
/// use cordon::{Form, Rational, Theorem};
///
/// let three_fifths = Rational::new(3.into(), 5.into());
/// let found = cordon::refute(Theorem::Ordering, Form::Sharp, &[4], &[three_fifths], 8).unwrap();
/// assert_eq!(found.step, 1);
/// assert!(found.start().windows(2).all(|x| x[0] < x[1]));
/// assert!(found.run[1][1] > found.run[1][2], "drones 1 and 2 have crossed");
/// ```
pub fn refute(
    theorem: Theorem,
    form: Form,
    drones: &[usize],
    weights: &[Rational],
    steps: usize,
) -> Option<Counterexample> {
    let (drones, weights) = (drones.to_vec(), weights.to_vec());
    let any_weight = true;
    let space = refute::SearchSpace { theorem, form, drones, weights, any_weight, steps };
    refute::search(&space).found
}

/// Searches for a proof of a theorem for every number of drones, every step and every real weight of
/// its range. The certificate is a JSON text, to be judged by [`check_certificate`]: the search itself
/// need not be trusted. `None`: no proof was found.
///
/// ```
/// use cordon::{CertificateVerdict, Form, Theorem};
///
/// let certificate = cordon::prove(Theorem::Ordering, Form::Sharp).unwrap();
/// let verdict = cordon::check_certificate(&certificate);
/// assert!(matches!(verdict, CertificateVerdict::Valid { .. }), "{verdict}");
///
/// let forged = certificate.replace("1 - 2*eps >= 0", "1 - eps >= 0");
/// assert_ne!(forged, certificate);
/// assert!(!matches!(cordon::check_certificate(&forged), CertificateVerdict::Valid { .. }));
/// ```
pub fn prove(theorem: Theorem, form: Form) -> Option<String> {
    let claim = CLAIMS.iter().find(|c| c.name == theorem.number())?;
    let certificate = claim.prove(&Scope { form, weights: None, drones: None })?.to_string();
    matches!(check_certificate(&certificate), CertificateVerdict::Valid { .. })
        .then_some(certificate)
}

/// The system that the text of a protocol file describes (`docs/src/protocol-file.md`); for a protocol
/// with any number of agents, with the fewest.
///
/// # Errors
/// The text is not a protocol: with line, column and key.
///
/// ```
/// # fn main() -> cordon::Result<()> {
/// let system = cordon::protocol_file(
///     r#"
///     agents = 5
///     topology = "ring"
///     claims = ["0 <= x[i] <= 1"]
///     [parameters]
///     eps = "0..1/2"
///     [rules]
///     all = "x + eps*sum(their.x - x)"
///     "#,
/// )?;
/// let proved = cordon::prove_claims(&system)?.expect("the box is kept");
/// assert!(cordon::check_certificate(&proved).to_string().starts_with("valid: "));
/// # Ok(())
/// # }
/// ```
pub fn protocol_file(toml: &str) -> Result<system::System> {
    cordon_run::protocol::parse("protocol", toml)?.system()
}

/// Searches for a proof of the claims about a system: at every step, from every assumed start, for all
/// values of its parameters. The certificate is a JSON text that the independent checker has accepted.
/// `None`: none was found.
///
/// # Errors
/// The certificate is beyond the checker's limits.
pub fn prove_claims(system: &system::System) -> Result<Option<String>> {
    let Some(found) = cordon_proof::claims::prove(system) else { return Ok(None) };
    let certificate = cordon_proof::claims::certificate::certified(&found)?;
    Ok(Some(certificate.map_err(Error::input)?.to_string()))
}

/// Searches for the smallest counterexample to the claims about a system, up to step `steps`: constants
/// take the ends of their ranges and fractions with denominators up to 8, varying parameters take their
/// ends. `None`: none was found.
pub fn refute_claims(system: &system::System, steps: usize) -> Option<ClaimRun> {
    let constants = cordon_proof::claims::constants_up_to(system, 8);
    cordon_proof::claims::refute(system, &constants, None, steps).0
}

/// The independent checker's verdict on the text of a certificate.
pub fn check_certificate(text: &str) -> CertificateVerdict {
    cordon_check::check(text)
}

/// Flies a scenario: plant, controller and coordination of every drone, co-simulated. The record
/// has desired and actual positions at every communication point, and the collisions.
///
/// # Errors
/// A field of the flight is meaningless, a unit fails, or the record would not fit in memory.
///
/// ```
/// # fn main() -> cordon::Result<()> {
/// let (scenario, flight) = cordon::scenario_and_flight(
///     r#"
///     start = [0, 10, 20, 30, 100]
///     weight = 0.2
///     period = 4
///     tau = 0.05
///     [flight]
///     duration = 2
///     "#,
/// )?;
/// let record = cordon::fly(scenario, flight)?;
/// assert_eq!((record.count, record.rows()), (5, 41));
/// assert!(record.events.is_some_and(|events| events.is_empty()), "nothing collided");
/// # Ok(())
/// # }
/// ```
pub fn fly(scenario: Scenario, flight: Flight) -> Result<Record> {
    cordon_cosim::run::run(&Cosimulation::new(scenario, flight)?)
}
