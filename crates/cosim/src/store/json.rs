//! Runs as JSON, schema `cordon-cosim/1`.

use std::io::Write;

use serde::{Deserialize, Serialize};

use crate::collision::{Event, EventKind};
use crate::record::{Flown, Height, Record, Series, Setup, Track};
use cordon_core::exact;
use cordon_core::files::kind;
use cordon_core::fingerprint::Fingerprint;
use cordon_core::{Error, Result};

const SCHEMA: &str = "cordon-cosim/1";

const COMPANION_SCHEMA: &str = "cordon-cosim-companion/1";

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Page {
    schema: String,
    title: String,
    setup: Option<SetupPage>,
    drones: usize,
    time: Vec<f64>,
    desired: Vec<Vec<f64>>,
    actual: Vec<Vec<f64>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    desired_y: Option<Vec<Vec<f64>>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    actual_y: Option<Vec<Vec<f64>>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    height: Option<HeightPage>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    variables: Vec<SeriesPage>,
    events: Option<Vec<EventPage>>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    broken_off: Option<String>,
}

/// What the columns of a run file cannot hold, in a file beside it.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Companion {
    schema: String,
    /// Fingerprint of the run file.
    of: String,
    title: String,
    setup: Option<SetupPage>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    height: Option<HeightPage>,
    events: Option<Vec<EventPage>>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    broken_off: Option<String>,
}

