//! `cordon threshold`.

use std::io::Write;
use std::path::PathBuf;

use num_traits::One;
use serde_json::{Value, json};

use super::select::OutputFormat;
use super::separation::threshold::{self as separation, LoopArgs};
use cordon_core::exact::{decimal_string, fraction};
use cordon_core::{Evidence, Outcome, Rational, Result};
use cordon_proof::certificate::{self, REJECTED};
use cordon_proof::threshold::convergence::{self, Bracket};
use cordon_proof::threshold::safety::{self, Cone, Critical};
use cordon_proof::threshold::{check_size, invariance};

/// Arguments of `cordon threshold`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The property whose critical weight is wanted
    #[arg(long, value_enum)]
    property: Property,
    /// Number of drones, 3 to 1000 (not for separation, which is the same for all numbers)
    #[arg(long, value_name = "N", required_if_eq_any(OF_DRONES))]
    drones: Option<usize>,
    /// Decimal places of the bracket, 1 to 1000 [default: 10; separation: 1 to 4, 2]
    #[arg(long, value_name = "D")]
    digits: Option<usize>,
    #[command(flatten)]
    flight: LoopArgs,
    /// Folder for the certificates of both sides
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
}

#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    /// Theorem 7.2: drones never cross
    Ordering,
    /// Theorem 7.3: no drone passes its target
    Bound,
    /// Theorem 7.8: every drone converges to its target
    Convergence,
    /// Drones in flight keep the smallest gap: the critical gain lambda_P
    Separation,
}

/// The properties of the protocol alone.
const OF_DRONES: [(&str, &str); 3] =
    [("property", "ordering"), ("property", "bound"), ("property", "convergence")];

impl Property {
    fn name(self) -> &'static str {
        match self {
            Self::Ordering => "ordering",
            Self::Bound => "bound",
            Self::Convergence => "convergence",
            Self::Separation => "separation",
        }
    }
}

/// Most drones whose start is written out in the text.
const READABLE: usize = 12;

/// A certificate with the name of its file.
type Named = (String, Value);

/// Finds the critical weight.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    if args.property != Property::Separation {
        check_size(args.count(), args.places())?;
    }
    match args.property {
        Property::Ordering => keep(args, Cone::PositiveGaps, out),
        Property::Bound => keep(args, Cone::NonnegativeErrors, out),
        Property::Convergence => converge(args, out),
        Property::Separation => {
            let folder = args.out.as_deref();
            separation::run(&args.flight, args.digits, folder, args.format, out)
        }
    }
}

