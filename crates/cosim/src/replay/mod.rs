//! A run as one self-contained HTML page: no server, no network, nothing to install.

use serde_json::{Value, json};

use crate::collision::{Event, Sample, Watch};
use crate::physics::Body;
use crate::plant::Integrator;
use crate::record::{Record, Track};
use cordon_core::Result;
use cordon_core::exact;

const PAGE: &str = include_str!("page.html");
const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// Most positions of a page, so that a browser draws it smoothly.
const MAX_POSITIONS: usize = 400_000;

/// The page for a run.
///
/// Positions are rounded to a hundredth of a millimetre, and long runs are thinned; events are those of
/// the whole run.
///
/// # Errors
/// The run cannot be written as JSON.
pub fn page(record: &Record) -> Result<String> {
    let title = escaped(&record.title);
    let run = data(record).to_string();
    // Only `<` could end the script element.
    let run = run.replace('<', "\\u003c");
    let parts =
        [("@TITLE@", title.as_str()), ("@STYLE@", STYLE), ("@SCRIPT@", SCRIPT), ("@RUN@", &run)];
    Ok(filled(PAGE, &parts))
}

/// The template with its marks replaced, in one pass: inserted text is not scanned again.
fn filled(template: &str, parts: &[(&str, &str)]) -> String {
    let mut page = String::new();
    let mut rest = template;
    loop {
        let found = parts.iter().filter_map(|(mark, text)| Some((rest.find(mark)?, mark, text)));
        let Some((place, mark, text)) = found.min_by_key(|(place, ..)| *place) else {
            page.push_str(rest);
            return page;
        };
        page.push_str(rest.get(..place).unwrap_or_default());
        page.push_str(text);
        rest = rest.get(place + mark.len()..).unwrap_or_default();
    }
}

fn data(record: &Record) -> Value {
    let a_drone = 2 * record.tracks().count() + usize::from(record.height.is_some());
    let every = (record.rows() * record.count * a_drone).div_ceil(MAX_POSITIONS).max(1);
    let last = record.rows().saturating_sub(1);
    let rows: Vec<usize> = (0..=last).filter(|row| row % every == 0 || *row == last).collect();
    let rounded = |x: &f64| (x * 1e5).round() / 1e5;
    let positions = |numbers: &[f64]| -> Vec<Vec<f64>> {
        rows.iter().map(|row| record.at(numbers, *row).iter().map(rounded).collect()).collect()
    };
    let events = match &record.events {
        Some(events) => events.clone(),
        None => looked_for(record),
    };
    let events: Vec<_> = events
        .iter()
        .map(|e| json!({ "time": e.time, "kind": e.kind.name(), "drones": [e.drones.0, e.drones.1] }))
        .collect();
    json!({
        "drones": record.count,
        "setup": setup(record, every),
        "segment": record.setup.as_ref().and_then(|s| {
            let (min, max) = s.segment.as_ref()?;
            Some([exact::to_f64(min), exact::to_f64(max)])
        }),
        "time": rows.iter().filter_map(|row| record.times.get(*row)).collect::<Vec<_>>(),
        "desired": positions(&record.x.desired),
        "actual": positions(&record.x.actual),
        "across": record.y.as_ref().map(|y| {
            json!({ "desired": positions(&y.desired), "actual": positions(&y.actual) })
        }),
        "reach": Body::default().touching(),
        "height": record.height.as_ref().map(|height| {
            let actual = positions(&height.actual).into_iter().map(|row| match row.as_slice() {
                [first, rest @ ..] if rest.iter().all(|z| z == first) => json!(first),
                _ => json!(row),
            });
            json!({ "desired": height.desired, "actual": actual.collect::<Vec<_>>() })
        }),
        "events": events,
    })
}

/// Finds the events of a run recorded without them: on straight lines between samples, which is all
/// that samples can tell.
fn looked_for(record: &Record) -> Vec<Event> {
    let mut events = Vec::new();
    let rows = || record.times.iter().enumerate();
    // Samples need not be equidistant: one watch per pair of samples would lose the order between them,
    // so time is counted in samples and converted afterwards.
    let mut watch = match record.y {
        None => Watch::new(Integrator::Euler, 1.0),
        Some(_) => Watch::in_plane(Integrator::Euler, 1.0, Body::default().touching()),
    };
    for (row, _) in rows() {
        let sample = |x: &f64| Sample { x: *x, ..Sample::default() };
        let axis = |track: &Track| record.at(&track.actual, row).iter().map(sample).collect();
        let samples: Vec<Vec<_>> = record.tracks().map(|(_, track)| axis(track)).collect();
        watch.next((row as f64 - 1.0).max(0.0), &samples);
    }
    for event in watch.finish() {
        let row = event.time.floor();
        let share = event.time - row;
        // A row index: not negative, and within the record.
        let row = row as usize;
        let here = record.times.get(row).copied().unwrap_or_default();
        let next = record.times.get(row + 1).copied().unwrap_or(here);
        events.push(Event { time: here + share * (next - here), ..event });
    }
    events
}

fn setup(record: &Record, every: usize) -> String {
    let mut text = match &record.setup {
        Some(s) => format!(
            "{}, {} drones{}, {}; {}",
            s.protocol,
            record.count,
            s.weighted(),
            s.rhythm(),
            s.flown_with()
        ),
        None => format!("{} drones", record.count),
    };
    if let Some(why) = &record.broken_off {
        text.push_str(&format!("; broken off: {why}"));
    }
    if every > 1 {
        text.push_str(&format!("; every {every}th sample is shown"));
    }
    text
}

fn escaped(text: &str) -> String {
    cordon_core::text::one_line(text)
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::STYLE;

    /// Relative luminance of a colour `#rrggbb` (WCAG 2.2).
    fn luminance(colour: &str) -> f64 {
        let channel = |at: usize| {
            let c = f64::from(u8::from_str_radix(&colour[at..at + 2], 16).unwrap()) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        };
        0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5)
    }

    fn contrast(a: &str, b: &str) -> f64 {
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    /// Texts have a contrast of at least 4.5 and lines of 3, light and dark, as WCAG requires.
    #[test]
    fn colours_stand_out() {
        let mut compared = 0;
        for theme in STYLE.split("--paper:").skip(1) {
            let theme = format!("--paper:{}", theme.split('}').next().unwrap());
            let colour = |name: &str| {
                let from = theme.find(&format!("--{name}:")).unwrap();
                theme[from..].split(['#', ';']).nth(1).map(|c| format!("#{c}")).unwrap()
            };
            let ground = [colour("paper"), colour("panel")];
            let gaps = (0..7).map(|i| format!("gap-{i}"));
            let texts = ["ink", "soft", "goal", "wrong", "drone"].map(str::to_owned);
            for (least, names) in [(4.5, texts.to_vec()), (3.0, gaps.collect())] {
                for (name, ground) in names.iter().flat_map(|n| ground.iter().map(move |g| (n, g)))
                {
                    let found = contrast(&colour(name), ground);
                    assert!(found >= least, "{name} on {ground}: {found:.2}");
                    compared += 1;
                }
            }
        }
        // Light, dark by system setting, dark by user choice.
        assert_eq!(compared, 3 * 24);
    }
}
