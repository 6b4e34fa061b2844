//! The theorems by the paper's numbers.

use cordon_spec::theorems::Theorem;

use crate::{Error, Result};

/// The theorems of a list like `7.2,7.4ii`; a number without its part (`7.4`) names all parts,
/// `all` all theorems.
///
/// # Errors
/// A number that no theorem has.
pub fn named(list: &str) -> Result<Vec<Theorem>> {
    if list.trim() == "all" {
        return Ok(Theorem::ALL.to_vec());
    }
    let mut named = Vec::new();
    for number in list.split(',').map(str::trim) {
        let found = Theorem::ALL.iter().filter(|t| {
            let full = t.text().number;
            full == number || full.trim_end_matches('i') == number
        });
        let before = named.len();
        named.extend(found);
        if named.len() == before {
            let known: Vec<_> = Theorem::ALL.iter().map(|t| t.text().number).collect();
            return Err(Error::input(format!(
                "theorem: `{number}` is unknown: expected `all` or some of {}",
                known.join(", ")
            )));
        }
    }
    named.sort_unstable();
    named.dedup();
    Ok(named)
}
