//! All messages of bad input in one place: `tests/golden/messages.txt`. `CORDON_BLESS=1` writes
//! it anew; read the difference as a user would.
use std::fmt::Write;

use crate::common::run;

/// Calls that are wrong, one a line, words separated by blanks; `''` is an empty word.
const CALLS: &str = "\
trace
trace --eps 1/5
trace --start 0,10,20,30,100
trace --start 0,10,20,30,100 --eps 1/0
trace --start 0,10,20,30,100 --eps abc
trace --start 0,10,20,30,100 --eps 1e99999
trace --start 0,NaN,100 --eps 1/5
trace --start 0,,100 --eps 1/5
trace --start '' --eps 1/5
trace --start 0,100 --eps 1/5
trace --start 2,1,0 --eps 1/5
trace --start 0,1,2 --min 5 --eps 1/5
trace --start 0,1,2 --max 5 --eps 1/5
trace --start 0,10,20,30,100 --eps 1/5 --drones 4
trace --start 0,10,20,30,100 --eps 1/5 --drones four
trace --start 0,10,20,30,100 --eps 1/5 --drones 99999999999999999999999
trace --start 0,10,20,30,100 --eps 1/5 --graph ring
trace --start 0,10,20,30,100 --eps 1/5 --protocol swarm
trace --start 0,10,20,30,100 --eps 1/5 --phase middle
trace --start 0,10,20,30,100 --eps 1/5 --period 0
trace --start 0,10,20,30,100 --eps 1/5 --tau -1
trace --start 0,10,20,30,100 --eps 1/5 --every 0
trace --start 0,10,20,30,100 --eps 1/5 --from 9 --to 3
trace --start 0,10,20,30,100 --eps 1/5 --digits 10001
trace --start 0,10,20,30,100 --eps 1/5 --check 7.9
trace --start 0,30,20,100 --eps 1/5 --check 7.2
trace scenarios/paper.toml --drones 7
trace scenarios/paper.toml --eps x
trace scenarios/paper.toml --format csv --check 7.2
trace scenarios/paper.toml --format json --plot
trace scenarios/paper.toml --at 3 --steps 4
trace scenarios/consensus.toml --check 7.2
trace scenarios/consensus.toml --min 0
trace scenarios/faults.toml
trace tests/cases/cli/drones-as-text.toml
trace tests/cases/cli/unknown-field.toml
trace tests/cases/cli/eps-and-weight.toml
trace tests/cases/cli/table-for-text.toml
trace tests/cases/cli/list-for-text.toml
trace tests/cases/cli/decimal-for-whole.toml
trace scenarios/paper.toml --form paper
trace scenarios/paper.toml --engine jump --steps 3
trace scenarios/paper.toml --verify --steps 3
trace scenarios/paper.toml --format json --numbers fraction
trace scenarios/paper.toml --format itf --digits 3
trace scenarios/paper.toml --numbers fraction --digits 3
trace scenarios/paper.toml --at -1
trace LICENSE-MIT
trace scenarios
trace no-such-file.toml
trace scenarios/own/coverage.toml
trace --protocol scenarios/own/platoon.toml --start 0,0,0,0,0
trace scenarios/paper.toml --protocol formation
threshold --property claims
prove scenarios/own/coverage.toml
separation scenarios/paper.toml --duration 5
separation scenarios/paper.toml --exchange double
export smt2 --protocol scenarios/own/coverage.toml --drones 4
sweep --protocol scenarios/own/coverage-with-losses.toml --grid 12 --steps 9
local scenarios/paper.toml --exchange-every 0
local scenarios/paper.toml --ratio -1
local scenarios/paper.toml --ticks 100001
local scenarios/paper.toml --digits 3 --format json
local scenarios/paper.toml --digits 10001
local scenarios/paper.toml --seed 1
cosim scenarios/paper.toml --master slave
cosim scenarios/paper.toml --integrator rk4
cosim scenarios/paper.toml --exchange morse
cosim scenarios/paper.toml --duration 1.02
cosim scenarios/paper.toml --duration -1
cosim scenarios/paper.toml --duration 0
cosim scenarios/paper.toml --seed -1
cosim scenarios/paper.toml --out target/run.txt
cosim tests/cases/cli/fault-of-no-drone.toml
cosim tests/cases/cli/fault-on-no-link.toml
cosim scenarios/paper.toml --tau 1000
cosim scenarios/paper.toml --out scenarios/paper.toml
cosim scenarios/paper.toml --out no/such/folder/run.csv
replay LICENSE-MIT --out target/x.html
replay no-such-run.csv --out target/x.html
swarm --drones 2
swarm --eps x
swarm --min 5 --max 4
swarm --show 1000001
theorems 8.1
errata 99
sweep 9.9
sweep 7.2 7.3
sweep 7.2 --drones 2..4
sweep 7.2 --drones many
sweep 7.2 --eps 1/0
sweep 7.2 --eps-range 1..0
sweep 7.2 --max-denominator 1000000000
sweep 7.2 --grid 0
sweep 7.2 --sample 0
sweep 7.2 --complete --seed 3
sweep 7.2 --shards 3 --shard 1/2
sweep 7.2 --submit slurm
theorems 7.2 --check
sweep 7.2 --steps 100001
sweep 7.2 --threads 0
sweep 7.2 --shard 4/3
sweep 7.2 --out -
sweep merge Cargo.toml
refute 9.9
refute 7.2 --start 0,1
refute 7.2 --drones 2
refute 7.2 --drones 5..4
refute 7.2 --eps 1..2000
refute 7.2 --steps 1001
refute 7.2 --denominators 0
refute 7.5i --activation
refute 7.2 --delay 20 --drones 40
refute --protocol scenarios/paper.toml
refute --protocol scenarios/own/hasty-coverage.toml --drones 3
prove 9.9
prove 7.2-late
prove 7.2 --drones 2
prove 7.2 --eps 1/2..0
prove 7.8-low --form paper
prove --protocol no-such-file.toml
prove 7.2 --protocol scenarios/own/hasty-coverage.toml
check no-such-file.json
check LICENSE-MIT
threshold --property ordering --drones 2
threshold --property ordering --drones 5 --digits 0
threshold --property ordering --drones 3..5
threshold --property bound --drones 5 --delay 1
threshold --property separation --delay 1
threshold --property ordering --drones 4 --delay 0
threshold --property ordering --drones 4 --delay 1 --digits 9
threshold --property ordering --drones 3..4 --delay 1 --format json
settle --drones 2 --eps 1/4 --within 1
settle --drones 10001 --eps 1/4 --within 1
settle --drones 5 --eps 1/4 --within 0
settle --drones 5 --eps 1/4 --within 1 --start 0,1,2
export smt2 9.9
export smt2 7.2 --drones 2
export smt2 7.2 --eps-range (1/2
export smt2 7.2 --negate --answer LICENSE-MIT
export pvs --scenario scenarios/consensus.toml
export ssp --protocol scenarios/own/coverage-late.toml --start 0,10,20,40 --set eps=1/4 --seed 5 --out drawn.ssp
export into-cps --protocol scenarios/own/coverage-with-losses.toml --start 0,10,20,40 --set eps=1/4 --seed 5 --out drawn
export ssp scenarios/paper.toml --master gauss-seidel --out drawn.ssp
threshold --protocol scenarios/own/hasty-coverage.toml --digits 0
prove --protocol scenarios/own/second-order.toml --steps 100
prove --protocol scenarios/own/hasty-coverage.toml --steps 1000
kani
verify
";

#[test]
fn every_message_is_as_it_was_read() {
    let mut found = String::new();
    for call in CALLS.lines() {
        let args: Vec<&str> =
            call.split(' ').map(|word| if word == "''" { "" } else { word }).collect();
        let (code, out, err) = run(&args);
        assert!(code == 2 || code == 74, "{call}: exit code {code}");
        assert!(!err.contains("panicked"), "{call}: {err}");
        let ours = err.starts_with("error: ") && err.lines().count() == 1;
        if ours {
            let message = err.trim_end();
            // No full stop, no type of the language, not endless.
            assert!(!message.ends_with('.'), "{message}");
            for word in ["usize", "u64", "i128", "f64", "String", "Option", "unwrap", "struct"] {
                assert!(!message.contains(word), "{message}");
            }
            assert!(message.chars().count() < 400, "{message}");
        }
        write!(found, "$ cordon {call}\n{out}{err}({code})\n\n").unwrap();
    }
    let golden = "tests/golden/messages.txt";
    if std::env::var_os("CORDON_BLESS").is_some() {
        std::fs::write(golden, &found).unwrap();
    }
    let expected = std::fs::read_to_string(golden).unwrap();
    for (found, expected) in found.split("\n\n").zip(expected.split("\n\n")) {
        assert_eq!(found, expected);
    }
    assert_eq!(found.len(), expected.len());
    assert_eq!(CALLS.lines().count(), 149);
}
