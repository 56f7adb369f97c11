//! An edition: the formats and the width of the figures.

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use grazing_drawing::{Sheet, SheetWidth, unmarked};
use grazing_report::{Drawing, FormatError};

use crate::folder::OutputFile;

/// A format of the outputs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub enum Format {
    /// Figures as SVG.
    Svg,
    /// Figures as PDF.
    Pdf,
    /// Figures as PNG.
    Png,
    /// Tables as LaTeX, and a snippet that includes them and the figures as PDF.
    Tex,
    /// Tables as Parquet beside CSV, with units and meanings of columns as metadata.
    Parquet,
}

impl Format {
    /// The word on the command line.
    pub fn name(self) -> String {
        self.to_possible_value().map_or(String::new(), |value| value.get_name().to_owned())
    }
}

/// What labels are made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum TextForm {
    /// Text, which can be searched and changed, in embedded fonts.
    #[default]
    Fonts,
    /// Paths, which look alike where embedded fonts are ignored.
    Outlines,
}

/// The widths of figures: the word on the command line, the width and its meaning.
pub(crate) const WIDTHS: [(&str, SheetWidth, &str); 3] = [
    ("paper", SheetWidth::Paper, "As in the paper"),
    ("one", SheetWidth::OneColumn, "One column of a journal with two"),
    ("two", SheetWidth::TwoColumns, "Both columns"),
];

/// The width with this word; for any other, that of the paper.
pub(crate) fn width(word: &str) -> SheetWidth {
    WIDTHS.iter().find(|(name, ..)| *name == word).map(|(_, width, _)| *width).unwrap_or_default()
}

/// The formats and the width in which figures are made.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Edition {
    pub(crate) formats: Vec<Format>,
    pub(crate) columns: SheetWidth,
    pub(crate) dpi: u16,
    pub(crate) text: TextForm,
}

impl Default for Edition {
    /// SVG as wide as in the paper, which is what `figures/` holds.
    fn default() -> Edition {
        Edition { formats: vec![Format::Svg], columns: SheetWidth::Paper, dpi: 300, text: TextForm::Fonts }
    }
}

impl Edition {
    /// The edition that the command line asks for.
    pub fn new(mut formats: Vec<Format>, columns: SheetWidth, dpi: u16, text: TextForm) -> Edition {
        if formats.contains(&Format::Tex) {
            // The snippet includes the figures as PDF.
            formats.push(Format::Pdf);
        }
        formats.sort_unstable();
        formats.dedup();
        Edition { formats, columns, dpi, text }
    }

    /// Whether this is the edition of `figures/`.
    pub fn is_default(&self) -> bool {
        Edition { dpi: Edition::default().dpi, ..self.clone() } == Edition::default()
    }

    /// Whether the edition has the format.
    pub fn has(&self, format: Format) -> bool {
        self.formats.contains(&format)
    }

    /// The options that select the edition; none for the default one.
    pub(crate) fn options(&self) -> Vec<(&'static str, String)> {
        let mut options = Vec::new();
        if self.formats != [Format::Svg] {
            let names: Vec<String> = self.formats.iter().map(|format| format.name()).collect();
            options.push(("--format", names.join(",")));
        }
        // The first width is the default, which needs no option.
        for (word, ..) in WIDTHS[1..].iter().filter(|(_, width, _)| *width == self.columns) {
            options.push(("--columns", (*word).to_owned()));
        }
        if self.has(Format::Png) && self.dpi != Edition::default().dpi {
            options.push(("--dpi", self.dpi.to_string()));
        }
        if self.text == TextForm::Outlines {
            options.push(("--text", "outlines".to_owned()));
        }
        options
    }

    /// The files of a figure in all formats of the edition, given that of the SVG.
    pub(crate) fn figure_paths(&self, svg: &str) -> impl Iterator<Item = PathBuf> {
        let formats = self.formats.iter().filter(|format| !matches!(format, Format::Tex | Format::Parquet));
        formats.map(move |format| Path::new(svg).with_extension(format.name()))
    }

    /// A figure in all formats but LaTeX and Parquet, which have none. A PNG is left out if there is no `room`
    /// for the megabytes that it takes.
    pub(crate) fn figure_files(
        &self,
        file: &str,
        sheet: &Sheet,
        room: &Room<'_>,
    ) -> Result<(Vec<OutputFile>, Vec<PathBuf>), FormatError> {
        let mut svg = sheet.svg();
        if self.text == TextForm::Outlines {
            svg = sheet.svg_around(&Drawing::read(&svg)?.outlines());
        }
        let (mut files, mut left_out) = (Vec::new(), Vec::new());
        for (format, path) in self.formats.iter().zip(self.figure_paths(file)) {
            let content = match format {
                Format::Svg => svg.clone().into_bytes(),
                Format::Pdf => Drawing::read(&svg)?.pdf(&unmarked(&sheet.title))?,
                Format::Png => {
                    let (drawing, dpi) = (Drawing::read(&svg)?, f64::from(self.dpi));
                    if !room(drawing.png_megabytes(dpi)) {
                        left_out.push(path);
                        continue;
                    }
                    drawing.png(dpi)?
                }
                Format::Tex | Format::Parquet => continue,
            };
            files.push(OutputFile { path, content });
        }
        Ok((files, left_out))
    }
}

/// Whether there is room for so many megabytes.
pub(crate) type Room<'r> = dyn Fn(f64) -> bool + 'r;
