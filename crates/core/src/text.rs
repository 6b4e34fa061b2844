//! User-supplied text, made safe to show.

use std::borrow::Cow;
use std::io::{self, Write};

/// What stands in the place of a character that is not shown.
const REPLACEMENT: char = char::REPLACEMENT_CHARACTER;

/// Whether a character makes text look other than it is: control characters, which steer terminals and are
/// invalid in XML, and those of Unicode that turn the direction of text, break lines or are invisible. Line
/// ends and tabs are none; nor are U+200C and U+200D, which join and part letters in some scripts.
pub fn is_harmful(c: char) -> bool {
    match c {
        '\n' | '\t' | ' '..='~' => false,
        '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}' | '\u{200e}' | '\u{200f}' => true,
        '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}' => true,
        '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}' => true,
        _ => c.is_control(),
    }
}

/// The text with [harmful](is_harmful) characters replaced by U+FFFD.
pub fn printable(text: &str) -> Cow<'_, str> {
    if text.chars().any(is_harmful) {
        text.chars().map(|c| if is_harmful(c) { REPLACEMENT } else { c }).collect::<String>().into()
    } else {
        text.into()
    }
}

/// The text in one line: as [`printable`], and line ends and tabs become spaces.
pub fn one_line(text: &str) -> String {
    let spaced = |c| if matches!(c, '\n' | '\t') { ' ' } else { c };
    printable(text).chars().map(spaced).collect()
}

/// The first `most` characters, with `...` where there were more.
pub fn cut(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}...", text.get(..end).unwrap_or_default()),
        None => text.to_owned(),
    }
}

/// The text with numbers of more than 60 digits shortened: exact fractions have no length that a message
/// could count on.
pub fn short_numbers(text: &str) -> String {
    let is_digit = |c: char| c.is_ascii_digit();
    let mut short = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(is_digit) {
        let (before, from) = rest.split_at(at);
        let (digits, after) = from.split_at(from.find(|c| !is_digit(c)).unwrap_or(from.len()));
        short += before;
        short += &(if digits.len() > 60 { cut(digits, 40) } else { digits.to_owned() });
        rest = after;
    }
    short + rest
}

/// The text as one word of a shell's command line.
pub fn shell_word(text: &str) -> Cow<'_, str> {
    let safe = |c: char| c.is_ascii_alphanumeric() || "-_./,:=@%+".contains(c);
    if !text.is_empty() && text.chars().all(safe) {
        text.into()
    } else {
        format!("'{}'", text.replace('\'', r"'\''")).into()
    }
}

/// A writer that makes text [`printable`].
#[derive(Debug)]
pub struct Printable<W>(pub W);

impl<W: Write> Write for Printable<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.write_all(bytes)?;
        Ok(bytes.len())
    }

    fn write_all(&mut self, bytes: &[u8]) -> io::Result<()> {
        // Text comes in whole characters; bytes that are not UTF-8 pass unchanged.
        match std::str::from_utf8(bytes) {
            Ok(text) => self.0.write_all(printable(text).as_bytes()),
            Err(_) => self.0.write_all(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_replaced() {
        assert_eq!(
            printable("a\u{1b}[31mb\u{9b}c\u{7f}\r\n\t"),
            "a\u{fffd}[31mb\u{fffd}c\u{fffd}\u{fffd}\n\t"
        );
        assert_eq!(
            printable("a\u{202e}b\u{2066}\u{200b}\u{feff}"),
            "a\u{fffd}b\u{fffd}\u{fffd}\u{fffd}"
        );
        assert!(matches!(printable("plain, naïve\n"), Cow::Borrowed(_)));
        assert!(matches!(printable("\u{645}\u{6cc}\u{200c}\u{62e}"), Cow::Borrowed(_)));
        assert_eq!(one_line("a\nb\u{1}"), "a b\u{fffd}");
        let mut out = Printable(Vec::new());
        out.write_all("x\u{1b}y\u{7}".as_bytes()).unwrap();
        assert_eq!(out.0, "x\u{fffd}y\u{fffd}".as_bytes());
    }

    #[test]
    fn words_for_the_shell() {
        assert_eq!(shell_word("a/b-c.toml"), "a/b-c.toml");
        assert_eq!(shell_word("it's a file"), r"'it'\''s a file'");
        assert_eq!(shell_word(""), "''");
        assert_eq!(cut("abcdef", 3), "abc...");
        assert_eq!(cut("abc", 3), "abc");
        let long = format!("1/{}: x2", "3".repeat(61));
        assert_eq!(short_numbers(&long), format!("1/{}...: x2", "3".repeat(40)));
        assert_eq!(short_numbers(&"7".repeat(60)), "7".repeat(60));
        assert_eq!(short_numbers("größer, 12 and 3"), "größer, 12 and 3");
    }
}
