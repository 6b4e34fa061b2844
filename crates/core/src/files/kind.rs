//! What a file is, where it is not what was expected.

/// Kinds of files by their first bytes.
const BY_FIRST_BYTES: [(&[u8], &str); 11] = [
    (b"\xff\xfe", "UTF-16 text"),
    (b"\xfe\xff", "UTF-16 text"),
    (b"PK\x03\x04", "a zip archive, as FMUs are"),
    (b"\x7fELF", "a program or library"),
    (b"MZ", "a program or library"),
    (b"\xcf\xfa\xed\xfe", "a program or library"),
    (b"%PDF", "a PDF"),
    (b"\x89PNG", "a picture"),
    (b"\xff\xd8\xff", "a picture"),
    (b"\x1f\x8b", "a compressed file"),
    (b"SQLite format 3", "a database"),
];

/// The kind of files that begin with a brace.
pub const JSON: &str = "JSON";

/// What these bytes are, where they are no UTF-8 text.
pub fn binary(bytes: &[u8]) -> Option<&'static str> {
    let is_text = std::str::from_utf8(bytes).is_ok() && !bytes.contains(&0);
    if is_text {
        return None;
    }
    let is_of_text = |b: &u8| *b >= b' ' || b"\n\r\t".contains(b);
    let unknown = match bytes.iter().all(is_of_text) {
        true => "text of another encoding",
        false => "a binary file",
    };
    Some(by_first_bytes(bytes).unwrap_or(unknown))
}

/// As [`binary`], of what is known by the first bytes alone.
pub fn by_first_bytes(bytes: &[u8]) -> Option<&'static str> {
    let known = BY_FIRST_BYTES.iter().find(|(first, _)| bytes.starts_with(first));
    known.map(|(_, kind)| *kind)
}

/// What this text is, where it is empty or in the form of files that no person writes by hand.
pub fn foreign(text: &str) -> Option<&'static str> {
    let Some(first) = text.trim_start().lines().next() else { return Some("empty") };
    let columns = first.split(',').count();
    match first.chars().next()? {
        '{' => Some(JSON),
        '<' => Some("XML or HTML"),
        _ if columns > 1 && !first.contains(['=', '[', '#', '"']) => Some("a table in CSV"),
        _ => None,
    }
}

/// What this text is, where it is no object in JSON.
pub fn no_json(text: &str) -> Option<&'static str> {
    match foreign(text) {
        Some(JSON) => None,
        Some(kind) => Some(kind),
        None => Some("no JSON"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_told_apart() {
        assert_eq!(binary(b"PK\x03\x04\x00\xff"), Some("a zip archive, as FMUs are"));
        assert_eq!(binary(b"\x7fELF\x02\x00"), Some("a program or library"));
        assert_eq!(binary(b"a\x00b"), Some("a binary file"));
        assert_eq!(binary(b"M\xe4nge = 1"), Some("text of another encoding"));
        assert_eq!(binary(b"\xff\xfea\x00"), Some("UTF-16 text"));
        assert_eq!(binary("Mänge = 1".as_bytes()), None);
        assert_eq!(foreign(" \n\t"), Some("empty"));
        assert_eq!(foreign("\n{ \"schema\": 1 }"), Some("JSON"));
        assert_eq!(foreign("<svg>"), Some("XML or HTML"));
        assert_eq!(foreign("time,x0,x1\n0,1,2"), Some("a table in CSV"));
        assert_eq!(foreign("title = \"a, b\"\n"), None);
        assert_eq!(foreign("# a, b\n"), None);
        assert_eq!(no_json("{}"), None);
        assert_eq!(no_json(""), Some("empty"));
        assert_eq!(no_json("title = 1"), Some("no JSON"));
    }
}
