//! Cones that are invariant under a linear system and on which its readouts are nonnegative.

use cordon_core::Rational;
use cordon_core::exact::to_f64;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Premises, Sign};
use cordon_core::linear::matrix::{Matrix, before};
use num_bigint::BigInt;
use num_complex::Complex;
use num_traits::{One, Pow, Signed, Zero};

use super::Response;
use super::modes::{Mode, modes};

/// Rows F with F A = M F and M >= 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cone {
    /// F: the cone is the set where F x >= 0.
    pub rows: Matrix,
    /// The nonnegative matrix M of F A = M F.
    pub multipliers: Matrix,
    /// The readouts as nonnegative combinations of the rows.
    pub readouts: Matrix,
    /// The step from which every start is in the cone.
    pub entered: usize,
}

/// Decimal places of the rows, in units of a column's largest entry, tried in turn.
const DIGITS: [usize; 3] = [5, 7, 9];

/// Factors by which the cone is wider than the readouts need.
const WIDTHS: [f64; 2] = [1.05, 1.3];

/// Most corners of the polygons around the slowest mode.
const MOST_CORNERS: usize = 200;

impl Cone {
    /// Whether all fields are as stated, exactly, except `entered`.
    pub fn is_kept_by(&self, response: &Response) -> bool {
        let nonnegative = |m: &Matrix| m.iter().flatten().all(|x| !x.is_negative());
        let combined = |m: &Matrix| m.iter().map(|row| before(row, &self.rows)).collect::<Matrix>();
        let after: Matrix = self.rows.iter().map(|row| before(row, &response.matrix)).collect();
        nonnegative(&self.multipliers)
            && nonnegative(&self.readouts)
            && combined(&self.multipliers) == after
            && combined(&self.readouts) == response.readouts
    }
}

/// A cone for the response. `None` where its slowest mode is not a positive number, or no cone was
/// found.
pub(super) fn find(response: &Response) -> Option<Cone> {
    let modes = modes(&response.matrix, &response.readouts)?;
    let attempts = WIDTHS.iter().flat_map(|width| DIGITS.map(|digits| (*width, digits)));
    attempts
        .filter_map(|(width, digits)| {
            let rows = rounded(&suggested(&modes, width)?, digits)?;
            judged(response, rows)
        })
        .find(|cone| cone.is_kept_by(response))
}

/// The cone of these rows, if it is invariant and the readouts are nonnegative combinations of the
/// rows.
fn judged(response: &Response, rows: Matrix) -> Option<Cone> {
    let nonnegative = |row: &Vec<Rational>| Constraint {
        form: Affine::new(Rational::zero(), row.clone()),
        sign: Sign::NonNegative,
    };
    let given: Vec<Constraint> = rows.iter().map(nonnegative).collect();
    let premises = Premises::new(&given)?;
    let combination = |row: &Vec<Rational>| premises.multipliers(&nonnegative(row));
    let readouts = response.readouts.iter().map(combination).collect::<Option<Matrix>>()?;
    let after = rows.iter().map(|row| before(row, &response.matrix));
    let multipliers = after.map(|row| combination(&row)).collect::<Option<Matrix>>()?;
    Some(Cone { rows, multipliers, readouts, entered: 0 })
}

