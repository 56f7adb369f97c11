//! Measurements in a parameter plane.

use grazing_results::measured::{Agreement, MeasuredPoint};

use crate::error::DrawingError;
use crate::geometry::sheet::Bounds;
use crate::ink::labels::Labels;
use crate::ink::measured::MeasuredMark;
use crate::ink::style::{ERROR_BAR, MEASURED_SIZE};
use crate::plot::axes::Panel;

/// Draws measurements with their error bars; those that disagree are on top.
pub(crate) fn draw_measured(
    panel: &mut Panel<'_>,
    labels: &mut Labels<'_>,
    points: &[MeasuredPoint],
) -> Result<(), DrawingError> {
    let mut seen: Vec<&MeasuredPoint> = points.iter().collect();
    seen.retain(|point| panel.frame.contains((point.primary, point.secondary)));
    seen.sort_by_key(|point| point.agreement == Agreement::Disagrees);
    for point in &seen {
        let (x, y) = (point.primary, point.secondary);
        let [dx, dy] = [point.primary_error, point.secondary_error].map(|error| error.max(0.0));
        // An error that is not stated is NaN, and becomes zero here.
        for ends in [[(x - dx, y), (x + dx, y)], [(x, y - dy), (x, y + dy)]] {
            if ends[0] != ends[1] {
                panel.draw_series(panel.curve(&ends, ERROR_BAR))?;
            }
        }
    }
    for point in seen {
        let mark = MeasuredMark { seen: point.kind, agreement: point.agreement };
        let place = (point.primary, point.secondary);
        panel.draw_series([mark.at(place)])?.label(&mark.meaning()).legend(mark.sample())?;
        labels.placer.block(Bounds::about(panel.spot(place), 1.7 * MEASURED_SIZE, 1.7 * MEASURED_SIZE));
    }
    Ok(())
}
