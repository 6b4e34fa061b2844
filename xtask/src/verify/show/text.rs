//! The matrix as text: a table, then the details of each column.

use std::io::Write;

use super::described;
use crate::verify::matrix::{Cell, Column, Matrix};
use cordon_core::{Result, table};

/// Writes the matrix.
///
/// # Errors
/// The output cannot be written.
pub fn text(matrix: &Matrix, out: &mut dyn Write) -> Result<()> {
    let names = matrix.columns.iter().map(|c| c.name.to_owned());
    let mut rows: Vec<Vec<_>> = vec![std::iter::once("theorem".to_owned()).chain(names).collect()];
    for (i, theorem) in matrix.theorems.iter().enumerate() {
        let cells = matrix.columns.iter().map(|c| c.cells.get(i).map_or_else(String::new, short));
        rows.push(std::iter::once(theorem.number().to_owned()).chain(cells).collect());
    }
    for line in table::lines(&rows, |_| true) {
        writeln!(out, "{line}")?;
    }
    writeln!(out)?;
    matrix.columns.iter().try_for_each(|c| behind(c, matrix, out))?;
    writeln!(out, "{}", summary(matrix))?;
    Ok(())
}

/// A cell of the table: the result, and whether it was run or recorded.
fn short(cell: &Cell) -> String {
    match (cell, cell.result()) {
        (Cell::Run { seconds, .. }, Some("holds")) => format!("holds {seconds:.2} s"),
        (Cell::Run { .. }, Some(result)) => result.to_uppercase(),
        (Cell::Recorded { .. }, Some("holds")) => "record".to_owned(),
        (Cell::Recorded { .. }, Some(result)) => format!("record: {}", result.to_uppercase()),
        (Cell::Stale { .. }, _) => "STALE".to_owned(),
        (Cell::NotClaimed(_), _) => "-".to_owned(),
        _ => "not run".to_owned(),
    }
}

/// Writes the details of a column: theorems with the same result share a line.
fn behind(column: &Column, matrix: &Matrix, out: &mut dyn Write) -> Result<()> {
    writeln!(out, "{} ({}):", column.name, column.kind.text())?;
    let mut lines: Vec<(String, Vec<&str>)> = Vec::new();
    for (theorem, cell) in matrix.theorems.iter().zip(&column.cells) {
        let number = theorem.number();
        let mut line = cell.status().to_owned();
        if let Some(origin) = cell.origin() {
            line.push_str(&format!(" of {}, {}, {}", origin.date, origin.tool, origin.sources));
        }
        if let Some(result) = cell.result() {
            line.push_str(&format!(", {result}"));
        }
        line.push_str(&format!(": {}", cell.detail()));
        match lines.iter_mut().find(|(l, _)| *l == line) {
            Some((_, numbers)) => numbers.push(number),
            None => lines.push((line, vec![number])),
        }
    }
    for (line, numbers) in lines {
        writeln!(out, "  {}: {line}", numbers.join(", "))?;
    }
    for problem in &column.problems {
        writeln!(out, "  {}", described(problem))?;
    }
    Ok(())
}

fn summary(matrix: &Matrix) -> String {
    let cells = || matrix.columns.iter().flat_map(|c| c.cells.iter());
    let count = |status: &str| cells().filter(|c| c.status() == status).count();
    let seconds: f64 = cells().filter_map(Cell::seconds).fold(0.0, |sum, s| sum + s);
    format!(
        "{} run now ({seconds:.1} s), {} by record, {} stale, {} not run, {} not claimed",
        count("run now"),
        count("by record"),
        count("stale"),
        count("not run"),
        count("not claimed")
    )
}
