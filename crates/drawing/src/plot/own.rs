//! Curves in a parameter plane that a file requests.

use grazing_results::plane::OwnPoint;

use crate::error::DrawingError;
use crate::geometry::sheet::{Spot, length};
use crate::ink::labels::{Labels, Site};
use crate::ink::legend;
use crate::ink::style::{OWN_TEXT, SMALL_LABEL_SIZE, own_pens};
use crate::plot::axes::Panel;

/// The pieces of the curves with a name and a number of loops.
pub(crate) struct OwnCurvePieces {
    label: String,
    /// The pieces, each with whether its solutions are stable.
    pieces: Vec<(bool, Vec<Spot>)>,
}

/// Draws the curves where their solutions are admissible, with thin lines where they are not stable.
/// Returns the pieces for each name and number of loops with their label, the best ones for the label
/// first: stable and long ones.
pub(crate) fn draw_own(
    panel: &mut Panel<'_>,
    labels: &mut Labels<'_>,
    rows: &[OwnPoint],
) -> Result<Vec<OwnCurvePieces>, DrawingError> {
    let mut drawn: Vec<OwnCurvePieces> = Vec::new();
    let mut names: Vec<&str> = Vec::new();
    for curve in rows.chunk_by(|a, b| a.at.arc == b.at.arc) {
        let (name, loops) = (&curve[0].name, curve[0].loops);
        let alone = rows.iter().all(|row| row.name != *name || row.loops == loops);
        let label = if alone { name.clone() } else { format!("{name}, $p={loops}$") };
        let number = names.iter().position(|known| known == name).unwrap_or(names.len());
        if number == names.len() {
            names.push(name);
        }
        let pens = own_pens(number);
        // The chord between a bifurcation and the solutions beside it is drawn like these solutions.
        let look = |pair: &[OwnPoint]| {
            let admissible = pair.iter().all(|point| point.at.admissible);
            admissible.then(|| usize::from(pair.iter().all(|point| !point.at.stable.is_stable())))
        };
        let looks: Vec<Option<usize>> = curve.windows(2).map(look).collect();
        let mut from = 0;
        for run in looks.chunk_by(|a, b| a == b) {
            let places =
                curve[from..=from + run.len()].iter().map(|point| (point.at.primary, point.at.secondary));
            from += run.len();
            let Some(unstable) = run[0] else { continue };
            let curves = panel.curve(&places.collect::<Vec<_>>(), pens[unstable]);
            let meaning = format!("{name}: {}", curve[0].property);
            for piece in panel.draw_series(curves)?.label(&meaning).legend(legend::line(pens[0]))?.pieces {
                labels.placer.keep_off(&piece);
                let stable = unstable == 0;
                match drawn.iter_mut().find(|known| known.label == label) {
                    Some(known) => known.pieces.push((stable, piece)),
                    None => {
                        drawn.push(OwnCurvePieces { label: label.clone(), pieces: vec![(stable, piece)] })
                    }
                }
            }
        }
    }
    for OwnCurvePieces { pieces, .. } in &mut drawn {
        pieces.sort_by(|(a, one), (b, other)| b.cmp(a).then(length(other).total_cmp(&length(one))));
    }
    Ok(drawn)
}

/// Labels the curves where there is room beside a piece, or else with a leader to one.
pub(crate) fn name_own(labels: &mut Labels<'_>, drawn: &[OwnCurvePieces]) -> Result<(), DrawingError> {
    for OwnCurvePieces { label, pieces } in drawn {
        let pieces: Vec<&[Spot]> = pieces.iter().map(|(_, piece)| piece.as_slice()).collect();
        labels.add(label, SMALL_LABEL_SIZE, OWN_TEXT, &Site::Pieces(&pieces))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SheetWidth;
    use crate::figures::diagram::draw_diagram;
    use crate::tests::inspection::paths;
    use crate::tests::sample_oscillator::sample;
    use grazing_results::plane::{OnCurve, Property};

    #[test]
    fn own_curves_are_drawn_where_solutions_are_admissible_and_have_their_names() {
        let mut sample = sample(2);
        let row = |k: u32| OwnPoint {
            name: "hard hits".to_owned(),
            property: Property::ImpactVelocity(0.3),
            loops: 1,
            at: OnCurve {
                secondary: 0.4 + 0.005 * f64::from(k),
                primary: 0.9,
                impact_velocity: 0.3,
                impact_phase: 0.0,
                trace: 0.0,
                determinant: 0.0,
                max_interior_x: f64::NAN,
                stable: (k < 60).into(),
                admissible: k < 80,
                arc: 0,
                lost: if k == 99 { "no further point was found".to_owned() } else { String::new() },
            },
        };
        sample.diagram.own = (0..100).map(row).collect();
        let sheet = draw_diagram(&sample.diagram, &sample.heading(), SheetWidth::Paper).unwrap();
        sheet.assert_well_placed(&"own curves");
        assert!(sheet.texts().contains(&"hard hits".to_owned()), "{:?}", sheet.texts());
        let drawn = paths(&sheet.svg(), "#a26cd8");
        // A ring marks where the curve was followed no further.
        sample.diagram.own[99].at.lost.clear();
        let whole = draw_diagram(&sample.diagram, &sample.heading(), SheetWidth::Paper).unwrap();
        let discs = |sheet: &crate::Sheet| sheet.svg().matches("<circle").count();
        assert!(discs(&sheet) > discs(&whole));
        // A stable and an unstable part, which meet, and no other part.
        assert_eq!(drawn.len(), 2);
        assert_eq!(drawn[0].last(), drawn[1].first());
        let up = |spot: &(f64, f64)| spot.1;
        let [low, high] = [drawn[0].first(), drawn[1].last()].map(|spot| up(spot.unwrap()));
        let whole = 0.005 * 79.0 / (sample.diagram.frame.y[1] - sample.diagram.frame.y[0]);
        let stable = 0.005 * 60.0 / (sample.diagram.frame.y[1] - sample.diagram.frame.y[0]);
        let share = (low - up(drawn[0].last().unwrap())) / (low - high);
        assert!((share - stable / whole).abs() < 0.02, "{share}");
    }
}
