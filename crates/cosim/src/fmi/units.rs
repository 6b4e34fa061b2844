//! Physical units in the XML of FMI and SSP: by name, with their exponents of SI base units.

use std::io::{Cursor, Result};

use quick_xml::Writer;

use crate::unit::{Dimension, Kind, Variable};

/// The XML of a file in the making.
pub(crate) type Xml = Writer<Cursor<Vec<u8>>>;

/// Names of the elements, which FMI and SSP have in different namespaces.
pub(crate) struct Elements {
    /// Around all units.
    pub list: &'static str,
    /// Around one.
    pub unit: &'static str,
    /// Its exponents.
    pub base: &'static str,
}

/// Whether a variable's values have a physical unit in model descriptions.
pub(crate) fn has_unit(variable: &Variable) -> bool {
    variable.kind() == Kind::Real && variable.dimension != Dimension::NONE
}

/// Writes the definitions of all units that these variables have, by name.
pub(crate) fn write<'v>(
    xml: &mut Xml,
    elements: &Elements,
    variables: impl IntoIterator<Item = &'v Variable>,
) -> Result<()> {
    let with_unit = variables.into_iter().filter(|v| has_unit(v));
    let mut symbols: Vec<&str> = with_unit.map(|v| v.dimension.0).collect();
    symbols.sort_unstable();
    symbols.dedup();
    xml.create_element(elements.list).write_inner_content(|xml| {
        for symbol in symbols {
            xml.create_element(elements.unit)
                .with_attribute(("name", symbol))
                .write_inner_content(|xml| {
                    let mut base = xml.create_element(elements.base);
                    for (unit, exponent) in base_units(symbol) {
                        base = base.with_attribute((unit.as_str(), exponent.to_string().as_str()));
                    }
                    base.write_empty()?;
                    Ok(())
                })?;
        }
        Ok(())
    })?;
    Ok(())
}

/// Exponents of the base units of a symbol like `kg.m2`, `m/s2` or `m.s-1`.
pub(crate) fn base_units(symbol: &str) -> Vec<(String, i32)> {
    let mut exponents: Vec<(String, i32)> = Vec::new();
    for (place, part) in symbol.split('/').enumerate() {
        let sign = if place == 0 { 1 } else { -1 };
        for factor in part.split('.').filter(|f| *f != "1") {
            let is_exponent = |c: char| c.is_ascii_digit() || c == '-' || c == '+';
            let name = factor.trim_end_matches(is_exponent);
            let exponent: i32 = factor.get(name.len()..).and_then(|e| e.parse().ok()).unwrap_or(1);
            match exponents.iter_mut().find(|(n, _)| n == name) {
                Some((_, sum)) => *sum += sign * exponent,
                None => exponents.push((name.to_owned(), sign * exponent)),
            }
        }
    }
    exponents
}
