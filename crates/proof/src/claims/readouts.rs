//! What has to tend to 0 for a system to converge, and what a step makes of it.

use std::collections::BTreeMap;

use num_traits::Zero;

use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::scalar::{Monomial, Polynomial};
use cordon_core::system::{Convergence, Mode, System};

/// The readouts of a system: errors to the targets, or differences to agent 0.
#[derive(Clone, Debug)]
pub struct Readouts {
    /// Of each readout, the state variable, and what is taken from it.
    pub all: Vec<(usize, Reference)>,
}

/// What a readout is measured from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reference {
    /// A number.
    Target(Rational),
    /// A state variable, of agent 0.
    Agent(usize),
}

/// What a step of a mode makes of each readout: a combination of readouts, the coefficients being
/// polynomials in the parameters.
pub type QuotientRows = Vec<BTreeMap<usize, Polynomial>>;

impl Readouts {
    /// Those of a system whose convergence is claimed.
    pub fn of(system: &System) -> Option<Self> {
        let per_agent = system.variables.len();
        let now = system.state.len() - system.past.len();
        let all = match system.converges.as_ref()? {
            Convergence::To(targets) => {
                targets.iter().enumerate().map(|(j, t)| (j, Reference::Target(t.clone()))).collect()
            }
            Convergence::Agreement => (per_agent..system.state.len())
                .map(|j| {
                    let shown = if j < now { j } else { system.past.get(j - now).copied()? };
                    Some((j, Reference::Agent(shown % per_agent.max(1))))
                })
                .collect::<Option<_>>()?,
        };
        Some(Self { all })
    }

    /// The readouts as forms of the state.
    pub fn forms(&self) -> Vec<Affine> {
        let form = |(j, reference): &(usize, Reference)| {
            Affine::variable(*j)
                - &match reference {
                    Reference::Agent(r) => Affine::variable(*r),
                    Reference::Target(t) => Affine::constant(t.clone()),
                }
        };
        self.all.iter().map(form).collect()
    }

    /// The values of the readouts in a state.
    pub fn at(&self, state: &[Rational]) -> Option<Vec<Rational>> {
        self.forms().iter().map(|form| form.at(state)).collect()
    }

    /// What a step makes of the readouts; `None` where it depends on more than them: the targets move,
    /// or agreement does not last.
    pub fn quotient(&self, mode: &Mode) -> Option<QuotientRows> {
        // On readouts y the state is a base point plus a combination of them; where it starts from is 0 for
        // differences, and the targets for errors.
        let index: BTreeMap<usize, usize> =
            self.all.iter().enumerate().map(|(y, (j, _))| (*j, y)).collect();
        let reference: BTreeMap<usize, &Reference> =
            self.all.iter().map(|(j, r)| (*j, r)).collect();
        let row = |(j, taken): &(usize, Reference)| {
            // The difference of the two rows, by column; `None` for the constant.
            let mut sums: BTreeMap<Option<usize>, Polynomial> = BTreeMap::new();
            let mut add = |row: usize, sign: i32| -> Option<()> {
                let (constant, entries) = mode.row(row)?;
                let sign = Polynomial::constant(Rational::from_integer(sign.into()));
                let entries = entries.iter().map(|(j, a)| (Some(*j), a));
                for (column, a) in entries.chain([(None, constant)]) {
                    let sum = sums.remove(&column).unwrap_or_default();
                    sums.insert(column, sum + &(sign.clone() * a));
                }
                Some(())
            };
            add(*j, 1)?;
            let mut rest = Polynomial::default();
            match taken {
                Reference::Agent(r) => add(*r, -1)?,
                Reference::Target(t) => rest = rest - &Polynomial::constant(t.clone()),
            }
            let mut made = BTreeMap::new();
            // What is left over has to vanish: the constant, and for each reference its column in all.
            let mut left: BTreeMap<usize, Polynomial> = BTreeMap::new();
            for (column, a) in sums {
                match column.map(|j| (j, reference.get(&j))) {
                    None => rest = rest + &a,
                    Some((j, None)) => {
                        let sum = left.remove(&j).unwrap_or_default();
                        left.insert(j, sum + &a);
                    }
                    Some((j, Some(Reference::Agent(r)))) => {
                        let sum = left.remove(r).unwrap_or_default();
                        left.insert(*r, sum + &a);
                        made.insert(*index.get(&j)?, a);
                    }
                    Some((j, Some(Reference::Target(t)))) => {
                        rest = rest + &(a.clone() * &Polynomial::constant(t.clone()));
                        made.insert(*index.get(&j)?, a);
                    }
                }
            }
            made.retain(|_, a| !a.is_zero());
            (rest.is_zero() && left.values().all(Polynomial::is_zero)).then_some(made)
        };
        self.all.iter().map(row).collect()
    }
}

/// The rows as numbers, the parameters having these values.
pub fn at(rows: &QuotientRows, values: &[Rational]) -> Vec<Vec<Rational>> {
    let value = |p: &Polynomial| {
        p.evaluate(|v| values.get(v as usize).cloned().unwrap_or_else(Rational::zero))
    };
    rows.iter()
        .map(|row| {
            let mut dense = vec![Rational::zero(); rows.len()];
            for (j, a) in row {
                if let Some(slot) = dense.get_mut(*j) {
                    *slot = value(a);
                }
            }
            dense
        })
        .collect()
}

/// The parameters that occur, ascending.
pub fn parameters_in(rows: &QuotientRows) -> Vec<usize> {
    let monomials = rows.iter().flat_map(|r| r.values()).flat_map(Polynomial::terms);
    let powers =
        |(m, _): (&Monomial, &Rational)| m.powers().map(|(v, _)| v as usize).collect::<Vec<_>>();
    let mut all: Vec<usize> = monomials.flat_map(powers).collect();
    all.sort_unstable();
    all.dedup();
    all
}
