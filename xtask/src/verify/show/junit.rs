//! For CI: JUnit XML, one suite a tier, one case a theorem.

use std::fmt::Write as _;

use super::described;
use crate::verify::Verdict;
use crate::verify::matrix::{Cell, Column, Matrix};

/// The matrix as JUnit XML: refuted and rejected are failures, everything without a result of
/// its own is skipped.
pub fn junit(matrix: &Matrix) -> String {
    let mut text = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"cargo xtask verify\">\n",
    );
    for column in &matrix.columns {
        suite(column, matrix, &mut text);
    }
    text.push_str("</testsuites>\n");
    text
}

fn failed(cell: &Cell) -> bool {
    matches!(cell.result(), Some("refuted" | "rejected"))
}

fn skipped(cell: &Cell) -> bool {
    !matches!(cell.result(), Some("holds")) && !failed(cell)
}

fn suite(column: &Column, matrix: &Matrix, text: &mut String) {
    let bad: Vec<&Verdict> = column.problems.iter().collect();
    let tests = column.cells.len() + bad.len();
    let failures = column.cells.iter().filter(|c| failed(c)).count() + bad.len();
    let skips = column.cells.iter().filter(|c| skipped(c)).count();
    let name = column.name;
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "  <testsuite name=\"{name}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"0\" skipped=\"{skips}\">"
    );
    for (theorem, cell) in matrix.theorems.iter().zip(&column.cells) {
        let seconds = cell.seconds().unwrap_or(0.0);
        let number = theorem.number();
        let _ = write!(
            text,
            "    <testcase classname=\"{name}\" name=\"{number}\" time=\"{seconds:.3}\">"
        );
        let message = escaped(&format!("{}: {}", cell.status(), cell.detail()));
        if failed(cell) {
            let _ = write!(text, "<failure message=\"{message}\"/>");
        } else if skipped(cell) {
            let _ = write!(text, "<skipped message=\"{message}\"/>");
        }
        text.push_str("</testcase>\n");
    }
    for (i, problem) in bad.iter().enumerate() {
        let message = escaped(&described(problem));
        let _ = writeln!(
            text,
            "    <testcase classname=\"{name}\" name=\"problem {}\" time=\"0\"><failure message=\"{message}\"/></testcase>",
            i + 1
        );
    }
    text.push_str("  </testsuite>\n");
}

/// Text as an XML attribute; characters that XML does not allow become `?`.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\n' | '\t' => out.push(' '),
            c if c.is_control() => out.push('?'),
            c => out.push(c),
        }
    }
    out
}
