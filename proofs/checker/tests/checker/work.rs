//! Work is counted as FORMAT.md says, so that a file's cost is known before it is checked.

use cordon_check::check;
use cordon_check::expr::{Literal, Relation, Sort};
use cordon_check::format::{Linear, Positivity, Proof};
use cordon_check::kernel::{Clause, Kernel};
use cordon_check::linear::System;
use cordon_check::matrix::{definite, dot};
use cordon_check::number::{MAX_NUMBER, MAX_WORK, Number, charge, done, exhausted, refill, spend};
use cordon_check::poly::Poly;
use cordon_spec::{Ordered, Scalar};
use serde_json::json;

fn cost<T>(f: impl FnOnce() -> T) -> u64 {
    refill();
    f();
    done()
}

/// base^exponent
fn power(base: u32, exponent: u32) -> String {
    num_bigint::BigUint::from(base).pow(exponent).to_string()
}

fn number(text: &str) -> Number {
    Number::read(text).unwrap()
}

#[test]
fn an_operation_costs_the_square_of_its_length() {
    refill();
    // 193 and 140 bits; 65 bits below.
    let wide = number(&format!("{}/{}", power(2, 192), power(3, 41)));
    let whole = number(&power(5, 60));
    let narrow = number(&format!("1/{}", power(3, 41)));
    let of = |words: u64| 256 + 192 * words + words * words;
    for (a, b, expected) in
        [(&wide, &whole, of(6)), (&wide, &narrow, of(5)), (&whole, &whole, 128 + 4 * 4 / 8)]
    {
        assert_eq!(cost(|| a.clone() + b), expected);
        assert_eq!(cost(|| a.clone() - b), expected);
        assert_eq!(cost(|| a.clone() * b), expected);
        assert_eq!(cost(|| a.over(b)), expected);
        assert_eq!(cost(|| a.compare(b)), expected);
    }
    // With denominators and without: what is computed.
    assert_eq!(number("1/2") + &number("1/3"), number("5/6"));
    assert_eq!(number("7") - &number("9"), number("-2"));
    assert_eq!(number("-7") * &number("1/7"), number("-1"));
    assert_eq!(number("6").over(&number("-4")), Some(number("-3/2")));
    assert_eq!(number("1").over(&number("0")), None);
}

#[test]
fn a_number_costs_the_square_of_what_is_read() {
    assert_eq!(cost(|| number(&"7".repeat(63))), 0);
    assert_eq!(cost(|| number(&"7".repeat(640))), 100);
    assert_eq!(number(&"7".repeat(MAX_NUMBER)), number(&"7".repeat(MAX_NUMBER)));
    assert!(Number::read(&"7".repeat(MAX_NUMBER + 1)).is_err());
}

#[test]
fn the_last_unit_is_not_to_be_had() {
    refill();
    assert!(spend(MAX_WORK - 1).is_ok() && !exhausted());
    assert_eq!(done(), MAX_WORK - 1);
    assert!(!charge(1) && exhausted() && spend(0).is_err());
    let two = Number::whole(2);
    assert_eq!(two.clone() + &two, Number::whole(0));
    assert_eq!(two.compare(&two), None);
    assert_eq!(done(), MAX_WORK);
}

#[test]
fn a_copy_costs_its_atoms() {
    let (a, b) = (Poly::var("a"), Poly::var("b"));
    // With what is done to the coefficients.
    assert_eq!(cost(|| a.clone() + &b), 128 * 2);
    assert_eq!(cost(|| a.clone() + &a), 128 * (2 + 1));
    assert_eq!(cost(|| a.clone() - &b), 128 * (2 + 1));
    assert_eq!(cost(|| a.clone() - &a), 128 * (2 + 1 + 1));
    assert_eq!(cost(|| a.clone() * &b), 128 * (3 + 1));
    // f(a + 1): itself, and in its term two monomials and an atom.
    let one = Poly::from_int(1);
    let f = Poly::app("f", &[a.clone() + &one]);
    assert_eq!(f.size(), 5);
    assert_eq!(cost(|| b.clone() + &f), 128 * 5);
    assert_eq!(cost(|| f.clone() * &f), 128 * (1 + 8 + 1));
    // Where nothing is put into the places of atoms, itself and its term are copied.
    assert_eq!(cost(|| f.with(&|_| None)), 128 * (5 + 3));
}

#[test]
fn zeros_of_a_product_cost_no_operation() {
    let (zero, one) = (Number::whole(0), Number::whole(1));
    assert_eq!(cost(|| dot(&[zero.clone(), one.clone()], &[one.clone(), zero.clone()])), 2);
    assert_eq!(cost(|| dot(std::slice::from_ref(&one), std::slice::from_ref(&one))), 1 + 2 * 128);
}

#[test]
fn entries_of_an_elimination_stay_short() {
    // Hilbert's matrix, definite by little. Without the division entries would double in length from row to row.
    let entry = |i: i64, j| Number::whole(1).over(&Number::whole(i + j + 1)).unwrap();
    let hilbert: Vec<Vec<Number>> =
        (0..20).map(|i| (0..20).map(|j| entry(i, j)).collect()).collect();
    assert!(cost(|| assert!(definite(&hilbert, true))) < 2_000_000, "{}", done());
}

#[test]
fn a_step_costs_its_clause_and_a_name_its_variables() {
    let by = |sum: &str| {
        Proof::Positivity(Positivity { r#use: Vec::new(), times: Vec::new(), sum: sum.into() })
    };
    let says = |poly| Literal { poly, relation: Relation::NonNegative };
    let kernel = Kernel::default();
    // The token of the sum is 128 of it.
    let mut clause = Clause::fact(says(Poly::default()));
    let of = |clause: &Clause| cost(|| kernel.check(clause, &by("0")).unwrap());
    assert_eq!(of(&clause), 128 + 128);
    clause.vars = ["p", "q", "r"].map(|v| (v.into(), Sort::Real)).to_vec();
    assert_eq!(of(&clause), 128 * 4 + 128);
    clause.given.insert("g".into(), says(Poly::var("p")));
    assert_eq!(of(&clause), 128 * (4 + 3) + 128);
    assert_eq!(cost(|| kernel.fresh("s", &clause.vars).unwrap()), 128 + 3);
    assert!(kernel.fresh("q", &clause.vars).is_err());
}

#[test]
fn a_vertex_and_a_row_of_a_run_cost_what_they_are() {
    let system = json!({ "state": ["x"], "parameters": { "d": ["0", "1"] }, "modes": { "m": {} } });
    let written: Linear = serde_json::from_value(system).unwrap();
    refill();
    let system = System::read(&written).unwrap();
    // The parameter's own 128; a copy and a product of constants for the end that is not 0.
    assert_eq!(cost(|| system.vertices(&[Poly::var("d")]).unwrap()), 128 + 128 + 128);
    let run = |steps: usize| {
        let names = ["a", "b", "c", "d", "e"];
        let rows: serde_json::Value = names.iter().map(|n| ((*n).to_owned(), json!("0"))).collect();
        let body = json!({
            "system": { "state": names, "modes": { "m": rows } }, "start": vec!["1"; 5], "claim": "a > 0",
            "steps": vec![json!({ "by": "m" }); steps],
        });
        let page =
            json!({ "schema": "cordon-certificate/2", "certificate": { "counterexample": body } });
        assert_eq!(check(&page.to_string()).code(), 0);
        done()
    };
    assert_eq!(run(3) - run(2), 128 * 5);
}
