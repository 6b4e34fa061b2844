//! Drawing a plot, as SVG or PNG.

use std::error::Error as StdError;

use plotters::coord::Shift;
use plotters::prelude::*;

use super::{Format, Plot, font};
use cordon_core::{Error, Result};

/// Width and height in pixels.
const SIZE: (u32, u32) = (1100, 640);

/// Width of the legend beside the chart.
const LEGEND: u32 = 110;

/// Colours that can be distinguished with a colour vision deficiency (Okabe and Ito).
const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 87, 92),
    RGBColor(230, 159, 0),
    RGBColor(0, 0, 0),
];

const GRID: RGBColor = RGBColor(225, 225, 228);
const MARK: RGBColor = RGBColor(190, 0, 30);

type Drawn<T> = std::result::Result<T, Box<dyn StdError>>;

impl Plot {
    /// The drawing as the content of a file.
    ///
    /// # Errors
    /// The plotting library fails.
    pub(super) fn drawn(&self, format: Format) -> Result<Vec<u8>> {
        font::register()?;
        let content = match format {
            Format::Svg => self.svg(),
            Format::Png => self.png(),
        };
        content.map_err(|e| Error::internal(format!("figures: {e}")))
    }

    fn svg(&self) -> Drawn<Vec<u8>> {
        let mut text = String::new();
        self.draw(SVGBackend::with_string(&mut text, SIZE).into_drawing_area())?;
        // A title, for screen readers and tooltips.
        if let Some((tag, rest)) = text.split_once('>') {
            let title = escaped(&self.title);
            text = format!("{tag} role=\"img\"><title>{title}</title>{rest}");
        }
        Ok(text.into_bytes())
    }

    fn png(&self) -> Drawn<Vec<u8>> {
        let mut pixels = vec![0; 3 * SIZE.0 as usize * SIZE.1 as usize];
        self.draw(BitMapBackend::with_buffer(&mut pixels, SIZE).into_drawing_area())?;
        let mut file = Vec::new();
        let encoder = image::codecs::png::PngEncoder::new(&mut file);
        image::ImageEncoder::write_image(encoder, &pixels, SIZE.0, SIZE.1, image::ColorType::Rgb8)?;
        Ok(file)
    }

    /// Least and greatest position, with a margin.
    fn range(&self) -> (f64, f64) {
        let positions = || self.lines.iter().flat_map(|l| l.points.iter().map(|p| p.1));
        let low = positions().fold(f64::INFINITY, f64::min);
        let high = positions().fold(f64::NEG_INFINITY, f64::max);
        let margin = ((high - low) * 0.05).max(0.5);
        (low - margin, high + margin)
    }

    fn draw<B: DrawingBackend>(&self, area: DrawingArea<B, Shift>) -> Drawn<()>
    where
        B::ErrorType: 'static,
    {
        area.fill(&WHITE)?;
        let (low, high) = self.range();
        let (left, right) = area.split_horizontally(SIZE.0 - LEGEND);
        self.legend(&right)?;
        let mut chart = ChartBuilder::on(&left)
            .caption(&self.title, (font::NAME, 24))
            .margin(14)
            .x_label_area_size(52)
            .y_label_area_size(86)
            .build_cartesian_2d(self.across.0..self.across.1, low..high)?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(WHITE)
            .bold_line_style(GRID)
            .axis_style(BLACK)
            .x_desc(&self.grid_label)
            .y_desc(self.label)
            .x_labels(12)
            .y_labels(12)
            .x_label_formatter(&|t| short(*t))
            .y_label_formatter(&|x| short(*x))
            .label_style((font::NAME, 16))
            .axis_desc_style((font::NAME, 18))
            .draw()?;
        let (from, to) = self.across;
        let verticals = (0..).map(|k| f64::from(k) * self.grid).take_while(|t| *t < to);
        let verticals = verticals.skip_while(|t| *t <= from);
        for t in verticals {
            chart.draw_series(LineSeries::new([(t, low), (t, high)], GRID))?;
        }
        let coloured = || self.lines.iter().zip(COLOURS.iter().cycle());
        for (line, colour) in coloured().filter(|(line, _)| line.points.len() > 1) {
            let points = line.points.iter().copied();
            chart.draw_series(LineSeries::new(points, colour.stroke_width(2)))?;
        }
        for (line, colour) in coloured() {
            if let [dot] = line.points.as_slice() {
                chart.draw_series([Circle::new(*dot, 9, colour.filled())])?;
            }
        }
        for (time, x, label) in &self.marks {
            chart.draw_series(LineSeries::new([(*time, low), (*time, high)], MARK))?;
            chart.draw_series([Circle::new((*time, *x), 6, MARK.stroke_width(2))])?;
            let style = (font::NAME, 16).into_font().color(&MARK);
            // Below the lines, to the left of the collision.
            let place = (*time - 0.3 * (to - from), low + 0.035 * (high - low));
            chart.draw_series([Text::new(label.clone(), place, style)])?;
        }
        area.present()?;
        Ok(())
    }

    /// A sample of every line, with its name.
    fn legend<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Drawn<()>
    where
        B::ErrorType: 'static,
    {
        let heights = (80..).step_by(28);
        for ((line, colour), y) in self.lines.iter().zip(COLOURS.iter().cycle()).zip(heights) {
            area.draw(&PathElement::new([(4, y), (28, y)], colour.stroke_width(3)))?;
            let style = (font::NAME, 17).into_font().color(&BLACK);
            area.draw(&Text::new(line.name.clone(), (36, y - 9), style))?;
        }
        Ok(())
    }
}

/// A text escaped for XML.
fn escaped(text: &str) -> String {
    cordon_core::text::one_line(text)
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

/// A number on an axis, without trailing zeros.
fn short(x: f64) -> String {
    let text = format!("{x:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