/// Rows around the slowest mode: plus and minus each real mode, and for a conjugate pair the corners of
/// a polygon, far enough out for every readout to be a mean of them.
fn suggested(modes: &[Mode], width: f64) -> Option<Vec<Vec<f64>>> {
    let (slowest, others) = modes.split_first()?;
    let slowest_factor = slowest.factor.re;
    if slowest.factor.im != 0.0 || slowest_factor <= 0.0 {
        return None;
    }
    let heads: Vec<f64> = slowest.shares.iter().map(|s| s.re).collect();
    if heads.iter().any(|head| *head <= 0.0) {
        return None;
    }
    // Readouts are means of rows: the slower a mode, the more weight its rows have and the narrower
    // they are, so that the cone is entered early.
    let slowness = |mode: &Mode| 1.0 / (1.0 - mode.factor.norm_sqr().sqrt() / slowest_factor);
    let total: f64 = others.iter().map(slowness).sum();
    let mut rows = Vec::new();
    for mode in others {
        let reach = width * total / slowness(mode);
        let shares: Vec<_> = mode.shares.iter().zip(&heads).map(|(s, head)| s / head).collect();
        let corners = if mode.factor.im == 0.0 {
            let size = shares.iter().fold(0.0_f64, |m, s| m.max(s.re.abs()));
            // A real mode counts once, one of a pair twice.
            [0.5, -0.5].map(|s| Complex::new(s * size * reach, 0.0)).to_vec()
        } else {
            let polygon = Polygon::turned_by(mode.factor / slowest_factor)?;
            let size = shares.iter().fold(0.0_f64, |m, s| m.max(polygon.gauge(*s)));
            polygon.corners.iter().map(|c| c * size * reach).collect()
        };
        for corner in corners {
            let parts = slowest.row.iter().zip(&mode.row);
            rows.push(parts.map(|(l, r)| l.re + 2.0 * (corner * r).re).collect());
        }
    }
    Some(rows)
}

/// A regular polygon with a corner at 1.
struct Polygon {
    corners: Vec<Complex<f64>>,
    /// Directions of the edges' normals, divided by their distance.
    normals: Vec<Complex<f64>>,
}

impl Polygon {
    /// The polygon with the fewest corners that multiplication by `factor` maps well into itself.
    fn turned_by(factor: Complex<f64>) -> Option<Self> {
        let size = factor.norm_sqr().sqrt();
        let slack = 0.1 * (1.0 - size);
        if slack <= 1e-7 {
            return None;
        }
        (3..=MOST_CORNERS).map(Self::regular).find(|p| p.gauge(factor) <= 1.0 - slack)
    }

    fn regular(count: usize) -> Self {
        let angle = std::f64::consts::PI / count as f64;
        let half = cis(angle);
        let corners = (0..count).map(|k| cis(2.0 * angle * k as f64)).collect::<Vec<_>>();
        let normals = corners.iter().map(|c| c * half / half.re).collect();
        Self { corners, normals }
    }

    /// The factor by which the polygon has to be scaled to reach a point.
    fn gauge(&self, point: Complex<f64>) -> f64 {
        self.normals.iter().fold(0.0_f64, |m, n| m.max((point * n.conj()).re))
    }
}

/// cos + i sin, by the power series: the same on every machine.
fn cis(angle: f64) -> Complex<f64> {
    let (mut sum, mut term) = (Complex::<f64>::zero(), Complex::<f64>::one());
    for k in 1..60 {
        sum += term;
        term *= Complex::new(0.0, angle / f64::from(k));
    }
    sum
}

/// The rows as decimal fractions.
fn rounded(rows: &[Vec<f64>], digits: usize) -> Option<Matrix> {
    let width = rows.first()?.len();
    let largest = |j: usize| rows.iter().fold(0.0_f64, |m, row| m.max(row[j].abs()));
    let units: Vec<Rational> =
        (0..width).map(|j| unit(largest(j), digits)).collect::<Option<_>>()?;
    let entry =
        |(x, unit): (&f64, &Rational)| Some((Rational::from_float(*x)? / unit).round() * unit);
    rows.iter().map(|row| row.iter().zip(&units).map(entry).collect()).collect()
}

/// The power of ten `digits` places below the largest entry.
fn unit(largest: f64, digits: usize) -> Option<Rational> {
    if !largest.is_finite() || largest <= 0.0 {
        return Some(Rational::one());
    }
    let ten = Rational::from_integer(10.into());
    let mut power = Rational::one();
    while to_f64(&power) > largest {
        power /= &ten;
    }
    while to_f64(&(&power * &ten)) <= largest {
        power *= &ten;
    }
    Some(power / Rational::from_integer(BigInt::from(10).pow(digits)))
}
