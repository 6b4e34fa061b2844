//! `cordon threshold`.

mod late;

use std::io::Write;
use std::path::PathBuf;

use num_traits::One;
use serde_json::json;

use super::certificates::{self, Named};
use super::own_protocol;
use super::select::OutputFormat;
use super::separation::threshold::{self as separation, LoopArgs};
use cordon_core::exact::{decimal_string, fraction, in_short, shortened};
use cordon_core::system::System;
use cordon_core::{Error, Evidence, Outcome, Rational, Result, progress};
use cordon_proof::certificate;
use cordon_proof::claims::threshold as claims;
use cordon_proof::threshold::convergence::{self, Bracket};
use cordon_proof::threshold::safety::{self, Cone, Critical};
use cordon_proof::threshold::{check_size, invariance};

/// Arguments of `cordon threshold`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The property whose critical weight is wanted
    #[arg(long, value_enum, required_unless_present = "protocol")]
    property: Option<Property>,
    #[command(flatten)]
    own: own_protocol::ProtocolArgs,
    /// With --protocol: the parameter whose critical value is wanted [default: the only one with a range]
    #[arg(long, value_name = "NAME", help_heading = "Own protocol")]
    parameter: Option<String>,
    /// Number of drones, 3 to 1000; with --delay 3 to 20, or a range; separation is the same for all numbers
    #[arg(long, value_name = "N|LO..HI", conflicts_with = "protocol")]
    drones: Option<String>,
    /// With ordering: each drone may see each neighbour up to this many steps late, or a range
    #[arg(long, value_name = "D|LO..HI", conflicts_with = "protocol")]
    delay: Option<String>,
    /// Decimal places of the bracket, 1 to 1000 [default: 10; with --protocol: 1 to 50, 4; separation: 1 to 4, 2;
    /// with --delay: 1 to 4, 2]
    #[arg(long, value_name = "D")]
    digits: Option<usize>,
    #[command(flatten)]
    flight: LoopArgs,
    /// Folder for the certificates of both sides
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
}

#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    /// Theorem 7.2: drones never cross
    Ordering,
    /// Theorem 7.3: no drone passes its target
    Bound,
    /// Theorem 7.8: every drone converges to its target; with --protocol as the file claims
    Convergence,
    /// The claims of a protocol file
    Claims,
    /// Drones in flight keep the smallest gap: the critical gain lambda_P
    Separation,
}

impl Property {
    fn name(self) -> &'static str {
        match self {
            Self::Ordering => "ordering",
            Self::Bound => "bound",
            Self::Convergence => "convergence",
            Self::Claims => "claims",
            Self::Separation => "separation",
        }
    }
}

/// Most drones for which the start is written out in the text.
const READABLE: usize = 12;

/// Finds the critical weight or parameter.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    let own_system = args.own.system()?;
    let unused =
        |flag: &str, needed: &str| Err(Error::input(format!("{flag}: expected {needed} with it")));
    if let (Some(flag), true) =
        (args.flight.given(), own_system.is_some() || args.property() != Property::Separation)
    {
        return unused(flag, "--property separation");
    }
    if let Some((_, system)) = own_system {
        return own(args, &system, out);
    }
    if args.property() == Property::Separation {
        if args.delay.is_some() {
            return unused("delay", "--property ordering");
        }
        if args.drones.is_some() {
            return unused(
                "drones",
                "a property other than separation, which is the same for all numbers,",
            );
        }
        let folder = args.out.as_deref();
        return separation::run(&args.flight, args.digits, folder, args.format, out);
    }
    let needs_file = || Err(Error::input("property: `claims`: expected --protocol with it"));
    if args.property() == Property::Claims {
        return needs_file();
    }
    let Some(drones) = &args.drones else {
        return Err(Error::input("drones: expected --drones N, a number from 3 to 1000"));
    };
    if let Some(delay) = &args.delay {
        if args.property() != Property::Ordering {
            return unused("delay", "--property ordering");
        }
        return late::run(args, drones, delay, out);
    }
    args.drones_alone()?;
    check_size(args.drones(), args.digits())?;
    match args.property() {
        Property::Ordering => keep(args, Cone::PositiveGaps, out),
        Property::Bound => keep(args, Cone::NonnegativeErrors, out),
        Property::Convergence => converge(args, out),
        Property::Claims | Property::Separation => needs_file(),
    }
}

impl Args {
    /// The property, which is present unless a protocol file is given.
    fn property(&self) -> Property {
        self.property.unwrap_or(Property::Ordering)
    }

