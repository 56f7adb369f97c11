//! Figure 7 (fig:G): the two-parameter bifurcation diagram.

use grazing_results::plane::Figure7;

use crate::plane::{self, Axes};
use crate::{Study, StudyError};

impl Study<'_> {
    /// Figure 7.
    ///
    /// # Errors
    /// There is no grazing in the window.
    pub fn fig07(&self) -> Result<Figure7, StudyError> {
        let (axes, diagram) = (Axes::of_the_paper(), self.diagram()?);
        let fig02 = self.parameters.fig02.get().ok();
        Ok(Figure7 {
            curves: plane::curves(&axes, diagram),
            points: plane::points(&axes, diagram),
            regions: plane::regions(&axes, &diagram.regions),
            frame: diagram.scope.window.into(),
            section: fig02.map(|fig02| (fig02.amplitude, fig02.frequency)),
            magnified: self.panels().unwrap_or_default(),
            gaps: self.unlocated()?.into_iter().chain(self.not_followed()?).collect(),
        })
    }
}
