//! What is seen, as rows from which `unfold` draws its figures.

use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::smooth::Stop;
use grazing_reproduction::place::at_place;
use grazing_reproduction::plane;
use grazing_reproduction::unfolded::straightened_at;
use grazing_results::Names;
use grazing_results::branches::OneParameter;
use grazing_results::measured::Comparison;
use grazing_results::place::AtPlace;
use grazing_results::plane::{PlaneDiagram, StraightenedCurves};
use grazing_unfold::Diagram;
use grazing_unfold::resonances::Resonance;
use serde::Deserialize;

use crate::answer::Problem;
use crate::cut::CutLine;
use crate::diagram::located;
use crate::measured::Measured;
use crate::model::{Model, Prepared, View};
use crate::place;

/// What is seen of an oscillator.
pub struct Seen {
    /// What the oscillator is called.
    pub name: String,
    /// The names of its parameters.
    pub names: Names,
    /// The figure.
    pub figure: Figure,
}

/// A figure that is asked for.
pub enum Figure {
    /// The diagram of the view, without frames of magnifications and lines of other diagrams, and what a
    /// rig did beside it.
    Plane(PlaneDiagram, Option<Comparison>),
    /// The curves that leave a resonance in straightened coordinates.
    Straightened(StraightenedCurves),
    /// What happens along a line of the plane.
    OneParameter(OneParameter),
    /// What there is at a place.
    Place(AtPlace),
}

/// What is to be exported.
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

/// Which figure is asked for.
#[derive(Default, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Wanted {
    #[default]
    Plane,
    /// About the resonance that is nearest to this place.
    Straightened([f64; 2]),
    Cut(CutLine),
    Place([f64; 2]),
}

impl Seen {
    pub(crate) fn compute(request: &ExportRequest, stop: &Stop) -> Result<Self, Problem> {
        let ExportRequest { model, view, of: wanted, measured, .. } = request;
        let name = model.description(Some(view), stop)?.name().to_owned();
        let of = model.prepared(Some(view), stop)?;
        let names = of.axes.names.clone();
        let figure = match wanted {
            Wanted::Plane => {
                let (axes, diagram) = (of.axes.clone(), diagram(of, stop)?);
                let compared =
                    measured.as_ref().map(|rig| rig.beside(model, &axes, &diagram, stop)).transpose()?;
                let compared = compared.map(|(compared, _)| compared);
                let mut rows = plane::plane_diagram(&axes, &diagram, Vec::new(), Vec::new());
                rows.measured = compared.iter().flat_map(|compared| compared.points.clone()).collect();
                Figure::Plane(rows, compared)
            }
            Wanted::Cut(line) => Figure::OneParameter(line.diagram(model, stop)?),
            Wanted::Place(at) => {
                place::check(&of, *at)?;
                let found = at_place(&of.oscillator, &of.scope.loops, &of.axes.units, (1, *at), stop);
                let from_the_wall = !model.description(None, stop)?.wall().is_usual();
                Figure::Place(AtPlace { from_the_wall, ..found.ok_or_else(Problem::ended)? })
            }
            Wanted::Straightened(at) => {
                // Curves are followed as far as they reach in the file's ranges, not only in the view.
                let whole = model.prepared(None, stop)?;
                let inside = whole.scope.window.contains(whole.without_dimensions(*at));
                Figure::Straightened(straightened(if inside { whole } else { of }, *at, stop)?)
            }
        };
        if stop.is_asked() { Err(Problem::ended()) } else { Ok(Self { name, names, figure }) }
    }
}

fn diagram(of: Prepared, stop: &Stop) -> Result<Diagram, Problem> {
    let Prepared { oscillator, scope, asked, axes } = of;
    let located = located(&oscillator, &scope, &axes, stop)?.asking_for(asked);
    let followed = located.follow(stop, &|_, _| ());
    Ok(located.with(followed, stop))
}

fn straightened(of: Prepared, at: [f64; 2], stop: &Stop) -> Result<StraightenedCurves, Problem> {
    let place = of.without_dimensions(at);
    let Prepared { oscillator, scope, axes, .. } = of;
    let located = located(&oscillator, &scope, &axes, stop)?;
    let followed = located.follow(stop, &|_, _| ());
    let diagram = located.with_curves(followed);
    let far = |(_, point): &(&Resonance, &ResonantGrazingPoint)| {
        let [_, _, primary, secondary] = point.unknowns().into();
        let [from, to] = [place, [primary, secondary]].map(|place| diagram.scope.window.shares(place));
        (to[0] - from[0]).abs() + (to[1] - from[1]).abs()
    };
    let nearest = diagram.unfolding().min_by(|a, b| far(a).total_cmp(&far(b)));
    let nearest = nearest.ok_or_else(|| Problem::wrong("there is no resonance at which a theorem holds"))?;
    Ok(straightened_at(&axes, &diagram, nearest))
}
