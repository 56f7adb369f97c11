//! A one-parameter bifurcation diagram: branches, attractor and bifurcations on one panel.

use core::cmp::Reverse;

use plotters::element::EmptyElement;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::branches::{BranchPoint, OneParameter};
use grazing_results::kinds::CurveLook;
use grazing_results::readings::Sweep;
use grazing_results::{Names, Stability};

use crate::error::DrawingError;
use crate::geometry::sheet::{Bounds, Spot, all_in_hundredths, length, near};
use crate::ink::elements::{Disc, Stroke};
use crate::ink::labels::{Labels, Site};
use crate::ink::legend;
use crate::ink::style::{
    CLOUD, LABEL_SIZE, NEUTRAL_DASHES, NEUTRAL_WIDTH, POINT_RADIUS, POINT_RIM, Paint, Pen, SMALL_LABEL_SIZE,
    STABLE_WIDTH, SWEEP_DOWN, SWEEP_SIZE, SWEEP_UP, THRESHOLD, UNSTABLE_WIDTH, branch_pen, several_pen,
};
use crate::plot::axes::Panel;
use crate::plot::cloud::{LONG_TIME, draw_cloud};
use crate::plot::kinds::{label, text_colour};

/// The number of dots of which one is named.
const NAMED_DOTS: usize = 40;

/// Numbers of impacts and of forcing periods of solutions.
type Numbers = (u32, u32);

/// Their name in a diagram.
fn name((impacts, loops): Numbers) -> String {
    match impacts {
        0 | 1 => format!("$p={loops}$"),
        _ => format!("{impacts}/{loops}"),
    }
}

/// The pen of their branches.
fn pen_of((impacts, loops): Numbers, width: f64) -> Pen {
    if impacts > 1 { several_pen(width) } else { branch_pen(loops, width) }
}

/// Draws branches, attractor and bifurcations of one panel, with their labels. Consecutive points with
/// equal p, impacts and branch are a strand: one loop of a solution as the parameter changes.
pub(crate) fn diagram(
    panel: &mut Panel<'_>,
    mut labels: Labels<'_>,
    figure: &OneParameter,
    names: &Names,
    every_loop: bool,
) -> Result<(), DrawingError> {
    let zero = panel.curve(&[(panel.frame.x[0], 0.0), (panel.frame.x[1], 0.0)], THRESHOLD);
    for level in panel.draw_series(zero)?.pieces {
        labels.placer.keep_off_nameless(&level);
    }
    let cloud: Vec<(f64, f64)> =
        figure.attractor.iter().map(|point| (figure.across(point), point.x)).collect();
    draw_cloud(panel, &cloud)?;
    for (sweep, pen, reach) in [(Sweep::Up, SWEEP_UP, -SWEEP_SIZE), (Sweep::Down, SWEEP_DOWN, SWEEP_SIZE)] {
        let frame = panel.frame;
        let seen = figure.swept(sweep).filter(|point| frame.contains(*point));
        // An arrowhead that points up or down.
        let head = [(-SWEEP_SIZE, 0.0), (0.0, reach), (SWEEP_SIZE, 0.0)];
        let heads = seen.map(|point| EmptyElement::at(point) + Stroke::new(all_in_hundredths(&head), pen));
        let meaning = format!("sweep {}", sweep.name());
        panel.draw_series(heads)?.label(&meaning).legend(legend::line(pen))?;
    }
    // The pieces of each kind of solutions.
    let mut pieces: Vec<(Numbers, Vec<Vec<Spot>>)> = Vec::new();
    let numbers = |point: &BranchPoint| (point.impacts, point.loops);
    let strands = figure.branches.chunk_by(|a, b| (numbers(a), a.branch) == (numbers(b), b.branch));
    let mut strands: Vec<_> = strands.collect();
    // Where branches coincide, the one with the fewest impacts and loops is visible: others have more strands.
    strands.sort_by_key(|strand| Reverse(numbers(&strand[0])));
    for strand in strands {
        let own = numbers(&strand[0]);
        for piece in strand_pieces(panel, figure, strand)? {
            labels.placer.keep_off(&piece);
            match pieces.iter_mut().find(|(known, _)| *known == own) {
                Some((_, known)) => known.push(piece),
                None => pieces.push((own, vec![piece])),
            }
        }
    }
    pieces.reverse();
    for (_, own) in &mut pieces {
        own.sort_by(|a, b| length(b).total_cmp(&length(a)));
    }
    for (own, _) in pieces.iter().filter(|((impacts, _), _)| *impacts == 1) {
        panel.canvas.explain(&name(*own), legend::line(pen_of(*own, STABLE_WIDTH)))?;
    }
    if pieces.iter().any(|((impacts, _), _)| *impacts > 1) {
        let meaning = "several impacts (impacts/periods)";
        panel.canvas.explain(meaning, legend::line(several_pen(STABLE_WIDTH)))?;
    }
    let dots: Vec<Spot> =
        cloud.iter().filter(|&&p| panel.frame.contains(p)).map(|&p| panel.spot(p)).collect();
    labels.placer.avoid(dots.iter().copied());
    let grazing = names.grazing_title();
    let mut named: Vec<(Bifurcation, Numbers)> = Vec::new();
    let visible: Vec<(Bifurcation, Numbers, (f64, f64))> = figure
        .bifurcations
        .iter()
        .map(|found| (found.kind, (found.impacts, found.loops), (figure.across(found), found.x)))
        .filter(|(_, _, point)| panel.frame.contains(*point))
        .collect();
    let disc = |&(kind, _, point): &(Bifurcation, Numbers, (f64, f64))| {
        Disc::new(point, POINT_RADIUS, Paint::opaque(CurveLook::of(kind).colours[0]), Some(POINT_RIM))
    };
    for spot in panel.draw_series(visible.iter().map(disc))?.pieces.concat() {
        labels.placer.block(Bounds::about(spot, 2.0 * POINT_RADIUS, 2.0 * POINT_RADIUS));
    }
    for &(kind, own, point) in &visible {
        // Solutions with several impacts have too many for names; their colours say the kind.
        if own.0 > 1 || !every_loop && named.contains(&(kind, own)) {
            continue;
        }
        named.push((kind, own));
        let wanted = Site::Around(panel.spot(point), POINT_RADIUS + 0.5);
        labels.add(label(kind, &grazing), LABEL_SIZE, text_colour(kind), &wanted)?;
    }
    for (numbers, own) in &pieces {
        let free = numbers.0 == 0;
        let text = if free { "non-impacting".to_owned() } else { name(*numbers) };
        let colour = pen_of(*numbers, 1.0).colour;
        let all: Vec<&[Spot]> = own.iter().map(Vec::as_slice).collect();
        let site = if every_loop || !free { Site::Pieces(&all) } else { Site::Beside(all[0]) };
        labels.add(&text, SMALL_LABEL_SIZE, colour, &site)?;
    }
    // Names of branches with several impacts leave no room for that of the dots, which the legend explains.
    if every_loop && pieces.iter().all(|((impacts, _), _)| *impacts < 2) {
        let some: Vec<Spot> = dots.iter().copied().step_by(1 + dots.len() / NAMED_DOTS).rev().collect();
        // Dots that lie beside the branches cannot be mistaken for them.
        let apart = |dot: &Spot| pieces.iter().flat_map(|(_, own)| own).all(|piece| !near(piece, *dot, 6.0));
        let beside: Vec<Spot> = some.iter().copied().filter(apart).collect();
        let named = if beside.is_empty() { &some } else { &beside };
        labels.add(LONG_TIME, SMALL_LABEL_SIZE, CLOUD[2].colour, &Site::AroundAny(named, 2.0))?;
    }
    labels.draw()
}

