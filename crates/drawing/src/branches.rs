//! A one-parameter bifurcation diagram: branches, attractor and bifurcations on one panel of Figure 2.

use crate::DrawingError;
use crate::axes::Panel;
use crate::canvas::Ink;
use crate::cloud::draw_cloud;
use crate::frames::{Table, runs};
use crate::kinds::Kind;
use crate::labels::{Labels, Wanted};
use crate::sheet::{Bounds, Spot, length};
use crate::style::{
    LABEL_SIZE, POINT_RADIUS, POINT_RIM, Paint, SMALL_LABEL_SIZE, STABLE_WIDTH, THRESHOLD, UNSTABLE_WIDTH,
    branch_pen,
};

/// A branch of Figure 2: one loop of a solution as the amplitude changes.
pub(crate) struct Branch {
    p: i64,
    points: Vec<(f64, f64)>,
    stable: Vec<bool>,
}

/// A bifurcation of Figure 2.
pub(crate) struct Bifurcation {
    kind: Kind,
    p: i64,
    point: (f64, f64),
}

/// Branches, attractor and bifurcations of one panel, with their labels.
pub(crate) fn diagram(
    panel: &Panel<'_>,
    mut labels: Labels<'_>,
    branches: &[Branch],
    bifurcations: &[Bifurcation],
    cloud: &[(f64, f64)],
    every_loop: bool,
) -> Result<(), DrawingError> {
    for level in panel.line(&[(panel.window.x[0], 0.0), (panel.window.x[1], 0.0)], THRESHOLD)? {
        labels.placer.keep_off_nameless(&level);
    }
    draw_cloud(panel, cloud)?;
    labels.placer.avoid(cloud.iter().filter(|&&p| panel.window.contains(p)).map(|&p| panel.spot(p)));
    let mut longest: Vec<(i64, Vec<Spot>)> = Vec::new();
    for branch in branches {
        for piece in branch_pieces(panel, branch)? {
            labels.placer.keep_off(&piece);
            match longest.iter_mut().find(|(p, _)| *p == branch.p) {
                Some((_, best)) if length(best) >= length(&piece) => {}
                Some((_, best)) => *best = piece,
                None => longest.push((branch.p, piece)),
            }
        }
    }
    let mut named: Vec<(Kind, i64)> = Vec::new();
    let visible: Vec<&Bifurcation> = bifurcations.iter().filter(|b| panel.window.contains(b.point)).collect();
    for bifurcation in &visible {
        let spot = panel.spot(bifurcation.point);
        let paint = Paint { colour: bifurcation.kind.pen().colour, opacity: 1.0 };
        panel.canvas.draw(&[spot], Ink::Disc(POINT_RADIUS, paint, Some(POINT_RIM)))?;
        labels.placer.block(Bounds::about(spot, 2.0 * POINT_RADIUS, 2.0 * POINT_RADIUS));
    }
    for bifurcation in &visible {
        let name = (bifurcation.kind, bifurcation.p);
        if !every_loop && named.contains(&name) {
            continue;
        }
        named.push(name);
        let (kind, spot) = (bifurcation.kind, panel.spot(bifurcation.point));
        labels.add(
            kind.label(),
            LABEL_SIZE,
            kind.text_colour(),
            &Wanted::Around(spot, POINT_RADIUS + 0.5),
        )?;
    }
    for (p, piece) in &longest {
        let text = if *p == 0 { "non-impacting".to_owned() } else { format!("$p={p}$") };
        labels.add(&text, SMALL_LABEL_SIZE, branch_pen(*p, 1.0).colour, &Wanted::Beside(piece))?;
    }
    labels.draw()
}

/// Draws a branch, thick where stable and thin where unstable, without gaps between; returns what was drawn.
fn branch_pieces(panel: &Panel<'_>, branch: &Branch) -> Result<Vec<Vec<Spot>>, DrawingError> {
    let mut pieces = Vec::new();
    for rows in runs(&branch.stable) {
        let width = if branch.stable[rows.start] { STABLE_WIDTH } else { UNSTABLE_WIDTH };
        let end = (rows.end + 1).min(branch.points.len());
        pieces.extend(panel.line(&branch.points[rows.start..end], branch_pen(branch.p, width))?);
    }
    Ok(pieces)
}

/// Reads the frame of branches; inadmissible rows become gaps.
pub(crate) fn read_branches(table: Table<'_>) -> Result<Vec<Branch>, DrawingError> {
    let (p, branch) = (table.integers("p")?, table.integers("branch")?);
    let (amplitude, x) = (table.numbers("amplitude")?, table.numbers("x")?);
    let (stable, admissible) = (table.flags("stable")?, table.flags("admissible")?);
    let keys: Vec<_> = p.iter().zip(&branch).collect();
    Ok(runs(&keys)
        .into_iter()
        .map(|rows| Branch {
            p: p[rows.start],
            stable: stable[rows.clone()].to_vec(),
            points: rows
                .map(|i| if admissible[i] { (amplitude[i], x[i]) } else { (f64::NAN, f64::NAN) })
                .collect(),
        })
        .collect())
}

/// Reads the frame of bifurcations.
pub(crate) fn read_bifurcations(table: Table<'_>) -> Result<Vec<Bifurcation>, DrawingError> {
    let kinds = table.words("kind", Kind::KNOWN, Kind::parse)?;
    let p = table.integers("p")?;
    let (amplitude, x) = (table.numbers("amplitude")?, table.numbers("x")?);
    let rows = kinds.into_iter().enumerate();
    Ok(rows.map(|(i, kind)| Bifurcation { kind, p: p[i], point: (amplitude[i], x[i]) }).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::canvas::Canvas;
    use crate::clip::Window;

    #[test]
    fn stability_shows_in_the_width_and_leaves_no_gap() {
        let panel_points = |points: &[Vec<Spot>]| points.iter().map(Vec::len).collect::<Vec<_>>();
        let canvas = Canvas::new(100.0, 100.0).unwrap();
        let bounds = Bounds { left: 0.0, top: 0.0, right: 100.0, bottom: 100.0 };
        let panel = Panel::new(&canvas, Window { x: [0.0, 3.0], y: [-1.0, 1.0] }, bounds);
        let branch = Branch {
            p: 2,
            points: vec![(0.0, 0.0), (1.0, 0.1), (2.0, 0.4), (3.0, 0.9)],
            stable: vec![false, false, true, true],
        };
        let pieces = branch_pieces(&panel, &branch).unwrap();
        assert_eq!(panel_points(&pieces), [3, 2]);
        assert_eq!(pieces[0].last(), pieces[1].first());
        let svg = canvas.finish("test", "", "").unwrap();
        assert!(svg.contains("stroke-width=\"0.55\"") && svg.contains("stroke-width=\"1.7\""));
    }
}