    /// Refuses anything other than a single number in `--drones`.
    fn drones_alone(&self) -> Result<()> {
        match self.drones.as_deref().map(|text| (text, text.parse::<usize>())) {
            Some((text, Err(_))) => Err(Error::input(format!(
                "drones: `{}`: expected a number from 3 to 1000",
                shortened(text)
            ))),
            _ => Ok(()),
        }
    }

    fn drones(&self) -> usize {
        self.drones.as_deref().and_then(|text| text.parse().ok()).unwrap_or_default()
    }

    fn digits(&self) -> usize {
        self.digits.unwrap_or(10)
    }
}

/// Most decimal places of a bracket for a protocol file: each takes some proofs.
const MOST_OWN_DIGITS: usize = 50;

fn own(args: &Args, system: &System, out: &mut dyn Write) -> Result<Outcome> {
    let property = match args.property {
        Some(Property::Convergence) => claims::Property::Convergence,
        Some(Property::Claims) => claims::Property::Claims,
        None if system.claims.is_empty() => claims::Property::Convergence,
        None => claims::Property::Claims,
        Some(other) => {
            return Err(Error::input(format!(
                "property: `{}`: expected `claims` or `convergence` with --protocol",
                other.name()
            )));
        }
    };
    let digits = args.digits.unwrap_or(4);
    if !(1..=MOST_OWN_DIGITS).contains(&digits) {
        return Err(Error::input(format!(
            "digits: `{digits}`: expected a number from 1 to {MOST_OWN_DIGITS} with --protocol"
        )));
    }
    let asked = own_protocol::Asked {
        parameter: args.parameter.as_deref(),
        property,
        digits,
        folder: args.out.as_deref(),
    };
    own_protocol::threshold(&args.own, system, &asked, args.format, out)
}

fn keep(args: &Args, cone: Cone, out: &mut dyn Write) -> Result<Outcome> {
    let Some(found) = safety::critical(cone, args.drones(), args.digits()) else {
        return not_found(args, args.drones(), out);
    };
    let mut certificates = Vec::new();
    for (side, eps) in [("at-0", &num_traits::Zero::zero()), ("below", &found.critical)] {
        certificates.extend(
            invariance::certificate(cone, args.drones(), eps).map(|c| (args.file_name(side), c)),
        );
    }
    certificates.push((args.file_name("above"), certificate::refutation(&found.above)));
    let files = judged_and_written(args, &certificates)?;
    match args.format {
        OutputFormat::Text => {
            keep_text(args, &found, out)?;
            writeln!(out, "{}", certified(certificates.len(), args.drones()))?;
        }
        OutputFormat::Json => {
            let page = json!({
                "schema": "cordon-threshold/1",
                "property": args.property().name(),
                "drones": args.drones(),
                "critical": fraction(&found.critical),
                "exact": true,
                "holds_at_critical": true,
                "below": { "eps": fraction(&found.critical), "evidence": Evidence::Inductive, "coefficients": found.entries },
                "above": found.above.to_json(),
                "files": files,
            });
            writeln!(out, "{page:#}")?;
        }
    }
    list_files(args, &files, out)?;
    Ok(Outcome::Holds)
}

/// A line on the accepted certificates; beyond the size limit of the safe side, with the command for it.
fn certified(number: usize, drones: usize) -> String {
    if number == 1 && drones > invariance::MOST {
        return format!(
            "  checked: 1 certificate accepted; for the safe side of more than {} drones see `cordon prove 7.2-exact,7.3-exact`",
            invariance::MOST
        );
    }
    format!("  checked: {}", certificates::accepted(number))
}

fn keep_text(args: &Args, found: &Critical, out: &mut dyn Write) -> Result<()> {
    let (critical, theorem) = (fraction(&found.critical), found.cone.theorem());
    let (what, coordinate) = match found.cone {
        Cone::PositiveGaps => ("strictly ordered", "gap"),
        Cone::NonnegativeErrors => ("not beyond its targets", "error"),
    };
    let [constant, slope] = &found.witness.coefficients;
    let (name, n) = (args.property().name(), args.drones());
    writeln!(out, "{name} ({}), N = {n}: critical weight {critical} exactly", theorem.number())?;
    writeln!(
        out,
        "  below  for every eps in [0, {critical}] a start that is {what} stays so, at every step"
    )?;
    writeln!(
        out,
        "         inductive: {} coefficients of one step, affine in eps, all nonnegative at both ends",
        found.entries
    )?;
    writeln!(
        out,
        "  above  for every eps > {critical} some start is violated at step 1: {coordinate} {} takes {} of {coordinate} {}",
        found.witness.row,
        affine_text(&fraction(constant), &fraction(slope)),
        found.witness.ray
    )?;
    writeln!(
        out,
        "         at eps = {}: {}",
        fraction(&found.above.eps),
        found.above.what_fails()
    )?;
    if found.count <= READABLE {
        writeln!(out, "         replay: {}", found.above.replay_line())?;
    }
    Ok(())
}

