//! A figure as a value: its elements and its description, from which its SVG is written.

use std::fmt::Write;

use grazing_results::Frame;

use crate::geometry::sheet::{Bounds, Hundredths};
#[cfg(test)]
use crate::geometry::sheet::{Spot, cross, in_points};
use crate::ink::font::style_sheet;
use crate::ink::markup::unmarked;
use crate::ink::svg::{POINTS_PER_MM, escape, hundredths, path_data, points};

/// A drawn figure.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Sheet {
    /// The title, for screen readers.
    pub title: String,
    /// The description, for screen readers.
    pub description: String,
    /// Width and height, in points, to hundredths.
    pub size: (f64, f64),
    /// The drawn elements, in drawing order.
    pub elements: Vec<Element>,
    /// The legend: each meaning, in words with formulas between dollars, and a sample as SVG in a box of
    /// 24 by 10 points.
    pub legend: Vec<(String, String)>,
    /// Every label with the bounding box of its ink, in drawing order.
    pub texts: Vec<(String, Bounds)>,
}

/// A drawn element.
#[derive(Debug, Clone, PartialEq)]
pub enum Element {
    /// An SVG element, as it is written in the file.
    Markup(String),
    /// A path.
    Path(Path),
    /// The position and contents of a panel, without ink.
    Panel(PanelMark),
}

/// A path from spot to spot.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    /// The pieces of the path, in hundredths of a point, each with whether it is closed.
    pub pieces: Vec<(Vec<Hundredths>, bool)>,
    /// The drawing attributes, each preceded by a space.
    pub attributes: String,
}

/// The position and contents of a panel.
#[derive(Debug, Clone, PartialEq)]
pub struct PanelMark {
    /// The bounds of the panel on the sheet.
    pub bounds: Bounds,
    /// The values at its edges.
    pub frame: Frame,
    /// The titles of the horizontal and the vertical axis; an empty title is that of the panel to the
    /// left.
    pub titles: [String; 2],
    /// The tables whose rows the panel shows, the most informative first; empty if any table with columns
    /// for the axes will do.
    pub tables: Vec<&'static str>,
    /// The column and the number that distinguish the panel's rows from those of other panels.
    pub only: Option<(&'static str, u32)>,
    /// The columns of the horizontal and the vertical axis, unless these are those of their titles.
    pub columns: Option<[String; 2]>,
    /// Whether values are linear along the axes, so that they can be read off; the SVG does not describe
    /// panels in which they are not.
    pub linear: bool,
}

impl Sheet {
    /// Attributes of the outer element, which all drawn elements inherit. Where the embedded font is
    /// ignored, fonts of similar widths take precedence over other serif fonts. White space is preserved
    /// because some viewers otherwise drop it at the ends of a tspan.
    pub const INHERITED: &str = "font-family=\"'STIX Two Text','STIXGeneral','Times New Roman','Liberation Serif',\
                                 'Nimbus Roman','TeX Gyre Termes',Times,serif\" \
                                 xml:space=\"preserve\" stroke-linejoin=\"round\" fill=\"none\"";

    /// The text of an SVG file with embedded fonts.
    pub fn svg(&self) -> String {
        let mut content = format!("<style>\n{}</style>\n{}", style_sheet(), self.body(path_data));
        if !self.legend.is_empty() {
            let entry = |(meaning, sample): &(String, String)| {
                format!("<g aria-label=\"{}\">{sample}</g>", escape(meaning))
            };
            let entries: String = self.legend.iter().map(entry).collect();
            content.push_str(&format!("<defs class=\"legend\">{entries}</defs>\n"));
        }
        self.svg_around(&content)
    }

    /// The text of an SVG file with this sheet's size and title around any content.
    pub fn svg_around(&self, content: &str) -> String {
        let Self { title, description, size: (width, height), .. } = self;
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
             <svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" viewBox=\"{}\" {} role=\"img\">\n\
             <title>{}</title>\n<desc>{}</desc>\n{content}</svg>\n",
            points(width / POINTS_PER_MM),
            points(height / POINTS_PER_MM),
            self.view_box(),
            Self::INHERITED,
            escape(&unmarked(title)),
            escape(&unmarked(description)),
        )
    }

    /// The view box of the SVG.
    pub fn view_box(&self) -> String {
        format!("0 0 {} {}", points(self.size.0), points(self.size.1))
    }

    /// The drawn elements in short form: paths use relative coordinates, which are exact to a hundredth.
    pub fn short_body(&self) -> String {
        self.body(short_path_data)
    }

    /// The drawn elements, one per line, with path data from `data`.
    fn body(&self, data: fn(&[Hundredths], bool) -> String) -> String {
        let (width, height) = self.size;
        let background =
            format!("<rect width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n", points(width), points(height));
        let told =
            self.elements.iter().filter(|element| !matches!(element, Element::Panel(mark) if !mark.linear));
        told.fold(background, |body, element| body + &element.svg(data) + "\n")
    }

    /// The panels, in the order of drawing.
    pub fn panels(&self) -> impl Iterator<Item = &PanelMark> {
        self.elements.iter().filter_map(|element| match element {
            Element::Panel(panel) => Some(panel),
            _ => None,
        })
    }

    /// The labels in markup, in drawing order.
    #[cfg(test)]
    pub(crate) fn texts(&self) -> Vec<String> {
        self.texts.iter().map(|(source, _)| source.clone()).collect()
    }

