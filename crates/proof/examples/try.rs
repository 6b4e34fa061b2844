use cordon_proof::claims::*;
fn main() {
    for f in std::env::args().skip(1) {
        let t = std::time::Instant::now();
        let file = match cordon_run::protocol::read(std::path::Path::new(&f)) {
            Ok(f) => f,
            Err(e) => {
                println!("{e}");
                continue;
            }
        };
        let n =
            std::env::var("N").ok().and_then(|n| n.parse().ok()).unwrap_or(file.agents.fewest());
        let s = match file.with_agents(n) {
            Ok(s) => s,
            Err(e) => {
                println!("{e}");
                continue;
            }
        };
        println!(
            "{f}: {} agents {} vars {:?} params {} modes, vacuous {}",
            s.agents,
            s.state.len(),
            s.parameters.iter().map(|p| &p.name).collect::<Vec<_>>(),
            s.modes.len(),
            is_vacuous(&s)
        );
        if s.converges.is_some() {
            let t = std::time::Instant::now();
            match converge::contraction(&s) {
                Ok(Some(c)) => println!("  converges {} {:?}", c.rate, t.elapsed()),
                Ok(None) => println!("  no contraction {:?}", t.elapsed()),
                Err(e) => println!("{e}"),
            };
            match converge::grows(&s) {
                Ok(Some(g)) => println!(
                    "  grows from {:?}",
                    g.start.iter().map(|x| x.to_string()).collect::<Vec<_>>()
                ),
                Ok(None) => println!("  no growth"),
                Err(e) => println!("{e}"),
            }
        }
        match prove(&s) {
            Some(p) => {
                println!("  proved {} rows {:?}", p.proof.rows.len(), t.elapsed());
            }
            None => {
                println!("  not proved {:?}", t.elapsed());
                let c = constants(&s, 8).unwrap();
                let (r, k) = refute(&s, &c, None, 8);
                match r {
                    Some(r) => println!(
                        "  refuted at {:?} step {} claim {} start {:?}",
                        r.values.iter().map(|x| x.to_string()).collect::<Vec<_>>(),
                        r.step,
                        s.claims[r.claim].predicate.text,
                        r.states[0].iter().map(|x| x.to_string()).collect::<Vec<_>>()
                    ),
                    None => println!("  open, none up to {k}"),
                };
                println!("  {:?}", t.elapsed())
            }
        }
    }
}
