//! The sheet as a backend of plotters, in hundredths of a point: whatever plotters draws becomes SVG of print quality, with
//! text in the embedded fonts.
//!
//! Lengths are hundredths of a point, widths of lines and sizes of text as well. A width of 1, which a colour has as a style,
//! is that of ticks.

use plotters::backend::DrawingBackend;
use plotters::style::FontTransform;
use plotters::style::text_anchor::{HPos, VPos};
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind};

use crate::error::DrawingError;
use crate::geometry::sheet::{Hundredths, in_points};
use crate::ink::canvas::{Anchor, Canvas};
use crate::ink::markup::Label;
use crate::ink::sheet::Element;
use crate::ink::style::{Paint, Pen, TICK};
use crate::ink::svg::{fill, hundredths, points, stroke};

/// The side of a pixel, in hundredths of a point.
const PIXEL: i32 = 36;
/// The height of digits, in units of the font size.
const DIGITS: f64 = 0.66;

/// The paint of a style; none if it is transparent.
fn paint(BackendColor { alpha, rgb: (red, green, blue) }: BackendColor) -> Option<Paint> {
    (alpha > 0.0).then_some(Paint { colour: [red, green, blue], opacity: alpha })
}

/// The attributes that draw a line in a style; none if it is transparent.
fn line<S: BackendStyle>(style: &S) -> Option<String> {
    let Paint { colour, opacity } = paint(style.color())?;
    let width = if style.stroke_width() > 1 { f64::from(style.stroke_width()) / 100.0 } else { TICK.width };
    let share =
        if opacity < 1.0 { format!(" stroke-opacity=\"{}\"", points(opacity)) } else { String::new() };
    Some(stroke(Some(Pen::solid(colour, width))) + &share)
}

/// The attributes that fill or outline a shape in a style; none if it is transparent.
fn shape<S: BackendStyle>(style: &S, filled: bool) -> Option<String> {
    if filled { paint(style.color()).map(fill) } else { line(style) }
}

type Drawn = Result<(), DrawingErrorKind<DrawingError>>;

impl DrawingBackend for Canvas {
    type ErrorType = DrawingError;

