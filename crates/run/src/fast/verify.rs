//! The cross-check of a fast answer: the plain spec, run over random prime fields.
//!
//! An answer that is wrong anywhere differs from the true one by a nonzero integer over the
//! common denominator, of at most so many bits; few primes divide it. A prime drawn at random
//! shows the difference, unless it is one of those.

use std::hash::{BuildHasher, Hasher, RandomState};

use super::answer::Answer;
use super::engine::Motion;
use super::rule::Rule;
use cordon_core::random::SplitMix;
use cordon_core::scalar::{Modulus, Residue};
use cordon_core::{Error, Rational, Result, progress};

/// Primes that a check draws unless told otherwise.
pub const PRIMES: usize = 3;

/// Most drone updates of one check, over all primes: some ten minutes.
const MAX_UPDATES: u64 = 10_000_000_000;

/// `log2` of a lower bound of the number of primes from 2^60 to 2^61: pi(2x) - pi(x) is above
/// 3x/(5 ln x) for x >= 20.5 (J. B. Rosser and L. Schoenfeld, 1962), which is 2^53.88 here; the
/// few primes that divide the denominator cost less than the rest of the margin.
const LOG2_PRIMES: f64 = 53.8;

/// A seed of 64 bits has no smaller chance than this, as a power of two, to be a bad one.
const LOG2_SEED_LIMIT: f64 = -60.0;

/// A place where an answer and the spec disagree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Disagreement {
    /// The prime modulo which the answer differs from the spec.
    pub prime: u64,
    /// After how many protocol steps.
    pub k: u64,
    /// The first drone whose residue differs, from 0.
    pub drone: usize,
}

/// What a check has found.
#[derive(Clone, Debug, PartialEq)]
pub struct Verification {
    /// What the primes were drawn from.
    pub seed: u64,
    /// The primes, each from 2^60 to 2^61.
    pub primes: Vec<u64>,
    /// How many residues were compared.
    pub compared: u64,
    /// A bound, as a power of two, of the chance that a wrong answer passes.
    pub log2_chance: f64,
    /// The first place where answer and spec differ; none where the check passed.
    pub disagreement: Option<Disagreement>,
}

/// A seed that the operating system has drawn.
pub fn fresh_seed() -> u64 {
    RandomState::new().build_hasher().finish()
}

/// Runs the spec modulo `primes` random primes up to the last of the answers and compares
/// all drones of every answer.
///
/// # Errors
/// A run too long to step through, or a denominator that too many primes divide.
pub fn verify(
    rule: &Rule<Rational>,
    start: &[Rational],
    answers: &[Answer],
    primes: usize,
    seed: u64,
) -> Result<Verification> {
    let mut ordered: Vec<&Answer> = answers.iter().collect();
    ordered.sort_by_key(|a| a.k);
    let last = ordered.last().map_or(0, |a| a.k);
    let updates = last.saturating_mul(start.len() as u64).saturating_mul(primes as u64);
    if updates > MAX_UPDATES {
        return Err(Error::input(format!(
            "verify: {last} steps of {} drones modulo {primes} primes: expected at most \
             {MAX_UPDATES} drone updates",
            start.len()
        )));
    }
    let mut found = Verification {
        seed,
        primes: Vec::new(),
        compared: 0,
        log2_chance: chance(&rule.motion(start)?, answers, primes),
        disagreement: None,
    };
    progress::expect(last.saturating_mul(primes as u64));
    let mut random = SplitMix::new(seed);
    while found.primes.len() < primes {
        let p = random_prime(&mut random);
        let Some((rule, start, wanted)) = images(p, rule, start, &ordered) else {
            // p divides a denominator, which almost no prime of this size does.
            continue;
        };
        found.primes.push(p.prime());
        let (mut x, mut k) = (start, 0);
        for (answer, wanted) in ordered.iter().zip(wanted) {
            while k < answer.k {
                k += 1;
                x = rule.step(k, x);
                progress::advance(1);
            }
            found.compared += x.len() as u64;
            let differs = |(a, b): (&Residue, &Residue)| a != b;
            let same_length = x.len() == wanted.len();
            let drone = x.iter().zip(&wanted).position(differs);
            if let Some(drone) = drone.or((!same_length).then_some(x.len())) {
                found.disagreement = Some(Disagreement { prime: p.prime(), k, drone });
                return Ok(found);
            }
        }
    }
    Ok(found)
}

type Images = (Rule<Residue>, Vec<Residue>, Vec<Vec<Residue>>);

/// Protocol, start and answers modulo p, unless p divides a denominator.
fn images(
    p: Modulus,
    rule: &Rule<Rational>,
    start: &[Rational],
    answers: &[&Answer],
) -> Option<Images> {
    let rule = rule.map(|x| p.reduce(x))?;
    let start = start.iter().map(|x| p.reduce(x)).collect::<Option<_>>()?;
    let answers = answers.iter().map(|a| a.residues(p)).collect::<Option<_>>()?;
    Some((rule, start, answers))
}

/// The bound of the chance that wrong answers agree modulo every prime, as a power of two.
fn chance(motion: &Motion, answers: &[Answer], primes: usize) -> f64 {
    let mut worst = LOG2_SEED_LIMIT;
    for answer in answers {
        let given = answer.numerators.iter().map(num_bigint::BigInt::bits).max().unwrap_or(0);
        // The difference of two numerators, the true and the given one.
        let bits = motion.numerator_bits(answer.k).max(given) as f64 + 1.0;
        // So many primes of 2^60 or more divide it at most.
        let bad = (bits / 60.0).max(1.0);
        worst = worst.max(primes as f64 * (bad.log2() - LOG2_PRIMES));
    }
    worst
}

/// A prime from 2^60 to 2^61, each with the same chance.
fn random_prime(random: &mut SplitMix) -> Modulus {
    loop {
        let candidate = 1 << 60 | random.bits() >> 4 | 1;
        if let Some(p) = Modulus::new(candidate) {
            return p;
        }
    }
}