/// The set-up; exact numbers are written as fractions.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct SetupPage {
    protocol: String,
    segment: Option<(String, String)>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    weight: Option<String>,
    period: u32,
    tau: String,
    integrator: String,
    master: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    order: Option<Vec<usize>>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    recorded: bool,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    fmus: Vec<FlownPage>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct FlownPage {
    unit: String,
    fmu: String,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct HeightPage {
    desired: f64,
    actual: Vec<Heights>,
}

/// Heights at a grid point: one number where all drones have the same.
#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Heights {
    Same(f64),
    Each(Vec<f64>),
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct SeriesPage {
    name: String,
    unit: String,
    values: Vec<f64>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct EventPage {
    time: f64,
    kind: String,
    drones: (usize, usize),
}

/// Writes one object: the set-up, one list of positions per grid point, the events.
///
/// # Errors
/// `out` cannot be written.
pub fn json(record: &Record, out: &mut dyn Write) -> Result<()> {
    let by_rows = |numbers: &[f64]| -> Vec<Vec<f64>> {
        (0..record.rows()).map(|row| record.at(numbers, row).to_vec()).collect()
    };
    let page = Page {
        schema: SCHEMA.to_owned(),
        title: record.title.clone(),
        setup: record.setup.as_ref().map(setup_page),
        drones: record.count,
        time: record.times.clone(),
        desired: by_rows(&record.x.desired),
        actual: by_rows(&record.x.actual),
        desired_y: record.y.as_ref().map(|y| by_rows(&y.desired)),
        actual_y: record.y.as_ref().map(|y| by_rows(&y.actual)),
        height: height_page(record),
        variables: record.series.iter().map(series_page).collect(),
        events: event_pages(record),
        notes: record.notes.clone(),
        broken_off: record.broken_off.clone(),
    };
    serde_json::to_writer(&mut *out, &page).map_err(std::io::Error::from)?;
    writeln!(out)?;
    Ok(())
}

/// The companion of a run file with this fingerprint.
pub(super) fn companion(record: &Record, of: Fingerprint) -> Result<Vec<u8>> {
    let companion = Companion {
        schema: COMPANION_SCHEMA.to_owned(),
        of: of.hex(),
        title: record.title.clone(),
        setup: record.setup.as_ref().map(setup_page),
        height: height_page(record),
        events: event_pages(record),
        notes: record.notes.clone(),
        broken_off: record.broken_off.clone(),
    };
    let mut text = serde_json::to_vec_pretty(&companion).map_err(std::io::Error::from)?;
    text.push(b'\n');
    Ok(text)
}

/// Completes a record from its companion. `name` stands for the companion in messages.
pub(super) fn accompany(
    record: &mut Record,
    of: Fingerprint,
    name: &str,
    text: &str,
) -> Result<()> {
    let fail = |what: String| Error::input(format!("`{name}`: {what}"));
    let companion: Companion = serde_json::from_str(text)
        .map_err(|e| fail(format!("{e}: expected schema {COMPANION_SCHEMA}")))?;
    if companion.schema != COMPANION_SCHEMA {
        let found = companion.schema;
        return Err(fail(format!("schema: `{found}`: expected `{COMPANION_SCHEMA}`")));
    }
    if companion.of != of.hex() {
        return Err(fail(
            "belongs to another run: expected that of the run file beside it; \
             without it the positions alone are read"
                .to_owned(),
        ));
    }
    record.title = companion.title;
    record.setup =
        companion.setup.map(|s| setup(s).map_err(|e| fail(e.to_string()))).transpose()?;
    record.height = companion.height.map(|h| height(h, record.count)).transpose().map_err(fail)?;
    record.events = events(companion.events, record.count).map_err(fail)?;
    record.notes = companion.notes;
    record.broken_off = companion.broken_off;
    super::check(name, record, |row| time(name, row))
}

/// Where the time of a row stands.
fn time(name: &str, row: usize) -> String {
    format!("`{name}`: time[{row}]")
}

fn height_page(record: &Record) -> Option<HeightPage> {
    let height = record.height.as_ref()?;
    let row = |row| match record.at(&height.actual, row) {
        [first, rest @ ..] if rest.iter().all(|z| z == first) => Heights::Same(*first),
        heights => Heights::Each(heights.to_vec()),
    };
    Some(HeightPage { desired: height.desired, actual: (0..record.rows()).map(row).collect() })
}

fn height(page: HeightPage, count: usize) -> Result<Height, String> {
    let mut actual = Vec::new();
    for (row, heights) in page.actual.into_iter().enumerate() {
        match heights {
            Heights::Same(z) => actual.extend(std::iter::repeat_n(z, count)),
            Heights::Each(heights) if heights.len() == count => actual.extend(heights),
            Heights::Each(_) => {
                return Err(format!(
                    "height at row {row}: expected a number, or one for each of the {count} drones"
                ));
            }
        }
    }
    Ok(Height { desired: page.desired, actual })
}

fn series_page(s: &Series) -> SeriesPage {
    SeriesPage { name: s.name.clone(), unit: s.unit.clone(), values: s.values.clone() }
}

fn event_pages(record: &Record) -> Option<Vec<EventPage>> {
    record.events.as_ref().map(|events| events.iter().map(event_page).collect())
}

fn setup_page(s: &Setup) -> SetupPage {
    SetupPage {
        protocol: s.protocol.clone(),
        segment: s.segment.as_ref().map(|(min, max)| (min.to_string(), max.to_string())),
        weight: s.weight.as_ref().map(ToString::to_string),
        period: s.period,
        tau: s.tau.to_string(),
        integrator: s.integrator.clone(),
        master: s.master.clone(),
        order: s.order.clone(),
        recorded: s.recorded,
        fmus: s
            .fmus
            .iter()
            .map(|f| FlownPage { unit: f.unit.clone(), fmu: f.fmu.clone() })
            .collect(),
    }
}

fn event_page(e: &Event) -> EventPage {
    EventPage { time: e.time, kind: e.kind.name().to_owned(), drones: e.drones }
}

/// Parses the output of [`json`]. `name` stands for the file in messages.
pub(super) fn parse(name: &str, text: &str) -> Result<Record> {
    let fail = |what: String| Error::input(format!("`{name}`: {what}"));
    if let Some(kind) = kind::no_json(text) {
        return Err(fail(format!("{kind}: expected a whole run, schema {SCHEMA}")));
    }
    let page: Page = serde_json::from_str(text)
        .map_err(|e| fail(format!("{e}: expected a whole run, schema {SCHEMA}")))?;
    if page.schema != SCHEMA {
        return Err(fail(format!("schema: `{}`: expected `{SCHEMA}`", page.schema)));
    }
    let flat = |what: &str, rows: Vec<Vec<f64>>| -> Result<Vec<f64>> {
        match rows.iter().position(|row| row.len() != page.drones) {
            Some(row) => Err(fail(format!(
                "{what} at row {row}: expected one position for each of the {} drones",
                page.drones
            ))),
            None => Ok(rows.concat()),
        }
    };
    let y = match (page.desired_y, page.actual_y) {
        (Some(desired), Some(actual)) => {
            Some(Track { desired: flat("desired_y", desired)?, actual: flat("actual_y", actual)? })
        }
        (None, None) => None,
        _ => return Err(fail("desired_y, actual_y: expected both or none".to_owned())),
    };
    let series = page.variables.into_iter();
    let record = Record {
        title: page.title,
        count: page.drones,
        times: page.time,
        x: Track { desired: flat("desired", page.desired)?, actual: flat("actual", page.actual)? },
        y,
        height: page.height.map(|h| height(h, page.drones)).transpose().map_err(fail)?,
        series: series.map(|s| Series { name: s.name, unit: s.unit, values: s.values }).collect(),
        events: events(page.events, page.drones).map_err(fail)?,
        setup: page.setup.map(|s| setup(s).map_err(|e| fail(e.to_string()))).transpose()?,
        notes: page.notes,
        broken_off: page.broken_off,
    };
    super::check(name, &record, |row| time(name, row))?;
    Ok(record)
}

fn events(pages: Option<Vec<EventPage>>, count: usize) -> Result<Option<Vec<Event>>, String> {
    pages.map(|pages| pages.into_iter().map(|e| event(e, count)).collect()).transpose()
}

fn event(e: EventPage, count: usize) -> Result<Event, String> {
    let kind = EventKind::named(&e.kind).ok_or_else(|| {
        format!("events: `{}`: expected `collision`, `order-lost` or `order-restored`", e.kind)
    })?;
    let (i, j) = e.drones;
    if i >= j || j >= count || !e.time.is_finite() {
        return Err(format!(
            "events: drones `{i}` and `{j}`: expected two of the {count} drones, smaller number first"
        ));
    }
    Ok(Event { time: e.time, drones: e.drones, kind })
}

fn setup(s: SetupPage) -> Result<Setup> {
    let segment = match s.segment {
        Some((min, max)) => Some((exact::parse("segment", &min)?, exact::parse("segment", &max)?)),
        None => None,
    };
    Ok(Setup {
        segment,
        weight: s.weight.map(|w| exact::parse("weight", &w)).transpose()?,
        tau: exact::parse("tau", &s.tau)?,
        protocol: s.protocol,
        period: s.period,
        integrator: s.integrator,
        master: s.master,
        order: s.order,
        recorded: s.recorded,
        fmus: s.fmus.into_iter().map(|f| Flown { unit: f.unit, fmu: f.fmu }).collect(),
    })
}
