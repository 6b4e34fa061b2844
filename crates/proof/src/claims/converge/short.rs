//! Forms with short numbers, for where many readouts have to vanish: the exact judgement of a dense one is
//! long.
//!
//! If M bounds |A| entry by entry at every corner, M w <= c w and M'v <= c v with v, w > 0, then the diagonal form
//! v_i / w_i falls by c (Schur's test). Where steps are symmetric, so does the sum of squared differences along links: of
//! differences to one agent it is a form with an entry a link.

use num_traits::{FromPrimitive, One, Zero};

use crate::claims::doubles::{Matrix, identity, inverse, plus, transposed};
use cordon_core::Rational;

/// What the least entry of a diagonal form is.
const LEAST: f64 = 64.0;

/// Forms that may fall by the rate under all maps, their lower triangles.
pub fn forms(maps: &[(usize, Matrix)], rate: f64) -> Vec<Vec<Vec<Rational>>> {
    let Some((_, first)) = maps.first() else { return Vec::new() };
    let (zero, one) = (Rational::zero(), Rational::one());
    let n = first.len();
    let lower = |entry: &dyn Fn(usize, usize) -> Rational| {
        (0..n).map(|i| (0..=i).map(|j| entry(i, j)).collect()).collect()
    };
    let of_diagonal = |d: Vec<Rational>| {
        lower(&|i, j| if i == j { d.get(i).cloned().unwrap_or_default() } else { zero.clone() })
    };
    let plain = of_diagonal(vec![one.clone(); n]);
    let weighted = weights(maps, n, rate).map(of_diagonal);
    let links = links(first).map(|l| lower(&|i, j| l[i][j].clone()));
    weighted.into_iter().chain([plain]).chain(links).collect()
}

/// The form of differences along links, in whole numbers, if there is a link. In every column of the map what most rows have is taken
/// from agent 0, and the rest is the links' weights.
fn links(map: &Matrix) -> Option<Vec<Vec<Rational>>> {
    let n = map.len();
    let column = |j: usize| {
        let mut others: Vec<f64> = (0..n).filter(|i| *i != j).map(|i| map[i][j]).collect();
        others.sort_by(f64::total_cmp);
        others.get(others.len() / 2).copied().unwrap_or_default()
    };
    let common: Vec<f64> = (0..n).map(column).collect();
    let between = |i: usize, j: usize| (map[i][j] - common[j] + map[j][i] - common[i]) / 2.0;
    let weights: Matrix = (0..n)
        .map(|i| (0..n).map(|j| if i == j { -common[j] } else { between(i, j) }).collect())
        .collect();
    let positive = weights.iter().flatten().filter(|w| **w > 1e-9);
    let least = positive.copied().fold(f64::INFINITY, f64::min);
    let whole = |x: f64| {
        Some(Rational::from_integer(num_bigint::BigInt::from_f64((x / least * LEAST).round())?))
    };
    // On the diagonal all links of an agent, that to agent 0 among them.
    let entry =
        |i: usize, j: usize| whole(if i == j { weights[i].iter().sum() } else { -weights[i][j] });
    (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
}

/// The diagonal, in whole numbers.
fn weights(maps: &[(usize, Matrix)], n: usize, rate: f64) -> Option<Vec<Rational>> {
    let mut bound = vec![vec![0.0_f64; n]; n];
    for (_, map) in maps {
        for (bound, row) in bound.iter_mut().zip(map) {
            bound.iter_mut().zip(row).for_each(|(b, x)| *b = b.max(x.abs()));
        }
    }
    // (1 - M/c) w = 1 has w > 0 and M w <= c w where c is above the radius; the transpose has v.
    let resolvent = inverse(&plus(&identity(n), -1.0 / rate, &bound))?;
    let sums = |m: &Matrix| -> Vec<f64> { m.iter().map(|row| row.iter().sum()).collect() };
    let ratios: Vec<f64> =
        sums(&transposed(&resolvent)).iter().zip(sums(&resolvent)).map(|(v, w)| v / w).collect();
    let least = ratios.iter().copied().fold(f64::INFINITY, f64::min);
    let is_sound = resolvent.iter().flatten().all(|x| *x >= -1e-9) && least > 0.0;
    let whole = |x: &f64| {
        Some(Rational::from_integer(num_bigint::BigInt::from_f64((x / least * LEAST).round())?))
    };
    is_sound.then(|| ratios.iter().map(whole).collect()).flatten()
}
