//! Resonances, coefficients and codimension-two points as functions of a constant of the oscillator.

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};
use grazing_results::Names;
use grazing_results::family::{Degeneracy, Degenerate, Family, FamilyCurvePoint, FamilyPanel, Shows};
use grazing_results::kinds::CurveLook;

use crate::error::DrawingError;
use crate::geometry::clip::checked;
use crate::geometry::sheet::{Spot, length};
use crate::ink::elements::Disc;
use crate::ink::labels::{Labels, Site};
use crate::ink::sheet::Sheet;
use crate::ink::style::{
    BLACK, Colour, GUIDE, LABEL_SIZE, POINT_RADIUS, POINT_RIM, Paint, Pen, SMALL_LABEL_SIZE, SheetWidth,
    TICK_SIZE,
};
use crate::plot::axes::{Heading, Panel};
use crate::plot::kinds::text_colour;
use crate::plot::magnified::panel_letter;
use crate::plot::panel_grid::{GridPanel, draw_panels, sheets};

/// Curves shorter than this on the sheet (points) have no label.
const LABELLED_LENGTH: f64 = 18.0;
/// The fraction of white mixed into the curves of the last member of the other constants.
const PALEST: f64 = 0.6;
/// Ends of arcs this close, as a fraction of the secondary parameter, are the same resonance.
const SAME_RESONANCE: f64 = 1e-6;
/// The radius of the discs that mark members on curves, in points.
const MEMBER_RADIUS: f64 = 1.1;

/// Draws a family with these names of its columns, under a title.
///
/// The panels are over the constant that varies first: for each p, the secondary parameter at resonances
/// and other codimension-two points, c_SN, and c_PD. Curves for further constants are paler the further
/// these are from their first values.
///
/// # Errors
/// [`DrawingError`] if a frame is empty.
pub fn draw_family(
    family: &Family,
    names: &Names,
    title: &str,
    width: SheetWidth,
) -> Result<Vec<Sheet>, DrawingError> {
    let varied = names.varied_titles();
    let across = varied.first().map_or("", String::as_str);
    let others = varied.get(1..).unwrap_or_default().join(", then ");
    let up: Vec<String> = family.panels.iter().map(|panel| quantity(panel, names)).collect();
    let sheets = sheets(width, family.panels.len());
    let panel = |(place, panel): (usize, &FamilyPanel)| {
        let FamilyPanel { frame, loops, .. } = panel;
        let letter = (format!("{}  $p={loops}$", panel_letter(place as u32 + 1)), LABEL_SIZE);
        let is_first = sheets.iter().any(|sheet| sheet.start == place);
        let (first, (second, size)) = match is_first && !others.is_empty() {
            true => (letter, (format!("dark to pale: {others}"), TICK_SIZE)),
            false => ((String::new(), LABEL_SIZE), letter),
        };
        let frame = checked(*frame, "a panel of a family")?;
        let (up, parts) = (up[place].as_str(), (vec![second], size));
        Ok(GridPanel { frame, up, decades: None, names: None, only: None, first, parts })
    };
    let panels = family.panels.iter().enumerate().map(panel);
    let panels: Vec<_> = panels.collect::<Result<_, DrawingError>>()?;
    let heading = Heading {
        name: "family",
        title,
        description: "A constant of the oscillator across. Up: the secondary parameter at resonant grazing bifurcations and other \
                      codimension-two points, and the quadratic coefficients of the saddle-node and period-doubling curves.",
        names,
        tables: &["family_curves", "family_points"],
    };
    draw_panels(&heading, (width, &[]), across, &panels, |panel, place| {
        draw_panel(panel, family, &family.panels[place], varied.len())
    })
}

/// The quantity on the vertical axis of a panel.
fn quantity(panel: &FamilyPanel, names: &Names) -> String {
    let loops = panel.loops;
    match panel.shows {
        Shows::Secondary => names.titles()[1].clone(),
        Shows::SaddleNode => format!(r"$c_{{\mathrm{{SN}},{loops}}}$"),
        Shows::PeriodDoubling => format!(r"$c_{{\mathrm{{PD}},{loops}}}$"),
    }
}