    /// The leaders of labels, each from its label to what is named.
    #[cfg(test)]
    pub(crate) fn leaders(&self) -> Vec<(Spot, Spot)> {
        let ends = |element: &Element| match element {
            Element::Path(Path { pieces, attributes }) if attributes.contains("class=\"leader\"") => {
                Some((in_points(*pieces[0].0.first()?), in_points(*pieces[0].0.last()?)))
            }
            _ => None,
        };
        self.elements.iter().filter_map(ends).collect()
    }

    /// Panics with the labels that overlap another one or leave the sheet, and with the leaders that cross
    /// each other or a label, if there are any.
    #[cfg(test)]
    pub(crate) fn assert_well_placed(&self, what: &dyn std::fmt::Debug) {
        let (texts, (right, bottom)) = (&self.texts, self.size);
        let whole = Bounds { left: 0.0, top: 0.0, right, bottom };
        let spoilt = |i: usize| {
            !whole.holds(&texts[i].1)
                || texts.iter().enumerate().any(|(j, other)| i != j && other.1.overlaps(&texts[i].1))
        };
        let misplaced: Vec<_> = (0..texts.len()).filter(|&i| spoilt(i)).map(|i| &texts[i]).collect();
        assert!(misplaced.is_empty(), "{what:?}: {misplaced:?}");
        let leaders = self.leaders();
        for (index, &(from, to)) in leaders.iter().enumerate() {
            let crossed = leaders[..index].iter().find(|other| cross(**other, (from, to)));
            assert!(crossed.is_none(), "{what:?}: {crossed:?}");
            let covered = texts.iter().find(|(_, taken)| taken.meets(from, to));
            assert!(covered.is_none(), "{what:?}: {covered:?}");
        }
    }
}

impl Element {
    /// The element as SVG, with path data from `data`.
    pub(crate) fn svg(&self, data: fn(&[Hundredths], bool) -> String) -> String {
        match self {
            Self::Markup(text) => text.clone(),
            Self::Path(Path { pieces, attributes }) => {
                let data: String = pieces.iter().map(|(spots, closed)| data(spots, *closed)).collect();
                format!("<path d=\"{data}\"{attributes}/>")
            }
            Self::Panel(panel) => panel.svg(),
        }
    }
}

impl PanelMark {
    /// An invisible rectangle of class `panel` with which programs read values off the sheet: `data-x`
    /// and `data-y` are the values at its left and right, bottom and top edges; `data-columns` the
    /// columns that hold them, unless these are those of their titles.
    fn svg(&self) -> String {
        let Self { bounds, frame: Frame { x, y }, titles, tables, only, columns, .. } = self;
        let mut attributes = String::new();
        // Writing to a String cannot fail.
        if !tables.is_empty() {
            let _ = write!(attributes, " data-tables=\"{}\"", escape(&tables.join(" ")));
        }
        if let Some((column, number)) = only {
            let _ = write!(attributes, " data-only=\"{} {number}\"", escape(column));
        }
        if let Some(columns) = columns {
            let _ = write!(attributes, " data-columns=\"{}\"", escape(&columns.join(" ")));
        }
        format!(
            "<rect class=\"panel\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" data-x=\"{} {}\" data-y=\"{} {}\" \
             data-x-title=\"{}\" data-y-title=\"{}\"{attributes}/>",
            points(bounds.left),
            points(bounds.top),
            points(bounds.right - bounds.left),
            points(bounds.bottom - bounds.top),
            x[0],
            x[1],
            y[0],
            y[1],
            escape(&titles[0]),
            escape(&titles[1]),
        )
    }
}

/// Path data with relative coordinates, without redundant characters.
fn short_path_data(path: &[Hundredths], closed: bool) -> String {
    let mut data = String::new();
    let mut push = |letter: &str, pair: [i32; 2]| {
        data.push_str(letter);
        for number in pair.map(hundredths) {
            let short = match number.strip_prefix("-0.") {
                Some(decimals) => format!("-.{decimals}"),
                None => number.strip_prefix("0.").map_or(number.clone(), |decimals| format!(".{decimals}")),
            };
            // A minus sign separates a number from the previous one, as letters do.
            if data.ends_with(|c: char| c.is_ascii_digit()) && !short.starts_with('-') {
                data.push(' ');
            }
            data.push_str(&short);
        }
    };
    for (place, &(x, y)) in path.iter().enumerate() {
        match place.checked_sub(1).map(|before| path[before]) {
            None => push("M", [x, y]),
            // A repeated command letter can be omitted.
            Some(before) => push(if place == 1 { "l" } else { "" }, [x - before.0, y - before.1]),
        }
    }
    data + if closed { "Z" } else { "" }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_paths_are_the_same_paths() {
        for (path, closed, short) in [
            (
                &[(2440, 8384), (2440, 8289), (2340, 8300), (3000, -500)][..],
                true,
                "M24.4 83.84l0-.95-1 .11 6.6-88Z",
            ),
            (&[(50, -25), (50, 25)], false, "M.5-.25l0 .5"),
            (&[(100, 100), (200, 200), (305, 200)], false, "M1 1l1 1 1.05 0"),
        ] {
            assert_eq!(short_path_data(path, closed), short);
        }
    }

    #[test]
    fn an_empty_legend_is_no_element() {
        let legend = vec![("a < b".to_owned(), "<path/>".to_owned())];
        let sheet = Sheet { legend, ..Sheet::default() };
        let defs = "<defs class=\"legend\"><g aria-label=\"a &lt; b\"><path/></g></defs>\n</svg>\n";
        assert!(sheet.svg().ends_with(defs));
        assert!(!Sheet::default().svg().contains("<defs"));
    }
}
