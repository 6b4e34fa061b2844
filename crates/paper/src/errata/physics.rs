//! Errors in the drone's equations (1) to (4), by exact algebra on the closed loops.

use num_traits::{One, Signed, Zero};

use super::{Erratum, Recomputed, recomputed};
use cordon_core::exact::Rational;

pub(super) const ERRATA: &[Erratum] = &[
    Erratum {
        number: 13,
        place: "equation 1",
        printed: "y'' = -g(phi cos psi_d + theta sin psi_d)",
        compute: lateral_sign,
    },
    Erratum {
        number: 14,
        place: "equation 3",
        printed: "w_z = -(2 lP/C_z) z' + (lP^2/C_z) e_z",
        compute: vertical_sign,
    },
    Erratum {
        number: 15,
        place: "equation 4",
        printed: "three rows of mixing for four rotors",
        compute: mixing,
    },
    Erratum {
        number: 17,
        place: "section 5.2",
        printed: "the complete response of the drone is that of a first-order system",
        compute: not_first_order,
    },
];

fn fraction(num: i32, den: i32) -> Rational {
    Rational::new(num.into(), den.into())
}

/// Coefficients from the constant upward.
type Coefficients = Vec<Rational>;

/// Characteristic polynomial of a horizontal axis in closed loop, s^2 (s^2 + 2 lA s + lA^2) + sign lA^2
/// (2 lP s + lP^2): the attitude loop follows the angle commanded by the position loop. `sign` is the
/// product of two signs: from angle to acceleration in the plant, and from position error to angle in
/// the controller.
fn horizontal(sign: i32) -> Coefficients {
    let (lp, la) = (fraction(2, 5), fraction(4, 1));
    let sign = fraction(sign, 1);
    let two = fraction(2, 1);
    let la2 = &la * &la;
    vec![&sign * &la2 * &lp * &lp, &sign * &la2 * &two * &lp, la2, two * la, Rational::one()]
}

fn evaluate(p: &[Rational], s: &Rational) -> Rational {
    p.iter().rev().fold(Rational::zero(), |sum, c| sum * s + c)
}

/// Whether there is a real root in (0, 1), by a change of sign: an unstable mode.
fn grows(p: &[Rational]) -> bool {
    evaluate(p, &Rational::zero()).is_negative() && evaluate(p, &Rational::one()).is_positive()
}

/// The Routh-Hurwitz criterion for s^4 + a3 s^3 + a2 s^2 + a1 s + a0: all roots have negative real
/// parts.
fn stable_quartic(p: &[Rational]) -> bool {
    let [a0, a1, a2, a3, _] = p else {
        return false;
    };
    let positive = p.iter().all(Signed::is_positive);
    positive && a3 * a2 * a1 > a1 * a1 + a3 * a3 * a0
}

fn lateral_sign() -> Recomputed {
    // At psi_d = 90 degrees y depends on theta alone: sin = 1, cos = 0. The controller's angle
    // has theta_c = -(2 lP y' + lP^2 e_y)/g, so +g theta closes the loop with sign +1.
    let (printed, corrected) = (horizontal(-1), horizontal(1));
    recomputed(
        grows(&printed) && stable_quartic(&corrected),
        "at psi_d = 90 degrees the printed sign closes the y loop with a mode that grows; y'' = -g phi cos psi_d + g theta sin psi_d is stable",
    )
}

fn vertical_sign() -> Recomputed {
    // The rotors add up to w_z, so z'' = C_z w_z = -2 lP z' + lP^2 e_z as printed.
    let lp = fraction(2, 5);
    let loop_with = |sign: i32| -> Coefficients {
        vec![fraction(sign, 1) * &lp * &lp, fraction(2, 1) * &lp, Rational::one()]
    };
    let (printed, corrected) = (loop_with(-1), loop_with(1));
    let stable = corrected.iter().all(Signed::is_positive);
    recomputed(
        grows(&printed) && stable,
        "the printed sign gives s^2 + 2 lP s - lP^2, which has a positive root; with - lP^2 e_z it is (s + lP)^2",
    )
}

