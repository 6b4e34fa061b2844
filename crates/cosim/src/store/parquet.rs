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

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;

    use super::*;
    use crate::cosimulation::Cosimulation;
    use crate::run::run;
    use crate::store::csv::heads;
    use cordon_run::scenario::{Flight, parse};

    /// Columns of positions and of other variables are read back to the last bit.
    #[test]
    fn columns_are_those_of_the_csv() {
        let text = "start = [0, 10, 100]\nweight = 0.2\nperiod = 4\ntau = 0.05\n";
        let scenario = parse("test", text).unwrap().finish().unwrap();
        let mut swarm = Cosimulation::new(scenario, Flight::default()).unwrap();
        swarm.recorded_variables = vec!["plant?.theta".to_owned(), "*.w1".to_owned()];
        let record = run(&swarm).unwrap();
        assert_eq!(record.series.len(), 9);
        let mut file = tempfile::tempfile().unwrap();
        parquet(&record, &mut file).unwrap();
        let reader = SerializedFileReader::new(file).unwrap();
        let mut compared = 0;
        for (k, row) in reader.get_row_iter(None).unwrap().enumerate() {
            let row = row.unwrap();
            let columns = row.get_column_iter().map(|(name, x)| (name.clone(), x.clone()));
            let (names, read): (Vec<_>, Vec<_>) = columns.unzip();
            assert_eq!(names, heads(&record));
            let written = std::iter::once(record.times[k])
                .chain(record.positions().flat_map(|(_, x)| record.at(x, k).iter().copied()))
                .chain(record.series.iter().map(|s| s.values[k]));
            assert_eq!(read, written.map(Field::Double).collect::<Vec<_>>());
            compared += read.len();
        }
        assert_eq!(compared, 501 * (1 + 6 + 9));
    }
}
