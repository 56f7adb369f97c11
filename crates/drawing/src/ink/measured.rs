//! Marks of measurements: the shape shows the measured behaviour, the filling whether it agrees with the
//! computed one.

use plotters::element::{DynElement, EmptyElement, IntoDynElement};
use plotters_backend::BackendCoord;

use grazing_results::measured::{Agreement, SeenKind};

use crate::geometry::shapes::{diamond, octagon, plus, square};
use crate::geometry::sheet::all_in_hundredths;
use crate::ink::canvas::Canvas;
use crate::ink::elements::{Area, Stroke};
use crate::ink::style::{DISAGREES, DISAGREES_RIM, MARKER, MEASURED_OPEN, MEASURED_RIM, MEASURED_SIZE, Pen};

/// The mark of a measurement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct MeasuredMark {
    /// The kind of measured behaviour.
    pub seen: SeenKind,
    /// Whether the measured behaviour agrees with the computed one.
    pub agreement: Agreement,
}

impl MeasuredMark {
    /// The explanation of the mark for the legend.
    pub(crate) fn meaning(self) -> String {
        let verdict = match self.agreement {
            Agreement::Agrees | Agreement::WithinError => "agrees",
            Agreement::Disagrees => "disagrees",
            Agreement::Undecided | Agreement::Silent => "undecided",
        };
        format!("measured: {}, {verdict}", self.seen.name())
    }

    /// The mark at a point.
    pub(crate) fn at<C: Clone + 'static>(self, point: C) -> DynElement<'static, Canvas, C> {
        let outline = match self.seen {
            SeenKind::NonImpacting => octagon((0.0, 0.0), 0.55 * MEASURED_SIZE),
            SeenKind::Loops => square((0.0, 0.0), 0.9 * MEASURED_SIZE),
            SeenKind::Other => diamond((0.0, 0.0), 1.25 * MEASURED_SIZE),
            SeenKind::Bifurcation => plus((0.0, 0.0), 1.35 * MEASURED_SIZE),
        };
        let agrees = matches!(self.agreement, Agreement::Agrees | Agreement::WithinError);
        let paint = if agrees { MARKER } else { MEASURED_OPEN };
        let mark =
            EmptyElement::at(point) + Area::ring(all_in_hundredths(&outline), paint, Some(MEASURED_RIM));
        if self.agreement != Agreement::Disagrees {
            return mark.into_dyn();
        }
        let reach = (85.0 * MEASURED_SIZE).round() as i32;
        let falling = |pen: Pen| Stroke::new([(-reach, -reach), (reach, reach)], pen);
        let rising = |pen: Pen| Stroke::new([(-reach, reach), (reach, -reach)], pen);
        let rim = mark + falling(DISAGREES_RIM) + rising(DISAGREES_RIM);
        (rim + falling(DISAGREES) + rising(DISAGREES)).into_dyn()
    }

    /// The mark for a legend.
    pub(crate) fn sample(self) -> impl Fn(BackendCoord) -> DynElement<'static, Canvas, BackendCoord> {
        move |(x, y)| self.at((x + 1200, y))
    }
}
