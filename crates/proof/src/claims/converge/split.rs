//! A form that grows, guessed in doubles: positive on what grows, negative on what shrinks.
//!
//! What grows is a combination of readouts: the left invariant subspace of the eigenvalues beyond the unit
//! circle, found by orthogonal iteration (Golub and Van Loan, Matrix computations, 7.3). In a basis Q of it and of what is
//! orthogonal to it A' is block triangular, with blocks T and U. With S the solution of TST' - S = 1 and Y that of
//! Y - UYU' = 1 the form c QSQ' - QYQ' grows in every direction, for c large enough.

use crate::claims::doubles::{
    Matrix, dot, fine_spectral_radius, identity, image, images_of_unit, inverse, largest, moved,
    negative_direction, plus, product, transposed,
};

/// Most rounds of the iteration.
const MOST_ROUNDS: usize = 60;

/// What a round may magnify: beyond, what grows less is lost in rounding.
const MOST_MAGNIFIED: f64 = 1e4;

/// By how much a form has to grow in every direction, its largest entry being 1, so as to be rounded: the more the
/// coarser.
const MARGINS: [f64; 5] = [1e-2, 1e-3, 1e-5, 1e-7, 1e-11];

/// What of one block may be left in the other.
const NEGLIGIBLE: f64 = 1e-9;

/// A form P with a'Pa - P > 0, its largest entry being 1, if something grows and nothing else stays as it is.
pub fn growing_form(a: &Matrix) -> Option<Matrix> {
    let backwards = transposed(a);
    let (radius, n) = (fine_spectral_radius(a), a.len());
    if radius <= 1.0 {
        return None;
    }
    let mut round = backwards.clone();
    let mut magnified = radius;
    while magnified * magnified < MOST_MAGNIFIED && largest(&round) < MOST_MAGNIFIED {
        round = product(&round, &round);
        magnified *= magnified;
    }
    // Vectors as rows.
    let mut basis: Matrix = (0..n).map(|k| direction(k, n)).collect();
    for _ in 0..MOST_ROUNDS {
        basis = orthonormal(basis.iter().map(|v| image(&round, v)).collect());
        if let Some(form) = divided(a, &backwards, &basis) {
            return Some(form);
        }
    }
    None
}

/// The form for a basis whose first vectors span what grows, if some do.
fn divided(a: &Matrix, backwards: &Matrix, basis: &Matrix) -> Option<Matrix> {
    let n = basis.len();
    // basis * A' * basis', transposed: row i holds what becomes of vector i.
    let become_: Matrix = basis.iter().map(|v| image(backwards, v)).collect();
    let blocks: Matrix =
        basis.iter().map(|v| become_.iter().map(|w| dot(v, w)).collect()).collect();
    let scale = largest(&blocks);
    let rest = |r: usize| {
        let below = blocks.iter().skip(r).flat_map(|row| row.iter().take(r));
        below.fold(0.0_f64, |m, x| m.max(x.abs()))
    };
    let block = |from: usize, to: usize| -> Matrix {
        blocks[from..to].iter().map(|row| row[from..to].to_vec()).collect()
    };
    let divides = |r: &usize| {
        rest(*r) <= NEGLIGIBLE * scale
            && fine_spectral_radius(&block(*r, n)) < 1.0
            && inverse(&block(0, *r)).is_some_and(|back| fine_spectral_radius(&back) < 1.0)
    };
    // What grows is first: the least place at which the rest shrinks.
    let r = (1..=n).filter(|r| rest(*r) <= NEGLIGIBLE * scale).find(divides)?;
    let back = transposed(&inverse(&block(0, r))?);
    let grown = plus(&images_of_unit(&back), -1.0, &identity(r));
    let shrunk = images_of_unit(&transposed(&block(r, n)));
    let spread = |form: &Matrix, vectors: &[Vec<f64>]| moved(&vectors.to_vec(), form);
    let positive = spread(&grown, &basis[..r]);
    let negative = if r < n { spread(&shrunk, &basis[r..]) } else { vec![vec![0.0; n]; n] };
    let with = |factor: f64| {
        let form = plus(&negative, -factor, &positive);
        let scale = -largest(&form);
        let form: Matrix = form.iter().map(|row| row.iter().map(|x| x / scale).collect()).collect();
        scale.is_finite().then_some(form)
    };
    let rises = |form: &Matrix, margin: f64| {
        negative_direction(&plus(&moved(a, form), -1.0, form), margin).is_none()
    };
    let factors = || (0..16).filter_map(|k| with(4f64.powi(k)));
    MARGINS.iter().find_map(|margin| factors().find(|form| rises(form, *margin)))
}

/// A direction that no structure of a map prefers.
fn direction(k: usize, n: usize) -> Vec<f64> {
    (0..n).map(|j| ((k * n + j + 1) as f64).powi(2).sin()).collect()
}

/// The vectors made orthonormal, the first first (Gram and Schmidt, twice for the sake of rounding).
fn orthonormal(mut vectors: Matrix) -> Matrix {
    let n = vectors.len();
    for k in 0..n {
        let (done, rest) = vectors.split_at_mut(k);
        let Some(v) = rest.first_mut() else { break };
        let mut fallback = 1;
        loop {
            let before = dot(v, v).sqrt();
            for _ in 0..2 {
                for u in done.iter() {
                    let part = dot(u, v);
                    v.iter_mut().zip(u).for_each(|(x, y)| *x -= part * y);
                }
            }
            let norm = dot(v, v).sqrt();
            if norm > 1e-13 * before && norm > 0.0 || fallback > n {
                v.iter_mut().for_each(|x| *x /= norm);
                break;
            }
            // Nothing is left of it: any other direction.
            *v = direction(k + n * fallback, n);
            fallback += 1;
        }
    }
    vectors
}

#[cfg(test)]
mod tests {
    use super::{growing_form, moved, negative_direction, plus};
    use crate::claims::doubles::Matrix;

    fn grows(a: &Matrix) -> bool {
        growing_form(a).is_some_and(|p| {
            let rises = negative_direction(&plus(&moved(a, &p), -1.0, &p), 0.0).is_none();
            rises
                && negative_direction(
                    &p.iter().map(|r| r.iter().map(|x| -x).collect()).collect(),
                    0.0,
                )
                .is_some()
        })
    }

    #[test]
    fn what_grows_is_found_beside_what_shrinks() {
        // Eigenvalues 2 and 1/2; a turn by 1.01 beside 0.9; three that grow; near 1 on both sides.
        let cases: [Matrix; 5] = [
            // What is forgotten at once, first.
            vec![vec![0.0, 0.0, 0.0], vec![1.0, 1.5, 0.0], vec![0.0, 1.0, 0.25]],
            vec![vec![2.0, 5.0], vec![0.0, 0.5]],
            vec![vec![0.0, -1.01, 3.0], vec![1.01, 0.0, 1.0], vec![0.0, 0.0, 0.9]],
            vec![vec![1.5, 1.0, 0.0], vec![0.0, 1.5, 1.0], vec![0.0, 0.0, 1.1]],
            vec![vec![1.0005, 1.0], vec![0.0, 0.9995]],
        ];
        for (k, a) in cases.iter().enumerate() {
            assert!(grows(a), "case {k}");
        }
    }

    #[test]
    fn what_shrinks_or_stays_has_no_growing_form() {
        for a in [vec![vec![0.9, 1.0], vec![0.0, 0.9]], vec![vec![1.0, 0.0], vec![0.0, 0.5]]] {
            assert!(growing_form(&a).is_none());
        }
    }
}
