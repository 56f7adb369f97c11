//! The contents of the page, as rows from which `unfold` draws its figures.

use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::smooth::Stop;
use grazing_results::branches::OneParameter;
use grazing_results::measured::Comparison;
use grazing_results::place::AtPlace;
use grazing_results::plane::{PlaneDiagram, StraightenedCurves};
use grazing_results::{Dimensioned, Names};
use grazing_unfold::described::{AtWall, Prepared};
use grazing_unfold::place::at_place;
use grazing_unfold::plane;
use grazing_unfold::progress::Progress;
use grazing_unfold::resonances::FoundResonance;
use grazing_unfold::sequences::of_diagram;
use grazing_unfold::unfolded::straightened_at;
use grazing_unfold::{Diagram, UnfoldError};
use serde::Deserialize;

use crate::answer::Problem;
use crate::cut::CutLine;
use crate::diagram::{problem, whole};
use crate::measured::Measured;
use crate::model::{Model, View};
use crate::place;

/// A figure of an oscillator, with names.
pub struct Seen {
    /// The name of the oscillator.
    pub name: String,
    /// The names of its parameters.
    pub names: Names,
    /// The figure.
    pub figure: Figure,
}

/// A figure that can be requested.
pub enum Figure {
    /// The diagram of the view, without frames of magnifications and lines of other diagrams, and
    /// with the comparison with measurements.
    Plane(PlaneDiagram, Option<Comparison>),
    /// The curves that leave a resonance in straightened coordinates.
    Straightened(StraightenedCurves),
    /// Motion along a line of the plane.
    OneParameter(OneParameter),
    /// Motion at a place.
    Place(AtPlace),
}

/// The request for an export.
#[derive(Deserialize)]
pub(crate) struct ExportRequest {
    model: Model,
    view: View,
    pub(crate) what: String,
    #[serde(default)]
    pub(crate) columns: String,
    #[serde(default)]
    of: Wanted,
    measured: Option<Measured>,
}

/// The figure that is requested.
#[derive(Default, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Wanted {
    /// The diagram.
    #[default]
    Plane,
    /// The curves in straightened coordinates about the resonance that is nearest to this place.
    Straightened([f64; 2]),
    /// A one-parameter diagram along a line.
    Cut(CutLine),
    /// Motion at a place.
    Place([f64; 2]),
}

impl Seen {
    pub(crate) fn compute(request: &ExportRequest, stop: &Stop) -> Result<Self, Problem> {
        let ExportRequest { model, view, of, measured, .. } = request;
        Self::found(model, Some(view), of, measured.as_ref(), stop, stop)
    }

    /// The figure of an oscillator in a view, or in the ranges of its file.
    ///
    /// # Errors
    /// The reason why there is nothing to show.
    pub fn of(
        model: &Model,
        view: Option<&View>,
        wanted: &Wanted,
        progress: &dyn Progress,
        stop: &Stop,
    ) -> Result<Self, String> {
        let found = Self::found(model, view, wanted, None, progress, stop);
        found.map_err(|problem| problem.message)
    }

    fn found(
        model: &Model,
        view: Option<&View>,
        wanted: &Wanted,
        measured: Option<&Measured>,
        progress: &dyn Progress,
        stop: &Stop,
    ) -> Result<Self, Problem> {
        let (description, _) = model.viewed(view, stop)?;
        let name = description.name().to_owned();
        let of = model.prepare(&description, stop)?;
        let names = of.axes.names.clone();
        let figure = match wanted {
            Wanted::Plane => {
                let axes = of.axes.clone();
                let seen = whole(&of, progress)?;
                let compared =
                    measured.map(|rig| rig.beside(model, (&axes, &seen), progress, stop)).transpose()?;
                let compared = compared.map(|(compared, _)| compared);
                let several = of_diagram(&seen[0], description.generations(), progress);
                let mut all = plane::rows(&seen[0], seen.get(1));
                all.several = several.rows(seen[0].wall).regions;
                all.at_both_walls = several.at_both_walls();
                all = all.with_dimensions(&axes.units);
                all.measured = compared.iter().flat_map(|compared| compared.points.clone()).collect();
                Figure::Plane(all, compared)
            }
            Wanted::Cut(line) => Figure::OneParameter(line.diagram(model, progress, stop)?),
            Wanted::Place(at) => {
                place::check(&of, *at)?;
                let found = at_place(&of.oscillator, &of.scope, &of.axes.units, (1, *at), progress);
                let from_the_wall = !model.description(None, stop)?.wall().is_usual();
                Figure::Place(AtPlace { from_the_wall, ..found.ok_or_else(Problem::ended)? })
            }
            Wanted::Straightened(at) => {
                // Curves are followed as far as they reach in the file's ranges, not only in the view.
                let whole = model.prepared(None, stop)?;
                let inside = whole.scope.window.contains(whole.without_dimensions(*at));
                Figure::Straightened(straightened(if inside { whole } else { of }, *at, progress)?)
            }
        };
        if stop.is_asked() { Err(Problem::ended()) } else { Ok(Self { name, names, figure }) }
    }
}

fn straightened(of: Prepared, at: [f64; 2], progress: &dyn Progress) -> Result<StraightenedCurves, Problem> {
    let place = of.without_dimensions(at);
    let followed = |view: AtWall| {
        let located = view.located(progress)?;
        let followed = located.follow(progress, &|_, _| ());
        Ok(located.with_curves(followed))
    };
    let seen = of.from_each_wall().map(followed).collect::<Result<Vec<Diagram>, UnfoldError>>();
    let seen = seen.map_err(|error| problem(&of.axes, error))?;
    let window = of.scope.window;
    let far = |(_, (_, point)): &(&Diagram, (&FoundResonance, &ResonantGrazingPoint))| {
        let [_, _, primary, secondary] = point.unknowns().into();
        let [from, to] = [place, [primary, secondary]].map(|place| window.shares(place));
        (to[0] - from[0]).abs() + (to[1] - from[1]).abs()
    };
    let all = seen.iter().flat_map(|diagram| diagram.unfolding().map(move |one| (diagram, one)));
    let nearest = all.min_by(|a, b| far(a).total_cmp(&far(b)));
    let (diagram, nearest) =
        nearest.ok_or_else(|| Problem::wrong("the ranges contain no resonance at which a theorem holds"))?;
    Ok(straightened_at(&of.axes, diagram, nearest))
}
