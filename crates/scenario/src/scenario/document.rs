//! TOML documents: numbers of any size exactly, errors with line, column and field.

use std::ops::Range;
use std::path::Path;

use num_bigint::BigInt;
use serde::de::DeserializeOwned;
use toml::Deserializer;
use toml::de::{DeTable, DeValue};

use super::Places;
use super::file::Source;
use cordon_core::files::{self, Limit};
use cordon_core::text::is_harmful;
use cordon_core::{Error, Result};

/// Deserialises a document into `T`; also returns the location of its fields.
///
/// Integers beyond 64 bits and decimals beyond doubles are passed on as strings of their digits: exact
/// numbers are read from either.
///
/// # Errors
/// Invalid TOML, a key that `T` does not have, or a value of another type: with file, line, column and
/// field.
pub fn document<T: DeserializeOwned>(source: &Source<'_>) -> Result<(T, Places)> {
    let read = |e: toml::de::Error| {
        source.error(&e.span().unwrap_or(0..0), &plain(e.message().trim_end()))
    };
    refuse_hidden(source)?;
    let mut table = DeTable::parse(source.text).map_err(read)?;
    let places = places(table.get_ref());
    refuse_escaped(source, "", table.get_ref())?;
    table.get_mut().iter_mut().for_each(|(_, value)| keep_digits(value.get_mut()));
    let read = T::deserialize(Deserializer::from(table)).map_err(|e| {
        let at = e.span().unwrap_or(0..0);
        let message = plain(e.message().trim_end());
        // The innermost field that contains the error.
        let field =
            places.iter().rev().find(|(_, span)| span.start <= at.start && at.end <= span.end);
        match field {
            Some((name, _)) if !message.starts_with("unknown field") => {
                source.error(&at, &format!("{name}: {message}"))
            }
            _ => source.error(&at, &message),
        }
    })?;
    let lines = places.into_iter().map(|(name, at)| (name, source.place(at.start)));
    Ok((read, Places::of(source.name, lines)))
}

/// Whether there is something in a title to show.
pub fn is_title(title: &str) -> bool {
    !title.trim().is_empty()
}

/// Reads a file in which a person has written TOML.
///
/// # Errors
/// It cannot be read, or is no such file: empty, or of another kind.
pub fn written(path: &Path, limit: Limit) -> Result<String> {
    let text = files::read_text(path, limit)?;
    match files::kind::foreign(&text) {
        Some(kind) => {
            let name = path.display();
            Err(Error::input(format!("`{name}`: {kind}: expected {}, which is TOML", limit.what)))
        }
        None => Ok(text),
    }
}

/// Refuses characters that are not shown, or turn the direction of what is, anywhere in the text.
fn refuse_hidden(source: &Source<'_>) -> Result<()> {
    // The end of a line may be written with a carriage return.
    let hidden = |&(_, c): &(usize, char)| is_harmful(c) && c != '\r';
    match source.text.char_indices().find(hidden) {
        Some((at, c)) => Err(source.error(&(at..at), &not_shown(c))),
        None => Ok(()),
    }
}

/// As [`refuse_hidden`], where they are written as escapes, in names and values; and titles of several lines.
fn refuse_escaped(source: &Source<'_>, prefix: &str, table: &DeTable<'_>) -> Result<()> {
    table.iter().try_for_each(|(key, value)| {
        let name = format!("{prefix}{}", key.get_ref());
        if let Some(c) = key.get_ref().chars().find(|c| is_harmful(*c)) {
            return Err(source.error(&key.span(), &format!("a key: {}", not_shown(c))));
        }
        if let ("title", DeValue::String(title)) = (name.as_str(), value.get_ref())
            && title.contains(['\n', '\t'])
        {
            return Err(source.error(&value.span(), "title: expected one line without tabs"));
        }
        refuse_escaped_in(source, &name, value)
    })
}

