//! A protocol of your own as a Rust type: traced, proved, and refuted.
//!
//! `cargo run --release --example own`
#![allow(clippy::print_stdout)]

use cordon::spec::Scalar;
use cordon::system::{Claim, Parameter, ParameterKind, Predicate, Protocol, System};
use cordon::{Rational, Result};

/// Vehicles in a row; each closes up to the middle between itself and the one before it.
struct Followers {
    count: usize,
}

impl Protocol for Followers {
    fn agents(&self) -> usize {
        self.count
    }

    fn parameters(&self) -> Vec<Parameter> {
        let (low, high) = (Rational::from_int(0), Rational::from_int(2));
        vec![Parameter { name: "gain".to_owned(), low, high, kind: ParameterKind::Constant }]
    }

    fn step<S: Scalar>(&self, _: &impl Fn(&Rational) -> S, p: &[S], x: &[S]) -> Vec<S> {
        let pulled = x.windows(2).map(|w| w[1].clone() + &(p[0].clone() * &(w[0].clone() - &w[1])));
        x.first().cloned().into_iter().chain(pulled).collect()
    }
}

fn main() -> Result<()> {
    let mut system = System::of(&Followers { count: 4 })?;
    let start = [4, 2, 1, 0].map(Rational::from_int);
    let run = system.run(&[Rational::new(1.into(), 2.into())], &start, 3);
    println!(
        "after 3 steps: {}",
        run[3].iter().map(Rational::to_string).collect::<Vec<_>>().join(", ")
    );
    // Nobody passes the one before.
    for i in 1..system.agents {
        let predicate = Predicate::parse(&system, &format!("x{i} <= x{}", i - 1))?;
        system.starts.push(predicate.clone());
        system.claims.push(Claim { predicate, from: 0, until: None });
    }
    match cordon::refute_claims(&system, 5) {
        Some(run) => println!("gain {}: fails at step {}", run.values[0], run.step),
        None => println!("no counterexample"),
    }
    system.parameters[0].high = Rational::from_int(1);
    if let Some(certificate) = cordon::prove_claims(&system)? {
        println!("gain up to 1: {}", cordon::check_certificate(&certificate));
    }
    Ok(())
}
