//! Drawing of figures: rows in, SVG out.
//!
//! [`draw_diagram`], [`draw_magnifications`], [`draw_straightened`], [`draw_one_parameter`],
//! [`draw_place`] and [`draw_family`] take the rows of a figure of any oscillator ([`grazing_results`])
//! and return a [`Sheet`]: the drawn elements, with title and description. The figures of the paper are
//! composed from these functions and from the parts below, each beside its rows. This crate knows rows,
//! frames and ink; it computes nothing about impacts, and equal input gives equal bytes.
//!
//! The files form four layers, each of which uses only those below it: `figures`, [`plot`]
//! (parts of figures: axes, grids of panels, curves, scenes), [`ink`] (fonts, pens, SVG, labels,
//! legends) and [`geometry`].
//!
//! Everything is drawn by [plotters], whose backend a sheet is (`ink::canvas::Canvas`), in hundredths of a point; SVG is
//! written with two decimals. A panel is a chart of plotters, with axes of ours. Series of plotters' elements are drawn on it,
//! and of [ours](ink::elements), which have what those lack: curves and areas are clipped in data space, so that they leave a
//! frame with their own slope, and are split at NaN; lines have dashes. Text remains text, in fonts that are embedded in each
//! file and measured when labels are placed.
//!
//! ```
//! use grazing_drawing::ink::canvas::Canvas;
//! use grazing_drawing::ink::elements::Disc;
//! use grazing_drawing::ink::labels::{Labels, Site};
//! use grazing_drawing::ink::style::{BLACK, LABEL_SIZE, Paint, Pen};
//! use grazing_drawing::ink::{legend, markers::Marker};
//! use grazing_drawing::plot::axes::Panel;
//! use grazing_drawing::plotters::prelude::{Cross, EmptyElement, LineSeries};
//! use grazing_drawing::{Bounds, DrawingError};
//! use grazing_results::Frame;
//!
//! let canvas = Canvas::new(80.0, 60.0)?;
//! let bounds = Bounds { left: 40.0, top: 6.0, right: canvas.width - 8.0, bottom: canvas.height - 30.0 };
//! let mut panel = Panel::new(&canvas, Frame { x: [0.0, 2.0], y: [0.0, 1.0] }, bounds)?;
//! let mut labels = Labels::new(&canvas, bounds);
//! // A parabola that leaves the panel, dashed, in the legend, and with a name beside it.
//! let parabola: Vec<_> = (0..=20).map(|k| (0.1 * f64::from(k), 0.01 * f64::from(k * k))).collect();
//! let pen = Pen::dashed(BLACK, 0.8, &[4.0, 1.5]);
//! let drawn = panel.draw_series(panel.curve(&parabola, pen))?.label("parabola").legend(legend::line(pen))?;
//! let pieces = drawn.pieces;
//! pieces.iter().for_each(|piece| labels.placer.keep_off(piece));
//! labels.add("$y=x^2$", LABEL_SIZE, BLACK, &Site::Beside(&pieces[0]))?;
//! // Series, elements and compositions of plotters, with our pens and paints, and markers of ours.
//! panel.draw_series(LineSeries::new([(0.0, 0.9), (2.0, 0.2)], Pen::solid([200, 0, 0], 0.8)))?;
//! panel.draw_series(parabola[..10].iter().map(|&point| {
//!     EmptyElement::at(point) + Disc::new((0, 0), 1.5, Paint::opaque(BLACK), None) + Cross::new((0, 0), 200, pen)
//! }))?;
//! panel.mark(&mut labels, [(1.0, 1.0)], Marker::Triangle)?.label("corner").legend(Marker::Triangle.sample())?;
//! panel.axes("$x$", "$y$")?;
//! labels.draw()?;
//! let sheet = canvas.finish("example", "A parabola", "A parabola and a line.")?;
//! assert_eq!(sheet.legend.iter().map(|(meaning, _)| meaning.as_str()).collect::<Vec<_>>(), ["parabola", "corner"]);
//! // What plotters knows of the series is there for its own legend.
//! panel.chart.configure_series_labels().label_font(("serif", 800)).draw().map_err(DrawingError::from)?;
//! assert_eq!(canvas.finish("example", "", "")?.texts.len(), 2);
//! # Ok::<_, DrawingError>(())
//! ```

mod error;
mod figures;
pub mod geometry;
pub mod ink;
pub mod plot;
#[cfg(test)]
mod tests;

pub use error::DrawingError;
pub use figures::diagram::draw_diagram;
pub use figures::family::draw_family;
pub use figures::look::Look;
pub use figures::magnifications::{draw_magnifications, draw_straightened};
pub use figures::one_parameter::draw_one_parameter;
pub use figures::place::draw_place;
pub use geometry::sheet::Bounds;
pub use ink::font::{FONT_FILES, FORMULA_FONT, style_sheet};
pub use ink::markup::unmarked;
pub use ink::sheet::{Element, PanelMark, Path, Sheet};
pub use ink::style::SheetWidth;
pub use ink::svg::POINTS_PER_MM;
pub use plot::axes::Heading;
pub use plotters;
