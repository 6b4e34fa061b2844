//! Runs as Apache Parquet: the columns of the CSV, doubles, one row group.

use std::io::Write;
use std::sync::Arc;

use parquet::basic::{Repetition, Type as Physical};
use parquet::data_type::DoubleType;
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

use crate::record::Record;
use cordon_core::{Error, Result};

/// Writes the columns of the CSV.
///
/// # Errors
/// `out` cannot be written.
pub(super) fn parquet(record: &Record, out: &mut dyn Write) -> Result<()> {
    let file = encoded(record).map_err(|e| Error::internal(format!("format: parquet: {e}")))?;
    out.write_all(&file)?;
    Ok(())
}

fn encoded(record: &Record) -> Result<Vec<u8>, ParquetError> {
    let mut columns: Vec<(String, Vec<f64>)> = vec![("time".to_owned(), record.times.clone())];
    for (prefix, numbers) in record.positions() {
        for i in 0..record.count {
            let column = numbers.iter().skip(i).step_by(record.count).copied().collect();
            columns.push((format!("{prefix}{i}"), column));
        }
    }
    columns.extend(record.series.iter().map(|s| (s.head(), s.values.clone())));
    let field = |(name, _): &(String, Vec<f64>)| {
        Type::primitive_type_builder(name, Physical::DOUBLE)
            .with_repetition(Repetition::REQUIRED)
            .build()
            .map(Arc::new)
    };
    let fields = columns.iter().map(field).collect::<Result<Vec<_>, _>>()?;
    let schema = Type::group_type_builder("run").with_fields(fields).build()?;
    let properties = Arc::new(WriterProperties::builder().build());
    let mut writer = SerializedFileWriter::new(Vec::new(), Arc::new(schema), properties)?;
    let mut group = writer.next_row_group()?;
    for (_, numbers) in &columns {
        if let Some(mut column) = group.next_column()? {
            column.typed::<DoubleType>().write_batch(numbers, None, None)?;
            column.close()?;
        }
    }
    group.close()?;
    writer.into_inner()
}