/// The constants of a row: the one that varies first, then the others.
fn across(varied: [f64; 3], count: usize) -> (f64, Vec<f64>) {
    let mut own = varied[varied.len() - count..].iter().copied();
    (own.next().unwrap_or(f64::NAN), own.collect())
}

fn draw_panel(
    panel: &mut Panel<'_>,
    family: &Family,
    shown: &FamilyPanel,
    count: usize,
) -> Result<(), DrawingError> {
    let mut labels = Labels::new(panel.canvas, panel.bounds);
    let varied = |row: &FamilyCurvePoint| across(row.varied, count);
    // The value of a row that the vertical axis shows.
    let up = |secondary: f64, c_sn: f64, c_pd: f64| match shown.shows {
        Shows::Secondary => secondary,
        Shows::SaddleNode => c_sn,
        Shows::PeriodDoubling => c_pd,
    };
    let (colour, infinite) = match shown.shows {
        Shows::Secondary => (BLACK, None),
        Shows::SaddleNode => (text_colour(Bifurcation::SaddleNode), Some(Degeneracy::InfiniteSaddleNode)),
        Shows::PeriodDoubling => {
            (text_colour(Bifurcation::PeriodDoubling), Some(Degeneracy::InfinitePeriodDoubling))
        }
    };
    let mut others: Vec<Vec<f64>> = family.members.iter().map(|row| across(row.varied, count).1).collect();
    others.dedup();
    let shade = |other: &[f64]| {
        let place = others.iter().position(|known| known == other).unwrap_or(0);
        pale(colour, PALEST * place as f64 / others.len().saturating_sub(1).max(1) as f64)
    };
    let infinite = |row: &&Degenerate| {
        let meaning = infinite.filter(|own| [*own, Degeneracy::Infinite].contains(&row.meaning));
        row.loops == shown.loops && meaning.is_some()
    };
    for row in family.degenerate.iter().filter(infinite) {
        let (value, _) = across(row.varied, count);
        let [low, high] = shown.frame.y;
        panel.draw_series(panel.curve(&[(value, low), (value, high)], GUIDE))?;
    }
    // Curves for the first values of the other constants are drawn last, above the rest.
    let mut strands = strands(family, shown.loops, |row| {
        (varied(row).0, up(row.secondary, row.coefficients.c_sn, row.coefficients.c_pd))
    });
    strands.sort_by_key(|(first, _)| {
        core::cmp::Reverse(others.iter().position(|other| *other == varied(first).1))
    });
    let mut longest: Vec<(u32, Vec<Spot>)> = Vec::new();
    for (first, points) in &strands {
        let width = CurveLook::of(Bifurcation::SaddleNode).width;
        let pen = Pen { colour: shade(&varied(first).1), width, dashes: &[], round: true };
        let pieces = panel.draw_series(panel.curve(points, pen))?.pieces;
        pieces.iter().for_each(|piece| labels.placer.keep_off(piece));
        let best = pieces.into_iter().max_by(|a, b| length(a).total_cmp(&length(b)));
        longest.extend(best.map(|piece| (first.n, piece)));
    }
    longest.reverse();
    for row in family.resonances.iter().filter(|row| row.loops == shown.loops) {
        let (value, other) = across(row.varied, count);
        let place = (value, up(row.secondary, row.coefficients.c_sn, row.coefficients.c_pd));
        if panel.frame.contains(place) {
            panel.draw_series([Disc::new(place, MEMBER_RADIUS, Paint::opaque(shade(&other)), None)])?;
        }
    }
    if shown.shows == Shows::Secondary {
        points(panel, &mut labels, family, shown.loops, count)?;
    }
    let mut named = Vec::new();
    for (n, piece) in longest.iter().filter(|(_, piece)| length(piece) >= LABELLED_LENGTH) {
        // With further constants, curves of the same n are close to each other.
        if count > 1 && named.contains(n) {
            continue;
        }
        named.push(*n);
        labels.add(&format!("$n={n}$"), SMALL_LABEL_SIZE, colour, &Site::Beside(piece))?;
    }
    labels.draw()
}

