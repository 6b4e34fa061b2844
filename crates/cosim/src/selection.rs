//! The variables of units that are recorded besides the positions, selected by patterns over their
//! names.

use super::record::Series;
use super::unit::{Kind, Unit, Variable};
use cordon_core::text::cut;
use cordon_core::{Error, Result};
use cordon_run::scenario::UnitName;

/// The recorded variables of one unit.
pub(super) struct Selected {
    /// Index of the unit.
    pub unit: usize,
    /// Indices of its variables.
    pub variables: Vec<usize>,
}

/// The numeric variables of these units whose `unit.variable` matches one of the patterns: `*` stands
/// for any text, `?` for any character. The series of all units, one after another, are still empty.
///
/// # Errors
/// A pattern matches no numeric variable.
pub(super) fn select(
    patterns: &[String],
    units: &[Box<dyn Unit>],
) -> Result<(Vec<Selected>, Vec<Series>)> {
    let (mut selected, mut series) = (Vec::new(), Vec::new());
    let mut used = vec![false; patterns.len()];
    for (index, unit) in units.iter().enumerate() {
        let mut variables = Vec::new();
        for (variable, v) in unit.variables().iter().enumerate() {
            let name = format!("{}.{}", unit.name(), v.name);
            let mut wanted = false;
            for (pattern, used) in patterns.iter().zip(&mut used) {
                let matched = is_number(v) && matches(pattern, &name);
                *used |= matched;
                wanted |= matched;
            }
            if wanted {
                variables.push(variable);
                series.push(Series { name, unit: v.dimension.to_string(), values: Vec::new() });
            }
        }
        if !variables.is_empty() {
            selected.push(Selected { unit: index, variables });
        }
    }
    let first: Vec<_> = units.iter().take(UnitName::ALL.len()).map(|u| names(u.as_ref())).collect();
    match patterns.iter().zip(used).find(|(_, used)| !used) {
        None => Ok((selected, series)),
        Some((pattern, _)) => Err(Error::input(format!(
            "variables: `{}`: expected a pattern of names of numbers like `plant0.theta`; \
             the first drone has {}",
            cut(pattern, 80),
            first.join("; ")
        ))),
    }
}

fn is_number(v: &Variable) -> bool {
    matches!(v.kind(), Kind::Real | Kind::Integer | Kind::Exact)
}

/// The names of a unit's numeric variables, after its own name.
fn names(unit: &dyn Unit) -> String {
    let numbers = unit.variables().iter().filter(|v| is_number(v));
    let names: Vec<_> = numbers.map(|v| v.name.as_str()).collect();
    format!("{}: {}", unit.name(), names.join(", "))
}

/// Whether a name matches a pattern.
fn matches(pattern: &str, name: &str) -> bool {
    let (pattern, name): (Vec<char>, Vec<char>) =
        (pattern.chars().collect(), name.chars().collect());
    let (mut p, mut n) = (0, 0);
    // The position of the last star, and how much of the name it has matched so far.
    let mut star = None;
    while n < name.len() {
        match pattern.get(p) {
            Some('*') => {
                star = Some((p, n));
                p += 1;
            }
            Some(c) if *c == '?' || Some(c) == name.get(n) => (p, n) = (p + 1, n + 1),
            _ => match star {
                Some((index, taken)) => {
                    star = Some((index, taken + 1));
                    (p, n) = (index + 1, taken + 1);
                }
                None => return false,
            },
        }
    }
    pattern.iter().skip(p).all(|c| *c == '*')
}

#[cfg(test)]
mod tests {
    use super::matches;

    #[test]
    fn patterns_are_those_of_a_shell() {
        let cases = [
            ("plant0.x", "plant0.x", true),
            ("plant0.x", "plant0.x0", false),
            ("*.w1", "control12.w1", true),
            ("*.w1", "control12.w10", false),
            ("plant?.v*", "plant3.vtheta", true),
            ("plant?.v*", "plant13.vx", false),
            ("*t*.x*", "plant1.x0", true),
            ("*", "", true),
            ("", "x", false),
            ("**a*b", "xaayb", true),
            ("*ab", "aab", true),
        ];
        for (pattern, name, expected) in cases {
            assert_eq!(matches(pattern, name), expected, "{pattern} {name}");
        }
    }
}
