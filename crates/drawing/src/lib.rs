//! The figures of the paper as SVG, drawn from data frames.

mod axes;
mod canvas;
mod clip;
mod cloud;
mod error;
mod fig02;
mod fig07;
mod fig08;
mod font;
mod frames;
mod kinds;
mod labels;
mod markup;
mod placement;
mod portraits;
mod simplify;
mod style;
mod svg_backend;
mod ticks;

pub use clip::Window;
pub use error::DrawingError;
pub use fig02::{Figure02, draw_fig02};
pub use fig07::{Figure07, Magnified, Section, draw_fig07};
pub use fig08::{Figure08, draw_fig08};
pub use font::FONT_FILES;
pub use style::{DOUBLE_COLUMN_MM, SINGLE_COLUMN_MM};