fn affine_text(constant: &str, slope: &str) -> String {
    match slope.strip_prefix('-') {
        Some("1") => format!("({constant} - eps)"),
        Some(slope) => format!("({constant} - {slope} eps)"),
        None => format!("({constant} + {slope} eps)"),
    }
}

fn converge(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    // The search takes about as long as the check of both certificates.
    progress::expect(4);
    let found = convergence::bracket(args.drones(), args.digits());
    progress::advance(2);
    let Some(found) = found else {
        return not_found(args, args.drones(), out);
    };
    let w = &found.vector.weights;
    let certificates = [
        (
            args.file_name("below"),
            certificate::contraction(args.drones(), &found.below, &found.rate, w),
        ),
        (args.file_name("above"), certificate::growth(args.drones(), &found.above, w)),
    ];
    let files = judged_and_written(args, &certificates)?;
    match args.format {
        OutputFormat::Text => {
            converge_text(args, &found, out)?;
            writeln!(out, "{}", certified(certificates.len(), 0))?;
        }
        OutputFormat::Json => {
            let page = json!({
                "schema": "cordon-threshold/1",
                "property": args.property().name(),
                "drones": args.drones(),
                "digits": args.digits(),
                "critical": found.exact.as_ref().map(fraction),
                "exact": found.exact.is_some(),
                "holds_at_critical": false,
                "below": { "eps": fraction(&found.below), "evidence": "contraction", "rate": fraction(&found.rate) },
                "above": { "eps": fraction(&found.above), "evidence": "growth" },
                "files": files,
            });
            writeln!(out, "{page:#}")?;
        }
    }
    list_files(args, &files, out)?;
    Ok(Outcome::Holds)
}

fn converge_text(args: &Args, found: &Bracket, out: &mut dyn Write) -> Result<()> {
    let n = args.drones();
    let below = decimal_string(&found.below, args.digits());
    match &found.exact {
        Some(exact) => writeln!(
            out,
            "convergence (7.8), N = {n}: critical weight {} exactly",
            fraction(exact)
        )?,
        None => writeln!(
            out,
            "convergence (7.8), N = {n}: critical weight {below}... ({} places, not rounded)",
            args.digits()
        )?,
    }
    let above = match &found.exact {
        Some(exact) => fraction(exact),
        None => decimal_string(&found.above, args.digits()),
    };
    writeln!(
        out,
        "  below  at eps = {below} every run converges (and for every eps from there down to 0, excluded)"
    )?;
    writeln!(
        out,
        "         contraction: |A| w <= c w with c = 1 - {}, w positive, {} integers of at most {} digits",
        in_short(&(Rational::one() - &found.rate)),
        found.vector.weights.len(),
        found.vector.weights.iter().map(|w| w.to_string().len()).max().unwrap_or_default()
    )?;
    writeln!(
        out,
        "  above  at eps = {above} some run does not converge (and for every larger eps)"
    )?;
    writeln!(out, "         growth: |A| w >= w, the same w")?;
    writeln!(
        out,
        "         both factors, |1 - 2 eps| + eps r with r below 2, are convex in eps and 1 at eps = 0"
    )?;
    Ok(())
}

impl Args {
    fn file_name(&self, side: &str) -> String {
        format!("{}-{}-{side}", self.property().name(), self.drones())
    }
}

/// Has the certificates checked and writes them; returns the files.
fn judged_and_written(args: &Args, all: &[Named]) -> Result<Vec<String>> {
    for (_, found) in all {
        certificate::judged(found)?;
        progress::advance(1);
    }
    certificates::written(args.out.as_deref(), all.iter().map(|(name, c)| (name, c)))
}

fn list_files(args: &Args, files: &[String], out: &mut dyn Write) -> Result<()> {
    match args.format {
        OutputFormat::Text => certificates::list("wrote  ", files, out),
        OutputFormat::Json => Ok(()),
    }
}

/// Says that there is no bracket.
fn not_found(args: &Args, drones: usize, out: &mut dyn Write) -> Result<Outcome> {
    match args.format {
        OutputFormat::Text => writeln!(out, "inconclusive: no bracket was found")?,
        OutputFormat::Json => {
            let page = json!({
                "schema": "cordon-threshold/1",
                "property": args.property().name(),
                "drones": drones,
                "critical": null,
                "exact": false,
                "below": null,
                "above": null,
                "files": [],
            });
            writeln!(out, "{page:#}")?;
        }
    }
    Ok(Outcome::Inconclusive)
}