/// A polyline through a family: its first and last row, and its points.
type Strand<'a> = (&'a FamilyCurvePoint, &'a FamilyCurvePoint, Vec<(f64, f64)>);

/// The resonances of p loops from member to member. Consecutive arcs of one curve are joined into one
/// polyline.
fn strands(
    family: &Family,
    loops: u32,
    place: impl Fn(&FamilyCurvePoint) -> (f64, f64),
) -> Vec<(&FamilyCurvePoint, Vec<(f64, f64)>)> {
    let mut strands: Vec<Strand<'_>> = Vec::new();
    let own: Vec<&FamilyCurvePoint> = family.curves.iter().filter(|row| row.loops == loops).collect();
    for arc in own.chunk_by(|a, b| a.arc == b.arc) {
        let (first, last) = (arc[0], arc[arc.len() - 1]);
        let points = arc.iter().map(|row| place(row));
        let meets = |end: &FamilyCurvePoint| {
            (end.curve, end.n) == (first.curve, first.n)
                && place(end).0 == place(first).0
                && (end.secondary - first.secondary).abs() < SAME_RESONANCE * first.secondary.abs()
        };
        if let Some((_, end, known)) = strands.iter_mut().find(|(_, end, _)| meets(end)) {
            known.extend(points.skip(1));
            *end = last;
        } else if let Some((start, _, known)) = strands.iter_mut().find(|(start, _, _)| meets(start)) {
            // This arc was followed to the other side from the same member.
            known.splice(0..1, points.rev());
            *start = last;
        } else {
            strands.push((first, last, points.collect()));
        }
    }
    strands.into_iter().map(|(first, _, points)| (first, points)).collect()
}

/// Draws codimension-two points other than resonances, in the colour of the curve that ends on the GZ
/// curve there; the point of each kind that is nearest to the middle of the panel is named.
fn points(
    panel: &mut Panel<'_>,
    labels: &mut Labels<'_>,
    family: &Family,
    loops: u32,
    count: usize,
) -> Result<(), DrawingError> {
    let middle = f64::midpoint(panel.bounds.left, panel.bounds.right);
    let off = |spot: &Spot| (spot.0 - middle).abs();
    let mut named: Vec<(CodimensionTwo, Bifurcation, Spot)> = Vec::new();
    for row in family.points.iter().filter(|row| row.loops == loops) {
        let (value, _) = across(row.varied, count);
        if !panel.frame.contains((value, row.secondary)) {
            continue;
        }
        let curves = row.kind.curves();
        let kind = if curves.contains(&Bifurcation::Torus) { Bifurcation::Torus } else { curves[0] };
        let place = (value, row.secondary);
        let (spot, paint) = (panel.spot(place), Paint::opaque(pale(CurveLook::of(kind).colours[0], 0.35)));
        panel.draw_series([Disc::new(place, 0.7 * POINT_RADIUS, paint, Some(POINT_RIM))])?;
        labels.placer.avoid([spot].into_iter());
        match named.iter_mut().find(|(name, ..)| *name == row.kind) {
            Some((_, _, nearest)) if off(&spot) < off(nearest) => *nearest = spot,
            Some(_) => {}
            None => named.push((row.kind, kind, spot)),
        }
    }
    for (name, kind, spot) in named {
        let around = Site::Around(spot, POINT_RADIUS);
        labels.add(name.name(), SMALL_LABEL_SIZE, text_colour(kind), &around)?;
    }
    Ok(())
}

/// A colour mixed with white.
fn pale(colour: Colour, share: f64) -> Colour {
    colour.map(|own| (f64::from(own) * (1.0 - share) + 255.0 * share) as u8)
}

#[cfg(test)]
mod tests {
    use grazing_results::Frame;
    use grazing_results::family::FamilyPoint;
    use grazing_results::resonance::Coefficients;

    use super::*;
    use crate::tests::samples::WIDTHS;

