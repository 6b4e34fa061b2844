//! Paths of `file:` URIs.

use std::path::PathBuf;

use cordon_core::{Error, Result};

/// The path denoted by a path or a `file:` URI. `file:/a`, `file:///a`, `file:////a` and
/// `file://localhost/a` are `/a`.
///
/// # Errors
/// The URI does not denote a file on this machine.
pub fn path(name: &str) -> Result<PathBuf> {
    let Some(rest) = name.strip_prefix("file:") else {
        return Ok(PathBuf::from(name));
    };
    let fail = |what: &str| Error::input(format!("`{name}`: {what}"));
    let rest = match rest.strip_prefix("//") {
        Some(rest) => rest.strip_prefix("localhost").unwrap_or(rest),
        None => rest,
    };
    if rest.starts_with(|c| c != '/') && name.starts_with("file://") {
        return Err(fail("expected the URI of a file on this machine"));
    }
    let decoded = decoded(rest).ok_or_else(|| fail("expected `%` with two hexadecimal digits"))?;
    let slashes = decoded.len() - decoded.trim_start_matches('/').len();
    Ok(PathBuf::from(decoded.get(slashes.saturating_sub(1)..).unwrap_or_default()))
}

/// A text with percent-encoded bytes decoded.
fn decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        bytes.push(match byte {
            b'%' => {
                let digit = |b: Option<u8>| char::from(b?).to_digit(16);
                let (high, low) = (digit(rest.next())?, digit(rest.next())?);
                u8::try_from(16 * high + low).ok()?
            }
            byte => byte,
        });
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use std::path::Path;

    use super::*;

    #[test]
    fn uris_of_files_are_paths() {
        for uri in ["file:/a b/c.fmu", "file:///a%20b/c.fmu", "file:////a%20b/c.fmu", "/a b/c.fmu"]
        {
            assert_eq!(path(uri).unwrap(), Path::new("/a b/c.fmu"), "{uri}");
        }
        assert_eq!(path("file://localhost/x").unwrap(), Path::new("/x"));
        assert_eq!(path("a%20b.fmu").unwrap(), Path::new("a%20b.fmu"));
        for (uri, part) in
            [("file:///a%2", "two hexadecimal"), ("file://host/a", "on this machine")]
        {
            assert!(path(uri).unwrap_err().to_string().contains(part), "{uri}");
        }
    }
}