/// The effect of the four rotor speeds: lift, roll, pitch, yaw (PROTOCOL section 3, plant).
const EFFECTS: [[i32; 4]; 4] = [[1, 1, 1, 1], [0, 1, 0, -1], [-1, 0, 1, 0], [1, -1, 1, -1]];

/// Four times the mixing of PROTOCOL section 3: rotor speeds from (w_z, w_phi, w_theta, w_psi).
const MIXING: [[i32; 4]; 4] = [[1, 0, -2, 1], [1, 2, 0, -1], [1, 0, 2, 1], [1, -2, 0, -1]];

/// Four times the rows of equation 4 as printed.
const PRINTED_ROWS: [[i32; 4]; 3] = [[1, 0, -2, 1], [1, 0, 2, -1], [1, -2, 0, -1]];

fn mixing() -> Recomputed {
    let entry = |i: usize, j: usize| -> i32 {
        EFFECTS[i].iter().zip(&MIXING).map(|(e, row)| e * row[j]).sum()
    };
    let indices = || (0..4).flat_map(|i| (0..4).map(move |j| (i, j)));
    let inverse = indices().all(|(i, j)| entry(i, j) == if i == j { 4 } else { 0 });
    let right = PRINTED_ROWS.iter().filter(|row| MIXING.contains(row)).count();
    recomputed(
        inverse && PRINTED_ROWS.len() < 4 && right < PRINTED_ROWS.len(),
        format!(
            "of the {} printed rows {right} belong to the inverse of the plant's rotor effects, which needs 4; the four rows of PROTOCOL section 3 are that inverse",
            PRINTED_ROWS.len()
        ),
    )
}

fn not_first_order() -> Recomputed {
    let p = horizontal(1);
    let real = real_roots(&p);
    let order = p.len() - 1;
    recomputed(
        stable_quartic(&p) && order > 1 && real < order,
        format!("along x the loop has order {order} with {real} real poles and a complex pair"),
    )
}

/// The number of distinct real roots, by Sturm's theorem.
fn real_roots(p: &[Rational]) -> usize {
    let mut chain = vec![p.to_vec(), derivative(p)];
    while let [.., a, b] = chain.as_slice() {
        let rest: Coefficients = remainder(a, b).into_iter().map(|c| -c).collect();
        if rest.is_empty() {
            break;
        }
        chain.push(rest);
    }
    let sign_at_infinity = |q: &Coefficients, minus: bool| {
        let odd = q.len().is_multiple_of(2);
        q.last().is_some_and(|c| c.is_positive() != (minus && odd))
    };
    let changes = |minus: bool| {
        let signs: Vec<_> = chain.iter().map(|q| sign_at_infinity(q, minus)).collect();
        signs.iter().zip(signs.iter().skip(1)).filter(|(a, b)| a != b).count()
    };
    changes(true).saturating_sub(changes(false))
}

fn derivative(p: &[Rational]) -> Coefficients {
    let power = |k: usize| Rational::from_integer(k.into());
    p.iter().enumerate().skip(1).map(|(k, c)| c * power(k)).collect()
}

/// The remainder of a division of polynomials, without leading zeros.
fn remainder(a: &[Rational], b: &[Rational]) -> Coefficients {
    let mut rest = a.to_vec();
    let Some(lead) = b.last() else {
        return rest;
    };
    while rest.len() >= b.len() {
        let Some(top) = rest.pop() else {
            break;
        };
        let factor = top / lead;
        let shift = rest.len() + 1 - b.len();
        for (r, c) in rest.iter_mut().skip(shift).zip(b) {
            *r -= &factor * c;
        }
    }
    while rest.last().is_some_and(Zero::is_zero) {
        rest.pop();
    }
    rest
}