fn keep(args: &Args, cone: Cone, out: &mut dyn Write) -> Result<Outcome> {
    let Some(found) = safety::critical(cone, args.count(), args.places()) else {
        return not_found(out);
    };
    let mut certificates = Vec::new();
    for (side, eps) in [("at-0", &num_traits::Zero::zero()), ("below", &found.critical)] {
        certificates.extend(
            invariance::certificate(cone, args.count(), eps).map(|c| (args.file_name(side), c)),
        );
    }
    certificates.push((args.file_name("above"), certificate::refutation(&found.above)));
    let Some(files) = judged_and_written(args, &certificates)? else {
        writeln!(out, "{REJECTED}")?;
        return Ok(Outcome::Rejected);
    };
    match args.format {
        OutputFormat::Text => {
            keep_text(args, &found, out)?;
            writeln!(out, "{}", certified(certificates.len(), args.count()))?;
        }
        OutputFormat::Json => {
            let page = json!({
                "schema": "cordon-threshold/1",
                "property": args.property.name(),
                "drones": args.count(),
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

/// How many certificates the checker has accepted, and what it takes beyond its size.
fn certified(number: usize, drones: usize) -> String {
    if number == 1 && drones > invariance::MOST {
        return format!(
            "  checked: 1 certificate accepted; for the safe side of more than {} drones see `cordon prove 7.2-exact,7.3-exact`",
            invariance::MOST
        );
    }
    format!("  checked: {number} certificates accepted by the independent checker")
}

fn keep_text(args: &Args, found: &Critical, out: &mut dyn Write) -> Result<()> {
    let (critical, theorem) = (fraction(&found.critical), found.cone.theorem());
    let (what, coordinate) = match found.cone {
        Cone::PositiveGaps => ("strictly ordered", "gap"),
        Cone::NonnegativeErrors => ("not beyond its targets", "error"),
    };
    let [constant, slope] = &found.witness.coefficients;
    let (name, n) = (args.property.name(), args.count());
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
    let Some(found) = convergence::bracket(args.count(), args.places()) else {
        return not_found(out);
    };
    let w = &found.vector.weights;
    let certificates = [
        (
            args.file_name("below"),
            certificate::contraction(args.count(), &found.below, &found.rate, w),
        ),
        (args.file_name("above"), certificate::growth(args.count(), &found.above, w)),
    ];
    let Some(files) = judged_and_written(args, &certificates)? else {
        writeln!(out, "{REJECTED}")?;
        return Ok(Outcome::Rejected);
    };
    match args.format {
        OutputFormat::Text => {
            converge_text(args, &found, out)?;
            writeln!(out, "{}", certified(certificates.len(), 0))?;
        }
        OutputFormat::Json => {
            let page = json!({
                "schema": "cordon-threshold/1",
                "property": args.property.name(),
                "drones": args.count(),
                "digits": args.places(),
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
    let n = args.count();
    let below = decimal_string(&found.below, args.places());
    match &found.exact {
        Some(exact) => writeln!(
            out,
            "convergence (7.8), N = {n}: critical weight {} exactly",
            fraction(exact)
        )?,
        None => writeln!(
            out,
            "convergence (7.8), N = {n}: critical weight {below}... ({} places, not rounded)",
            args.places()
        )?,
    }
    let above = match &found.exact {
        Some(exact) => fraction(exact),
        None => decimal_string(&found.above, args.places()),
    };
    writeln!(
        out,
        "  below  at eps = {below} every run converges (and for every eps from there down to 0, excluded)"
    )?;
    writeln!(
        out,
        "         contraction: |A| w <= c w with c = 1 - {}, w positive, {} integers of at most {} digits",
        short(&(Rational::one() - &found.rate)),
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

/// 10^-m as such.
fn short(unit: &Rational) -> String {
    let text = unit.denom().to_string();
    match text.strip_prefix('1').filter(|z| z.bytes().all(|b| b == b'0')) {
        Some(zeros) if unit.numer().is_one() => format!("10^-{}", zeros.len()),
        _ => fraction(unit),
    }
}

impl Args {
    fn count(&self) -> usize {
        self.drones.unwrap_or_default()
    }

    fn places(&self) -> usize {
        self.digits.unwrap_or(10)
    }

    fn file_name(&self, side: &str) -> String {
        format!("{}-{}-{side}", self.property.name(), self.count())
    }
}

/// Has the certificates checked and writes them; the files, or `None` where one is rejected.
fn judged_and_written(args: &Args, certificates: &[Named]) -> Result<Option<Vec<String>>> {
    if !certificates.iter().all(|(_, c)| certificate::accepted(c)) {
        return Ok(None);
    }
    let Some(folder) = &args.out else {
        return Ok(Some(Vec::new()));
    };
    let files = certificates
        .iter()
        .map(|(name, c)| Ok(certificate::write(folder, name, c)?.display().to_string()));
    files.collect::<Result<_>>().map(Some)
}

fn list_files(args: &Args, files: &[String], out: &mut dyn Write) -> Result<()> {
    if args.format == OutputFormat::Text {
        for file in files {
            writeln!(out, "  wrote  {file}")?;
        }
    }
    Ok(())
}

fn not_found(out: &mut dyn Write) -> Result<Outcome> {
    writeln!(out, "inconclusive: no bracket was found")?;
    Ok(Outcome::Inconclusive)
}
