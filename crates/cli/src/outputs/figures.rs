//! From a study's frames to figures: one function a figure.

use grazing_continuation::curve;
use grazing_drawing::{
    Diagram, DrawingError, Figure02, Figure05, Magnifications, MagnifiedPanel, Plane, Section, SheetWidth,
    SpaceFigure, Window, draw_diagram, draw_fig01, draw_fig02, draw_fig03, draw_fig04, draw_fig05,
    draw_fig06, draw_fig09, draw_fig10, draw_magnifications,
};
use grazing_reproduction::{Coefficients, Scene, ShownPanel, Study, StudyError};
use grazing_results::Names;

use super::{Made, MadeResult};

pub(super) fn coefficients(study: &Study<'_>, _: SheetWidth) -> MadeResult {
    let made = study.coefficients()?;
    let notes = made.rows.iter().flat_map(Coefficients::doubts).collect();
    // A curve that is missing is none of the table's business.
    let gaps = study.gaps()?.into_iter().filter(|gap| matches!(gap, StudyError::Unlocated { .. }));
    let gaps = gaps.map(|gap| gap.to_string()).collect();
    Ok(Made { notes, gaps, ..Made::tables(made.tables(&Names::of_the_paper())) })
}

pub(super) fn fig01(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig01()?;
    Ok(Made::figure(draw_fig01(&space(&made), width)?, made.tables(&Names::of_the_paper())))
}

pub(super) fn fig02(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig02()?;
    let shown = study.parameters.fig02.get()?;
    let figure = Figure02 {
        branches: &made.branches,
        bifurcations: &made.bifurcations,
        attractor: &made.attractor,
        portraits: &made.portraits,
        window: Window { x: shown.amplitude, y: shown.x },
        magnification: Window { x: shown.magnified_amplitude, y: shown.magnified_x },
    };
    let figure = draw_fig02(&figure, width)?;
    Ok(Made { notes: made.notes.clone(), ..Made::figure(figure, made.tables(&Names::of_the_paper())) })
}

pub(super) fn fig03(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig03()?;
    Ok(Made::figure(draw_fig03(&space(&made), width)?, made.tables(&Names::of_the_paper())))
}

pub(super) fn fig04(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig04()?;
    Ok(Made::figure(draw_fig04(&made.curves, &made.points, width)?, made.tables(&Names::of_the_paper())))
}

pub(super) fn fig05(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig05()?;
    let shown = study.parameters.fig05.get()?;
    let figure = Figure05 {
        curves: &made.curves,
        points: &made.points,
        regions: &made.regions,
        window: Window { x: shown.mu, y: shown.eta },
    };
    Ok(Made::figure(draw_fig05(&figure, width)?, made.tables(&Names::of_the_paper())))
}

pub(super) fn fig06(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig06()?;
    Ok(Made::figure(draw_fig06(&made.parts, width)?, made.tables(&Names::of_the_paper())))
}

pub(super) fn fig07(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig07()?;
    // Where Figures 2 and 8 cannot be made, this one does not say where they lie.
    let section = study.parameters.fig02.get().ok().map(|section| Section {
        across: section.amplitude,
        up: [section.frequency; 2],
        label: "Fig. 2".to_owned(),
    });
    let diagram = Diagram {
        name: "fig07",
        title: "Two-parameter bifurcation diagram",
        description: "Forcing amplitude across, forcing frequency up. Grazing curve of the non-impacting solution; \
             saddle-node, period-doubling and grazing bifurcations of maximal periodic solutions; regions of stability \
             in grey.",
        plane: &Plane::of_the_paper(),
        tables: ["fig07_points", "fig07_curves"],
        curves: &made.curves,
        points: &made.points,
        regions: &made.regions,
        window: plane(&study.parameters.fig07.get()?.window),
        magnified: &panels(&study.panels().unwrap_or_default()),
        sections: section.as_slice(),
    };
    let gaps = study.gaps()?.iter().map(ToString::to_string).collect();
    Ok(Made { gaps, ..Made::figure(draw_diagram(&diagram, width)?, made.tables(&Names::of_the_paper())) })
}

pub(super) fn fig08(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let (made, whole) = (study.fig08()?, study.fig07()?);
    let magnifications = Magnifications {
        name: "fig08",
        title: "Magnifications about three resonant grazing bifurcations",
        description: "Forcing amplitude across, forcing frequency up. Dashed: the quadratic approximations to the \
             saddle-node and period-doubling curves.",
        plane: &Plane::of_the_paper(),
        table: "fig08_curves",
        curves: &made.curves,
        points: &whole.points,
        regions: &whole.regions,
        panels: &panels(&made.panels),
    };
    // As many panels as there can be stand on one sheet.
    let found = made.panels.len();
    let wanted = "one to three panels";
    let figure = draw_magnifications(&magnifications, width)?.pop().filter(|_| found <= 3);
    let figure = figure.ok_or(DrawingError::PanelCount { figure: "fig08", wanted, found })?;
    Ok(Made { notes: made.notes.clone(), ..Made::figure(figure, made.tables(&Names::of_the_paper())) })
}

pub(super) fn fig09(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig09()?;
    Ok(Made::figure(draw_fig09(&space(&made), width)?, made.tables(&Names::of_the_paper())))
}

pub(super) fn fig10(study: &Study<'_>, width: SheetWidth) -> MadeResult {
    let made = study.fig10()?;
    Ok(Made::figure(draw_fig10(&made.path, width)?, made.tables(&Names::of_the_paper())))
}

/// A scene in phase space.
fn space(scene: &Scene) -> SpaceFigure<'_> {
    SpaceFigure { curves: &scene.curves, points: &scene.points, surfaces: &scene.surfaces }
}

/// The panels of Figure 8, numbered from 1.
fn panels(shown: &[ShownPanel]) -> Vec<MagnifiedPanel> {
    let panel = |(panel, shown): (u32, &ShownPanel)| {
        let ShownPanel { loops, window, coefficients } = *shown;
        MagnifiedPanel { panel, window: plane(&window), loops, n: None, coefficients }
    };
    (1..).zip(shown).map(panel).collect()
}

/// Amplitudes across and frequencies up.
fn plane(window: &curve::Window) -> Window {
    Window { x: window.primary, y: window.secondary }
}
