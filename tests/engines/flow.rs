//! Claims in continuous time: what is proved, what is not, and what is refused by name.

use cordon_core::exact::to_f64;
use cordon_proof::certificate;
use cordon_proof::flow::{Answer, Invariant, prove};
use cordon_run::protocol::{ProtocolFile, parse, read};

fn spring() -> String {
    std::fs::read_to_string("benchmarks/pushed-spring.toml").unwrap()
}

fn of(text: &str) -> ProtocolFile {
    parse("own", text).unwrap()
}

fn answer(text: &str) -> Answer {
    let file = of(text);
    prove(&file.flow(file.agents.fewest()).unwrap()).unwrap()
}

/// The claims are proved, by a certificate that says so of these runs.
fn proved(text: &str, who: &str) -> Invariant {
    let Answer::Proved(found) = answer(text) else { panic!("{text}") };
    let said = certificate::judged(&found.certificate).unwrap();
    assert!(said.contains(&format!("proved of {who}")), "{said}");
    assert!(said.contains("at every time: 3 + x0 >= 0 and 3 >= x0"), "{said}");
    *found
}

#[test]
fn every_way_of_switching_is_proved_with_room_to_spare() {
    let any = spring().replace("dwell = 2\n", "");
    let turns = spring().replace("dwell = 2\n", "switching = [\"strong\", \"weak\"]\nevery = 2\n");
    let one = proved(&any, "every run, whatever mode acts at each time");
    assert_eq!(one.ellipsoids, 1);
    let dwelling =
        proved(&spring(), "the runs that start at strong or weak, along strong -strong-> strong");
    let turning =
        proved(&turns, "the runs that start at strong.0, along strong.0 -strong for 1-> strong.1");
    for found in [one, dwelling, turning] {
        let spare = to_f64(&found.spare);
        assert!((1.0..2.0).contains(&spare), "{spare}");
    }
}

/// One ellipsoid decides the competition's instances of arbitrary switching, and goes well beyond -42.
#[test]
fn the_platoon_is_proved() {
    let file = read("benchmarks/arch-comp/plaa01-bnd42.toml".as_ref()).unwrap();
    let Answer::Proved(found) = prove(&file.flow(3).unwrap()).unwrap() else { panic!("open") };
    assert!(to_f64(&found.spare) > 10.0, "{}", found.spare);
}

#[test]
fn what_is_false_is_not_proved() {
    // At rest under a push of 1 the body is at 1.
    let tight = spring().replace("-3 <= x <= 3", "-1/2 <= x <= 1/2");
    assert!(matches!(answer(&tight), Answer::Missed(_, by) if by > 0.0));
    let rising = spring().replace("-x - v + push", "-x + v + push");
    assert!(matches!(answer(&rising), Answer::Open));
    let outside = spring().replace("0 <= x <= 1/2", "0 <= x <= 4");
    assert!(matches!(answer(&outside), Answer::Missed(_, by) if by > 0.0));
}

#[test]
fn what_is_about_steps_is_refused_by_name() {
    let file = of(&spring());
    let refused = file.system().unwrap_err().to_string();
    assert!(
        refused.contains(":8: time: `continuous`: expected a protocol that acts in steps"),
        "{refused}"
    );
    let changed = |from: &str, to: &str| {
        let text = spring().replace(from, to);
        match parse("own", &text) {
            Err(e) => e.to_string(),
            Ok(file) => match file.flow(1).and_then(|f| prove(&f).map(|_| ())) {
                Err(e) => e.to_string(),
                Ok(()) => panic!("{text}"),
            },
        }
    };
    let cases = [
        (("dwell = 2", "dwell = 0"), "dwell: `0`: expected a time above 0"),
        (("dwell = 2", "every = 2"), "every: expected `switching` too"),
        (("dwell = 2", "switching = [\"weak\"]"), "switching: expected `every` too"),
        (
            ("time = \"continuous\"", ""),
            "expected `time = \"continuous\"` with a time between switches",
        ),
        (
            ("time = \"continuous\"", "time = \"discrete\""),
            "time: `discrete`: expected `steps` or `continuous`",
        ),
        (
            ("[parameters]", "[departures]\ndelay = 1\n[parameters]"),
            "departures.delay: expected none in continuous time",
        ),
        (
            ("[parameters]", "[departures]\nskip = true\n[parameters]"),
            "departures.skip: expected none in continuous time",
        ),
        (("\"-3 <= x <= 3\"", "\"x = 0\""), "claims: `x = 0"),
        (
            ("\"-3 <= x <= 3\"", "{ holds = \"x <= 3\", from = 2 }"),
            "expected no `from` and no `until`",
        ),
        (("\"v = 0\"", "\"x + v = 0\""), "expected bounds of single variables"),
        (("\"v = 0\"", "\"v >= 0\""), "start: `v0` has no bounds"),
        (("0 <= x <= 1/2", "1 <= x <= 1/2"), "start: `x0` is at least 1 and at most 1/2"),
        (
            ("claims = [\"-3 <= x <= 3\"]", "converges = \"agreement\""),
            "converges: expected `claims` in continuous time",
        ),
    ];
    for ((from, to), message) in cases {
        assert!(spring().contains(from), "{from}");
        let found = changed(from, to);
        assert!(found.contains(message), "{found}\nexpected {message}");
    }
}