    fn get_size(&self) -> (u32, u32) {
        ((100.0 * self.width).round() as u32, (100.0 * self.height).round() as u32)
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    /// Draws a square about the point.
    fn draw_pixel(&mut self, (x, y): BackendCoord, color: BackendColor) -> Drawn {
        let half = PIXEL / 2;
        self.draw_rect((x - half, y - half), (x + half, y + half), &color, true)
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Drawn {
        self.draw_path([from, to], style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        (left, top): BackendCoord,
        (right, bottom): BackendCoord,
        style: &S,
        fill: bool,
    ) -> Drawn {
        if let Some(attributes) = shape(style, fill) {
            // A coordinate that is zero need not be written.
            let at = |name: &str, value: i32| match value {
                0 => String::new(),
                _ => format!(" {name}=\"{}\"", hundredths(value)),
            };
            let [x, y] = [at("x", left), at("y", top)];
            let [width, height] = [right - left, bottom - top].map(hundredths);
            let size = format!(" width=\"{width}\" height=\"{height}\"");
            self.add(Element::Markup(format!("<rect{x}{y}{size}{attributes}/>")));
        }
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        if let Some(attributes) = line(style) {
            self.line(&path.into_iter().collect::<Vec<Hundredths>>(), attributes);
        }
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        center: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Drawn {
        if let Some(attributes) = shape(style, fill) {
            self.circle(center, radius, &attributes);
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        vert: I,
        style: &S,
    ) -> Drawn {
        if let Some(paint) = paint(style.color()) {
            self.path([(vert.into_iter().collect(), true)], fill(paint));
        }
        Ok(())
    }

    /// Draws a text in the markup of labels. Above and below are the ends of digits.
    fn draw_text<T: BackendTextStyle>(&mut self, text: &str, style: &T, pos: BackendCoord) -> Drawn {
        let Some(paint) = paint(style.color()) else { return Ok(()) };
        let size = style.size() / 100.0;
        let anchor = match style.anchor().h_pos {
            HPos::Left => Anchor::Start,
            HPos::Center => Anchor::Middle,
            HPos::Right => Anchor::End,
        };
        let below = match style.anchor().v_pos {
            VPos::Top => DIGITS * size,
            VPos::Center => 0.5 * DIGITS * size,
            VPos::Bottom => 0.0,
        };
        let (x, y) = in_points(pos);
        let (turns, baseline) = match style.transform() {
            FontTransform::None => (0, (x, y + below)),
            FontTransform::Rotate90 => (1, (x - below, y)),
            FontTransform::Rotate180 => (2, (x, y - below)),
            FontTransform::Rotate270 => (3, (x + below, y)),
        };
        let label = Label::parse(text).map_err(DrawingErrorKind::DrawingError)?;
        self.turned_label(baseline, &label, size, anchor, paint.colour, turns)
            .map_err(DrawingErrorKind::DrawingError)
    }

    fn estimate_text_size<T: BackendTextStyle>(
        &self,
        text: &str,
        style: &T,
    ) -> Result<(u32, u32), DrawingErrorKind<DrawingError>> {
        let measured = Label::parse(text).and_then(|label| self.fonts.measure(&label, style.size()));
        let extent = measured.map_err(DrawingErrorKind::DrawingError)?;
        Ok((extent.width.ceil() as u32, extent.height().ceil() as u32))
    }
}

#[cfg(test)]
mod tests {
    use plotters::prelude::*;
    use plotters::style::text_anchor::Pos;

    use super::*;
    use crate::ink::style::{MARKER, MARKER_RIM};

    type Area = DrawingArea<Canvas, plotters::coord::Shift>;
    /// What is written, and what draws it.
    type Case<'a> = (&'a str, &'a dyn Fn(&Area));

    /// The elements that a chart over the whole of a sheet of 100 by 50 points draws, in which a unit is a point.
    fn drawn(draw: impl FnOnce(&Area)) -> String {
        let canvas = Canvas::new(100.0 / 72.0 * 25.4, 50.0 / 72.0 * 25.4).unwrap();
        let area = canvas.clone().into_drawing_area();
        assert_eq!(area.dim_in_pixel(), (10_000, 5_000));
        draw(&area);
        let body = canvas.finish("test", "", "").unwrap().short_body();
        body.split_once('\n').unwrap().1.to_owned()
    }

    #[test]
    fn elements_of_plotters_are_svg_with_exact_coordinates() {
        let (red, seen) = (RGBColor(255, 0, 0), BLUE.mix(0.25));
        let cases: [Case<'_>; 9] = [
            ("<path d=\"M1 2l4 4\" stroke=\"#ff0000\" stroke-width=\"1.25\"/>", &|area| {
                let thick = Color::stroke_width(&red, 125);
                area.draw(&PathElement::new([(100, 200), (300, 400), (500, 600)], thick)).unwrap();
            }),
            ("<path d=\"M0 0l0 .5\" stroke=\"#ff0000\" stroke-width=\"0.5\"/>", &|area| {
                area.draw(&PathElement::new([(0, 0), (0, 50)], red)).unwrap();
            }),
            ("<path d=\"M1 1l1 0-1 1Z\" fill=\"#0000ff\" fill-opacity=\"0.25\"/>", &|area| {
                area.draw(&Polygon::new([(100, 100), (200, 100), (100, 200)], seen)).unwrap();
            }),
            ("<circle cx=\"1.5\" cy=\"2.25\" r=\"0.75\" fill=\"#ff0000\"/>", &|area| {
                area.draw(&Circle::new((150, 225), 75, red.filled())).unwrap();
            }),
            (
                "<rect x=\"1\" y=\"2\" width=\"3\" height=\"0.5\" stroke=\"#0000ff\" stroke-width=\"0.8\" stroke-opacity=\"0.25\"/>",
                &|area| {
                    area.draw(&Rectangle::new([(100, 250), (400, 200)], Color::stroke_width(&seen, 80)))
                        .unwrap();
                },
            ),
            ("<rect x=\"4.82\" y=\"4.82\" width=\"0.36\" height=\"0.36\" fill=\"#ff0000\"/>", &|area| {
                area.draw(&Pixel::new((500, 500), red)).unwrap();
            }),
            (
                "<path d=\"M1 1l2 2\" stroke=\"#ff0000\" stroke-width=\"0.5\"/>\n<path d=\"M1 3l2-2\" stroke=\"#ff0000\" stroke-width=\"0.5\"/>",
                &|area| {
                    area.draw(&Cross::new((200, 200), 100, red)).unwrap();
                },
            ),
            ("<path d=\"M5 4l-.86 1.5 1.73 0Z\" fill=\"#ff0000\"/>", &|area| {
                area.draw(&TriangleMarker::new((500, 500), 100, red)).unwrap();
            }),
            ("", &|area| area.draw(&PathElement::new([(0, 0), (900, 900)], TRANSPARENT)).unwrap()),
        ];
        for (wanted, draw) in cases {
            assert_eq!(drawn(|area| draw(area)).trim_end(), wanted);
        }
    }

    #[test]
    fn text_is_set_in_our_fonts_and_markup_wherever_it_is_anchored() {
        let style = ("serif", 1000).into_font().color(&BLACK);
        let at = |h_pos, v_pos, turn: FontTransform| {
            drawn(|area| {
                let style = style.transform(turn.clone()).pos(Pos::new(h_pos, v_pos));
                area.draw(&Text::new("$x_1$", (2000, 1000), style)).unwrap();
            })
        };
        let text = at(HPos::Left, VPos::Bottom, FontTransform::None);
        assert!(text.starts_with(
            "<text x=\"20\" y=\"10\" font-size=\"10\" fill=\"#000000\"><tspan font-style=\"italic\">x</tspan>"
        ));
        assert!(
            at(HPos::Center, VPos::Top, FontTransform::None)
                .contains("x=\"20\" y=\"16.6\" font-size=\"10\" text-anchor=\"middle\"")
        );
        let upwards = at(HPos::Right, VPos::Center, FontTransform::Rotate270);
        assert!(upwards.contains("text-anchor=\"end\" transform=\"rotate(-90 23.3 10)\""), "{upwards}");
        for (turn, angle) in
            [(FontTransform::Rotate90, "rotate(90 20 10)"), (FontTransform::Rotate180, "rotate(180 20 10)")]
        {
            assert!(at(HPos::Left, VPos::Bottom, turn).contains(angle));
        }
        let canvas = Canvas::new(20.0, 20.0).unwrap();
        let size = |text| canvas.clone().into_drawing_area().estimate_text_size(text, &style).unwrap();
        let extent = canvas.fonts.measure(&Label::plain("1.25"), 10.0).unwrap();
        assert!((f64::from(size("1.25").0) - 100.0 * extent.width).abs() <= 1.0);
        // A label that cannot be set is an error and no panic.
        let error = canvas.clone().into_drawing_area().draw(&Text::new("$x", (0, 0), &style)).unwrap_err();
        assert!(!DrawingError::from(error).to_string().is_empty());
    }

    #[test]
    fn a_chart_of_stock_series_with_mesh_and_legend_is_drawn_without_a_pixel_lost() {
        let svg = drawn(|area| {
            let mut chart = ChartBuilder::on(area)
                .margin(500)
                .x_label_area_size(1000)
                .y_label_area_size(1500)
                .build_cartesian_2d(0.0..4.0, 0.0..2.0)
                .unwrap();
            chart.configure_mesh().label_style(("serif", 700)).draw().unwrap();
            let curve = (0..=8).map(|k| (0.5 * f64::from(k), 0.25 * f64::from(k)));
            let area = AreaSeries::new(curve.clone(), 0.0, MARKER).border_style(MARKER_RIM);
            chart.draw_series(area).unwrap();
            let line = LineSeries::new(curve.clone(), Pen::solid([1, 2, 3], 1.2)).point_size(150);
            chart
                .draw_series(line)
                .unwrap()
                .label("$x_1$")
                .legend(|(x, y)| PathElement::new([(x, y), (x + 1500, y)], Pen::solid([1, 2, 3], 1.2)));
            let crosses = PointSeries::of_element(curve, 120, &RED, &|place, size, style| {
                EmptyElement::at(place)
                    + Circle::new((0, 0), size, style.filled())
                    + Cross::new((0, 0), size, style)
            });
            chart.draw_series(crosses).unwrap();
            let mut legend = chart.configure_series_labels();
            legend.margin(200).legend_area_size(1800).label_font(("serif", 800)).draw().unwrap();
        });
        let count = |start: &str| svg.lines().filter(|line| line.contains(start)).count();
        // Nine points of the line with circles, and nine with circles and crosses.
        assert_eq!(count("<circle"), 18, "{svg}");
        assert_eq!(count("stroke=\"#010203\" stroke-width=\"1.2\"/>"), 9 + 1 + 1, "{svg}");
        assert!(count("font-style=\"italic\">x</tspan>") == 1 && svg.contains(">2.0</text>"), "{svg}");
    }
}
