//! Figure 7 (fig:G): the two-parameter bifurcation diagram.

use grazing_model::LinearOscillator;
use grazing_results::Table;
use grazing_results::plane::{CurvePoint, RegionVertex, SpecialPoint};
use grazing_unfold::Diagram;

use crate::plane::{self, Axes};

/// What Figure 7 shows.
#[derive(Clone, Debug)]
pub struct Figure7 {
    /// The grazing curve of the non-impacting solution and the bifurcation curves of MPSs.
    pub curves: Vec<CurvePoint>,
    /// Resonances and other codimension-two points.
    pub points: Vec<SpecialPoint>,
    /// Polygons of stability.
    pub regions: Vec<RegionVertex>,
}

impl Figure7 {
    /// All tables.
    pub fn tables(&self) -> Vec<Table> {
        let names = &Axes::of_the_paper().names;
        vec![
            Table::new("fig07_curves", names, &self.curves),
            Table::new("fig07_points", names, &self.points),
            Table::new("fig07_regions", names, &self.regions),
        ]
    }

    pub(crate) fn of(diagram: &Diagram<LinearOscillator>) -> Self {
        let axes = Axes::of_the_paper();
        Self {
            curves: plane::curves(&axes, diagram),
            points: plane::points(&axes, diagram),
            regions: plane::regions(&axes, &diagram.regions),
        }
    }
}
