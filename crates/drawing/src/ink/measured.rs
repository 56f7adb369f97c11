//! Marks of measurements: the shape shows the measured behaviour, the filling whether it agrees with the
//! computed one.

use grazing_results::measured::{Agreement, SeenKind};

use crate::geometry::shapes::{diamond, octagon, plus, square};
use crate::geometry::sheet::{Hundredths, Spot, all_in_hundredths};
use crate::ink::style::{DISAGREES, DISAGREES_RIM, MARKER, MEASURED_OPEN, MEASURED_RIM, MEASURED_SIZE, Pen};
use crate::ink::svg::{fill, path_data, stroke};

/// The mark of a measurement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeasuredMark {
    /// The kind of measured behaviour.
    pub seen: SeenKind,
    /// Whether the measured behaviour agrees with the computed one.
    pub agreement: Agreement,
}

/// A path of a mark: its corners, whether it is closed, and its attributes.
pub(crate) type Stroke = (Vec<Hundredths>, bool, String);

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

    /// The paths of the mark about a spot.
    pub(crate) fn strokes(self, centre: Spot) -> Vec<Stroke> {
        let outline = match self.seen {
            SeenKind::NonImpacting => octagon(centre, 0.55 * MEASURED_SIZE),
            SeenKind::Loops => square(centre, 0.9 * MEASURED_SIZE),
            SeenKind::Other => diamond(centre, 1.25 * MEASURED_SIZE),
            SeenKind::Bifurcation => plus(centre, 1.35 * MEASURED_SIZE),
        };
        let agrees = matches!(self.agreement, Agreement::Agrees | Agreement::WithinError);
        let paint = if agrees { MARKER } else { MEASURED_OPEN };
        let mut all = vec![(all_in_hundredths(&outline), true, fill(paint) + &stroke(Some(MEASURED_RIM)))];
        if self.agreement == Agreement::Disagrees {
            let ((x, y), reach) = (centre, 0.85 * MEASURED_SIZE);
            let falling = [(x - reach, y - reach), (x + reach, y + reach)];
            let rising = [(x - reach, y + reach), (x + reach, y - reach)];
            let both =
                |pen: Pen| [falling, rising].map(|ends| (all_in_hundredths(&ends), false, stroke(Some(pen))));
            all.extend(both(DISAGREES_RIM).into_iter().chain(both(DISAGREES)));
        }
        all
    }

    /// The mark drawn for a legend, in a box of 24 by 10 points.
    pub(crate) fn element(self) -> String {
        let path = |(spots, closed, attributes): Stroke| {
            format!("<path d=\"{}\"{attributes}/>", path_data(&spots, closed))
        };
        self.strokes((12.0, 5.0)).into_iter().map(path).collect()
    }
}