    /// A sample family of two constants with curves of p = 1 and 2, one of which has a pole.
    fn sample(scale: f64) -> Family {
        let kinds = [CodimensionTwo::SaddleNodeGrazing, CodimensionTwo::PeriodDoublingGrazing];
        let (mut curves, mut points, mut degenerate) = (Vec::new(), Vec::new(), Vec::new());
        for (number, (loops, n, other)) in
            [(1, 1, 0.0), (1, 2, 0.0), (2, 1, 0.0), (1, 1, 1.0), (1, 2, 1.0)].into_iter().enumerate()
        {
            for k in 0..=40_u32 {
                let share = f64::from(k) / 40.0;
                let pole = if loops == 1 { share - 0.41 } else { 1.0 };
                let row = FamilyCurvePoint {
                    varied: [f64::NAN, scale * share, other],
                    loops,
                    wall: 0,
                    n,
                    curve: number as u32,
                    arc: number as u32 * 4 + k.min(39) / 10,
                    secondary: f64::from(n) / f64::from(loops + 1) + 0.2 * share * share + 0.05 * other,
                    primary: 0.5,
                    coefficients: Coefficients {
                        s_plus: 1.0,
                        s_minus: 1.0,
                        c_sn: -2.0 * scale / pole,
                        c_pd: 40.0 * scale * (1.0 + share * f64::from(n)),
                    },
                    end: String::new(),
                };
                if k % 10 == 0 {
                    points.push(FamilyPoint {
                        varied: row.varied,
                        kind: kinds[number % 2],
                        loops,
                        wall: 0,
                        n,
                        secondary: row.secondary - 0.1 * share,
                        primary: 0.5,
                        impact_velocity: 0.1,
                    });
                    if k > 0 && k < 40 {
                        curves.push(FamilyCurvePoint { arc: row.arc - 1, ..row.clone() });
                    }
                }
                curves.push(row);
            }
            degenerate.push(Degenerate {
                varied: [f64::NAN, scale * 0.41, other],
                loops,
                wall: 0,
                n,
                curve: 0,
                quantity: "s_p^+".to_owned(),
                meaning: Degeneracy::InfiniteSaddleNode,
                secondary: 0.5,
                primary: 0.5,
            });
        }
        let panel = |loops, shows, y| FamilyPanel { loops, shows, frame: Frame { x: [0.0, scale], y } };
        let panels = [1, 2].into_iter().flat_map(|loops| {
            [
                panel(loops, Shows::Secondary, [0.2, 1.3]),
                panel(loops, Shows::SaddleNode, [-20.0 * scale, 20.0 * scale]),
                panel(loops, Shows::PeriodDoubling, [0.0, 130.0 * scale]),
            ]
        });
        let panels = panels.collect();
        Family { members: vec![], resonances: vec![], points, curves, degenerate, panels, incomplete: 0 }
    }

    #[test]
    fn no_two_labels_overlap_at_any_scale_and_width_and_every_panel_has_its_letter() {
        let names = Names::new("A", "omega").with_varied(&["kappa".to_owned(), "long_name".to_owned()]);
        for scale in [1.0, 3e-7, 2e5] {
            for width in WIDTHS {
                let sheets = draw_family(&sample(scale), &names, "", width).unwrap();
                sheets.iter().for_each(|sheet| sheet.assert_well_placed(&(scale, width)));
                let texts: Vec<String> = sheets.iter().flat_map(Sheet::texts).collect();
                for (letter, loops) in ["a", "b", "c", "d", "e", "f"].into_iter().zip([1, 1, 1, 2, 2, 2]) {
                    assert!(texts.contains(&format!("({letter})  $p={loops}$")), "{texts:?}");
                }
            }
        }
    }

    #[test]
    fn arcs_that_follow_each_other_are_one_curve_whichever_way_they_were_followed() {
        let whole = sample(1.0);
        let along = |family: &Family| -> Vec<usize> {
            let strands = strands(family, 1, |row| (row.varied[1], row.secondary));
            strands.iter().map(|(_, points)| points.len()).collect()
        };
        assert_eq!(along(&whole), [41; 4]);
        let mut turned = whole.clone();
        let first = turned.curves.iter().take_while(|row| row.arc == turned.curves[0].arc).count();
        // The first arc is followed from its other end and comes after the second.
        turned.curves[..first].reverse();
        turned.curves[..2 * first].rotate_left(first);
        assert_eq!(along(&turned), [41; 4]);
    }
}
