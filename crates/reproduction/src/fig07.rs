//! Figure 7 (fig:G): the two-parameter bifurcation diagram.

use grazing_model::LinearOscillator;
use grazing_unfold::Diagram;

use crate::StudyError;
use crate::plane::{self, Axes};
use crate::table::Table;

/// The frames of Figure 7.
#[derive(Clone, Debug)]
pub struct Figure7 {
    /// `fig07_curves`: the grazing curve of the non-impacting solution and the bifurcation curves of MPSs.
    pub curves: Table,
    /// `fig07_points`: resonances and other codimension-two points.
    pub points: Table,
    /// `fig07_regions`: polygons of stability.
    pub regions: Table,
}

impl Figure7 {
    /// All tables.
    pub fn tables(&self) -> Vec<Table> {
        vec![self.curves.clone(), self.points.clone(), self.regions.clone()]
    }

    pub(crate) fn of(diagram: &Diagram<LinearOscillator>) -> Result<Self, StudyError> {
        let axes = Axes::of_the_paper();
        Ok(Self {
            curves: plane::curves("fig07_curves", &axes, diagram)?,
            points: plane::points("fig07_points", &axes, diagram)?,
            regions: plane::regions("fig07_regions", &axes, &diagram.regions)?,
        })
    }
}