fn refuse_escaped_in(
    source: &Source<'_>,
    name: &str,
    value: &toml::Spanned<DeValue<'_>>,
) -> Result<()> {
    match value.get_ref() {
        DeValue::String(text) => {
            match text.replace("\r\n", "\n").chars().find(|c| is_harmful(*c)) {
                Some(c) => Err(source.error(&value.span(), &format!("{name}: {}", not_shown(c)))),
                None => Ok(()),
            }
        }
        DeValue::Array(list) => list.iter().try_for_each(|v| refuse_escaped_in(source, name, v)),
        DeValue::Table(table) => refuse_escaped(source, &format!("{name}."), table),
        _ => Ok(()),
    }
}

fn not_shown(c: char) -> String {
    format!("U+{:04X} is not shown as it stands: expected characters that are", u32::from(c))
}

/// Replaces numbers that no machine type holds by strings of their digits.
fn keep_digits(value: &mut DeValue<'_>) {
    match value {
        DeValue::Integer(n) if i64::from_str_radix(n.as_str(), n.radix()).is_err() => {
            if let Some(n) = BigInt::parse_bytes(n.as_str().as_bytes(), n.radix()) {
                *value = DeValue::String(n.to_string().into());
            }
        }
        DeValue::Float(x)
            if !x.as_str().contains("inf")
                && x.as_str().parse::<f64>().is_ok_and(f64::is_infinite) =>
        {
            *value = DeValue::String(x.as_str().to_owned().into());
        }
        DeValue::Array(list) => list.iter_mut().for_each(|v| keep_digits(v.get_mut())),
        DeValue::Table(table) => table.iter_mut().for_each(|(_, v)| keep_digits(v.get_mut())),
        _ => {}
    }
}

/// The spans of all fields, by name from the root, outer fields before inner ones.
fn places(table: &DeTable<'_>) -> Vec<(String, Range<usize>)> {
    let mut found = Vec::new();
    within("", table, &mut found);
    found
}

fn within(prefix: &str, table: &DeTable<'_>, found: &mut Vec<(String, Range<usize>)>) {
    for (key, value) in table {
        inside(&format!("{prefix}{}", key.get_ref()), value.span(), value.get_ref(), found);
    }
}

fn inside(
    name: &str,
    span: Range<usize>,
    value: &DeValue<'_>,
    found: &mut Vec<(String, Range<usize>)>,
) {
    found.push((name.to_owned(), span));
    match value {
        DeValue::Table(table) => within(&format!("{name}."), table, found),
        // Tables in lists have fields of their own, and a number; numbers in lists use the name of the
        // list.
        DeValue::Array(list) => {
            for (place, value) in list.iter().enumerate().filter(|(_, v)| v.get_ref().is_table()) {
                found.push((format!("{name} {}", place + 1), value.span()));
                inside(name, value.span(), value.get_ref(), found);
            }
        }
        _ => {}
    }
}

/// The TOML library's messages in user terms: no Rust types, lower case, given before expected.
fn plain(message: &str) -> String {
    let message = message.lines().next().unwrap_or_default();
    let (given, expected) = match message.split_once(", expected ") {
        Some((given, expected)) => (given, Some(expected)),
        None => (message, None),
    };
    let given = given
        .strip_prefix("invalid type: ")
        .or_else(|| given.strip_prefix("invalid value: "))
        .map_or_else(|| given.to_owned(), shown);
    match expected {
        Some(expected) => format!("{given}: expected {}", kind(expected)),
        None => given,
    }
}

/// The given value without its type, shortened; lists and tables, which the library does not repeat, by
/// their type.
fn shown(given: &str) -> String {
    let kinds = ["string ", "integer ", "floating point ", "boolean ", "character "];
    match (given, kinds.iter().find_map(|kind| given.strip_prefix(kind))) {
        ("map", _) => "a table".to_owned(),
        ("sequence", _) => "a list".to_owned(),
        (_, value) => {
            let value = value.unwrap_or(given).trim_matches(['`', '"']);
            format!("`{}`", cordon_core::text::cut(value, 40))
        }
    }
}

fn kind(expected: &str) -> &str {
    match expected {
        "u8" | "u16" | "u32" | "u64" | "usize" => "a whole number",
        "i64" | "i128" | "f64" => "a number",
        "a string" => "a text in quotes",
        "a boolean" => "true or false",
        "a sequence" => "a list",
        "a map" => "a table",
        "a tuple of size 2" => "a pair of whole numbers",
        other => other,
    }
}