/// Draws a strand, thick where stable, thin where unstable and broken where neutral, with gaps only where it
/// is inadmissible; returns the drawn pieces.
fn strand_pieces(
    panel: &mut Panel<'_>,
    figure: &OneParameter,
    strand: &[BranchPoint],
) -> Result<Vec<Vec<Spot>>, DrawingError> {
    let place = |point: &BranchPoint| match point.admissible {
        true => (figure.across(point), point.x),
        false => (f64::NAN, f64::NAN),
    };
    let mut pieces = Vec::new();
    let mut start = 0;
    for run in strand.chunk_by(|a, b| a.stable == b.stable) {
        let BranchPoint { loops, impacts, stable, .. } = run[0];
        let pen = |numbers| match stable {
            Stability::Stable => pen_of(numbers, STABLE_WIDTH),
            Stability::Unstable => pen_of(numbers, UNSTABLE_WIDTH),
            Stability::Neutral => Pen { dashes: NEUTRAL_DASHES, ..pen_of(numbers, NEUTRAL_WIDTH) },
        };
        panel.canvas.explain(stable.name(), legend::line(pen((0, 0))))?;
        let end = start + run.len();
        let points: Vec<_> = strand[start..(end + 1).min(strand.len())].iter().map(place).collect();
        pieces.extend(panel.draw_series(panel.curve(&points, pen((impacts, loops))))?.pieces);
        start = end;
    }
    Ok(pieces)
}

#[cfg(test)]
mod tests {
    use super::*;
    use grazing_results::Frame;

    use crate::ink::canvas::Canvas;
    use crate::tests::samples::empty;

    #[test]
    fn stability_shows_in_the_width_and_leaves_no_gap() {
        let panel_points = |points: &[Vec<Spot>]| points.iter().map(Vec::len).collect::<Vec<_>>();
        let canvas = Canvas::new(100.0, 100.0).unwrap();
        let bounds = Bounds { left: 0.0, top: 0.0, right: 100.0, bottom: 100.0 };
        let frame = Frame { x: [0.0, 3.0], y: [-1.0, 1.0] };
        let mut panel = Panel::new(&canvas, frame, bounds).unwrap();
        let point = |(primary, x, stable): (f64, f64, Stability)| BranchPoint {
            diagram: 1,
            loops: 2,
            impacts: 1,
            wall: 0,
            secondary: 0.855,
            primary,
            x,
            visit: 1,
            impact_velocity: 0.1,
            impact_phase: 0.0,
            stable,
            admissible: true,
            branch: 1,
        };
        let [stable, neutral, unstable] = [true.into(), Stability::Neutral, false.into()];
        let strand = [(0.0, 0.0, unstable), (1.0, 0.1, unstable), (2.0, 0.4, neutral), (2.5, 0.6, stable)];
        let strand = strand.into_iter().chain([(3.0, 0.9, stable)]).map(point).collect::<Vec<_>>();
        let pieces = strand_pieces(&mut panel, &empty(frame), &strand).unwrap();
        assert_eq!(panel_points(&pieces), [3, 2, 2]);
        assert!(pieces.windows(2).all(|pair| pair[0].last() == pair[1].first()));
        let sheet = canvas.finish("test", "", "").unwrap();
        let words: Vec<&str> = sheet.legend.iter().map(|(words, _)| words.as_str()).collect();
        assert_eq!(words, ["unstable", "neutral", "stable"]);
        let svg = sheet.svg();
        assert!(
            ["0.55", "1.1", "1.7"].iter().all(|width| svg.contains(&format!("stroke-width=\"{width}\"")))
        );
    }
}
