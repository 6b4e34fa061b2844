//! Which variable of an FMU stands for which variable of a unit.

use std::collections::BTreeMap;

use crate::fmi::archive::{Fmu, FmuVariable};
use crate::unit::{Causality, Kind, Unit, Variable};
use cordon_core::{Error, Result};

/// A variable of a unit and the FMU's variable that stands for it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Counterpart {
    /// Place in the unit's table.
    pub place: usize,
    /// Who sets it.
    pub causality: Causality,
    /// Its type.
    pub kind: Kind,
    /// The FMU's variable.
    pub reference: u32,
    /// Its type in the FMU's words.
    pub fmu_kind: String,
}

/// Finds the counterparts by name: every input and output has to have one; parameters that the
/// FMU does not have are its own affair.
///
/// # Errors
/// An input or output without a counterpart, or one of another causality, type or physical
/// unit; a name that the unit does not know.
pub(super) fn map(
    unit: &dyn Unit,
    fmu: &Fmu,
    names: &BTreeMap<String, String>,
) -> Result<Vec<Counterpart>> {
    let fail = |variable: &str, what: String| {
        Error::input(format!(
            "unit `{}`, variable `{variable}`: `{}`: {what}",
            unit.name(),
            fmu.path.display()
        ))
    };
    if let Some(name) = names.keys().find(|n| !unit.variables().iter().any(|v| v.name == **n)) {
        return Err(fail(name, "is no variable of this unit".to_owned()));
    }
    let mut found = Vec::new();
    for (place, variable) in unit.variables().iter().enumerate() {
        let name = names.get(&variable.name).unwrap_or(&variable.name);
        let wanted = match variable.causality {
            Causality::Input | Causality::Output => true,
            Causality::Parameter => names.contains_key(&variable.name),
            Causality::Local => continue,
        };
        let Some(theirs) = fmu.variable(name) else {
            if wanted {
                let what =
                    format!("has no variable `{name}`: expected an {}", variable.causality.name());
                return Err(fail(&variable.name, what));
            }
            continue;
        };
        match mismatch(variable, theirs) {
            None => found.push(Counterpart {
                place,
                causality: variable.causality,
                kind: variable.kind(),
                reference: theirs.reference,
                fmu_kind: theirs.kind.clone(),
            }),
            Some(what) if wanted => return Err(fail(&variable.name, what)),
            // A parameter that happens to have the same name.
            Some(_) => {}
        }
    }
    Ok(found)
}

/// What keeps a variable from standing for another.
fn mismatch(ours: &Variable, theirs: &FmuVariable) -> Option<String> {
    let name = &theirs.name;
    if theirs.causality != ours.causality.name() {
        let (found, expected) = (&theirs.causality, ours.causality.name());
        return Some(format!("`{name}` is {found}: expected {expected}"));
    }
    let kinds: &[&str] = match ours.kind() {
        Kind::Real => &["Real", "Float64"],
        Kind::Integer => &["Integer", "Int64", "Int32"],
        Kind::Boolean => &["Boolean"],
        Kind::Text | Kind::Exact => &["String"],
    };
    if !kinds.contains(&theirs.kind.as_str()) {
        return Some(format!("`{name}` has type {}: expected {}", theirs.kind, kinds.join(" or ")));
    }
    match &theirs.unit {
        Some(unit) if ours.kind() == Kind::Real && *unit != ours.dimension.0 => {
            Some(format!("`{name}` is in `{unit}`: expected `{}`", ours.dimension))
        }
        _ => None,
    }
}
