//! From a study's frames to figures: one function a figure.

use grazing_drawing::{
    Figure01, Figure02, Figure03, Figure04, Figure05, Figure06, Figure07, Figure08, Figure09, Figure10,
    Magnified, Section, SheetWidth, Window, draw_fig01, draw_fig02, draw_fig03, draw_fig04, draw_fig05,
    draw_fig06, draw_fig07, draw_fig08, draw_fig09, draw_fig10,
};
use grazing_reproduction::parameters::{Range, Rectangle};
use grazing_reproduction::{Coefficients, Study, StudyError};

use super::{Made, MadeResult};

pub(super) fn coefficients(study: &Study<'_>, _: SheetWidth) -> MadeResult {
    let notes = study.coefficients()?.iter().flat_map(Coefficients::doubts).collect();
    // A curve that is missing is none of the table's business.
    let gaps = study.gaps()?.into_iter().filter(|gap| matches!(gap, StudyError::Unlocated { .. }));
    let gaps = gaps.map(|gap| gap.to_string()).collect();
    Ok(Made { notes, gaps, ..Made::tables(vec![study.coefficient_table()?]) })
}

pub(super) fn fig01(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig01()?;
    let figure =
        Figure01 { curves: &made.curves.frame, points: &made.points.frame, surfaces: &made.surfaces.frame };
    Ok(Made::figure(draw_fig01(&figure, width)?, made.tables()))
}

pub(super) fn fig02(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig02()?;
    let shown = study.parameters().fig02()?;
    let figure = Figure02 {
        branches: &made.branches.frame,
        bifurcations: &made.bifurcations.frame,
        attractor: &made.attractor.frame,
        portraits: &made.portraits.frame,
        window: window(shown.amplitude(), shown.x()),
        magnification: window(shown.magnified_amplitude(), shown.magnified_x()),
    };
    let figure = draw_fig02(&figure, width)?;
    Ok(Made { notes: made.notes.clone(), ..Made::figure(figure, made.tables()) })
}

pub(super) fn fig03(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig03()?;
    let figure =
        Figure03 { curves: &made.curves.frame, points: &made.points.frame, surfaces: &made.surfaces.frame };
    Ok(Made::figure(draw_fig03(&figure, width)?, made.tables()))
}

pub(super) fn fig04(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig04()?;
    let figure = Figure04 { curves: &made.curves.frame, points: &made.points.frame };
    Ok(Made::figure(draw_fig04(&figure, width)?, made.tables()))
}

pub(super) fn fig05(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig05()?;
    let shown = study.parameters().fig05()?;
    let figure = Figure05 {
        curves: &made.curves.frame,
        points: &made.points.frame,
        regions: &made.regions.frame,
        window: window(shown.mu(), shown.eta()),
    };
    Ok(Made::figure(draw_fig05(&figure, width)?, made.tables()))
}

pub(super) fn fig06(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig06()?;
    let figure = draw_fig06(&Figure06 { parts: &made.parts.frame }, width)?;
    Ok(Made::figure(figure, made.tables()))
}

pub(super) fn fig07(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig07()?;
    // Where Figures 2 and 8 cannot be made, this one does not say where they lie.
    let section = study.parameters().fig02().ok().map(|section| Section {
        across: ends(section.amplitude()),
        up: [section.frequency(); 2],
        label: "Fig. 2".to_owned(),
    });
    let magnified = study.panels().map(magnified);
    let figure = Figure07 {
        curves: &made.curves.frame,
        points: &made.points.frame,
        regions: &made.regions.frame,
        window: plane(study.parameters().fig07()?.window()),
        magnified: &magnified.unwrap_or_default(),
        sections: section.as_slice(),
    };
    let gaps = study.gaps()?.iter().map(ToString::to_string).collect();
    Ok(Made { gaps, ..Made::figure(draw_fig07(&figure, width)?, made.tables()) })
}

pub(super) fn fig08(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let (made, whole) = (study.fig08()?, study.fig07()?);
    let figure = Figure08 {
        curves: &made.curves.frame,
        points: &whole.points.frame,
        regions: &whole.regions.frame,
        coefficients: &made.coefficients.frame,
        panels: &magnified(study.panels()?),
    };
    let figure = draw_fig08(&figure, width)?;
    Ok(Made { notes: made.notes.clone(), ..Made::figure(figure, made.tables()) })
}

pub(super) fn fig09(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig09()?;
    let figure =
        Figure09 { curves: &made.curves.frame, points: &made.points.frame, surfaces: &made.surfaces.frame };
    Ok(Made::figure(draw_fig09(&figure, width)?, made.tables()))
}

pub(super) fn fig10(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig10()?;
    let figure = draw_fig10(&Figure10 { path: &made.path.frame }, width)?;
    Ok(Made::figure(figure, made.tables()))
}

/// The panels of Figure 8, numbered from 1.
fn magnified(windows: Vec<grazing_continuation::curve::Window>) -> Vec<Magnified> {
    let panels = windows.into_iter().zip(1..);
    panels
        .map(|(shown, panel)| Magnified { panel, window: Window { x: shown.primary, y: shown.secondary } })
        .collect()
}

/// The amplitudes across and the frequencies up.
fn plane(rectangle: Rectangle) -> Window {
    window(rectangle.amplitude(), rectangle.frequency())
}

fn window(across: Range, up: Range) -> Window {
    Window { x: ends(across), y: ends(up) }
}

fn ends(range: Range) -> [f64; 2] {
    [range.lower(), range.upper()]
}
