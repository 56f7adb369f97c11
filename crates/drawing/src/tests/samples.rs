//! Sheet widths, and an empty diagram for tests to fill.

use grazing_results::Frame;
use grazing_results::branches::OneParameter;
use grazing_results::readings::Ordinate;

use crate::ink::style::SheetWidth;

/// All widths of sheets.
pub(crate) const WIDTHS: [SheetWidth; 3] = [SheetWidth::OneColumn, SheetWidth::Paper, SheetWidth::TwoColumns];

/// A one-parameter diagram with nothing in it.
pub(crate) fn empty(frame: Frame) -> OneParameter {
    OneParameter {
        diagram: 1,
        primary_is_fixed: false,
        at: 0.855,
        frame,
        magnified: None,
        from_the_wall: false,
        branches: Vec::new(),
        bifurcations: Vec::new(),
        attractor: Vec::new(),
        portraits: Vec::new(),
        ordinate: Ordinate::X,
        readings: Vec::new(),
        motion: Vec::new(),
        simulated: None,
        broken: Vec::new(),
        notes: Vec::new(),
    }
}
