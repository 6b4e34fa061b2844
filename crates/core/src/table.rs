//! Text tables with aligned columns.

/// The lines of a table whose first row is its header: columns two spaces apart, those in `left`
/// aligned to the left and the others to the right.
pub fn lines(rows: &[Vec<String>], left: impl Fn(usize) -> bool) -> Vec<String> {
    let widths = widths(rows);
    rows.iter().map(|row| line(row, &widths, &left)).collect()
}

/// One line of such a table, with these column widths.
pub fn line(row: &[String], widths: &[usize], left: impl Fn(usize) -> bool) -> String {
    let cells = row.iter().zip(widths).enumerate().map(|(i, (cell, &width))| {
        // Not by a format width, which is limited to 65,535.
        let blanks = " ".repeat(width.saturating_sub(cell.chars().count()));
        if left(i) { format!("{cell}{blanks}") } else { format!("{blanks}{cell}") }
    });
    cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
}

/// The width of the widest cell of each column, in characters.
pub fn widths(rows: &[Vec<String>]) -> Vec<usize> {
    let mut widths = Vec::new();
    for row in rows {
        widths.resize(widths.len().max(row.len()), 0);
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = (*width).max(cell.chars().count());
        }
    }
    widths
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_may_be_wider_than_a_format_allows() {
        let rows = [vec!["x0".to_owned()], vec!["7".repeat(70_000)]];
        let lines = lines(&rows, |_| false);
        assert_eq!(lines[0].len(), 70_000);
        assert!(lines[0].ends_with(" x0"));
    }
}
