//! Figure 7 (fig:G): the two-parameter bifurcation diagram.

use grazing_results::plane::{CurvePoint, RegionVertex, SpecialPoint};
use grazing_results::tables;

use crate::plane::{self, Axes};
use crate::{Study, StudyError};

tables! {
    /// What Figure 7 shows.
    Figure7 {
        /// The grazing curve of the non-impacting solution and the bifurcation curves of MPSs.
        curves: CurvePoint = "fig07_curves", "a point of a curve of the diagram",
        /// Resonances and other codimension-two points.
        points: SpecialPoint = "fig07_points", "a resonance at which a theorem holds, or another codimension-two point",
        /// Polygons of stability.
        regions: RegionVertex = "fig07_regions", "a vertex of a region of stability",
    }
}

impl Study<'_> {
    /// Figure 7.
    ///
    /// # Errors
    /// There is no grazing in the window.
    pub fn fig07(&self) -> Result<Figure7, StudyError> {
        let (axes, diagram) = (Axes::of_the_paper(), self.diagram()?);
        Ok(Figure7 {
            curves: plane::curves(&axes, diagram),
            points: plane::points(&axes, diagram),
            regions: plane::regions(&axes, &diagram.regions),
        })
    }
}
