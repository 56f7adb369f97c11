//! Figure 7 (fig:G): the two-parameter bifurcation diagram.

use grazing_results::brief;
use grazing_results::plane::Figure7;
use grazing_unfold::regions::{Region, RegionKind};

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
            notes: undecided(&diagram.regions),
        })
    }
}

/// Where it is not decided whether solutions are stable, with the reason: one sentence for the regions of one p.
fn undecided(regions: &[Region]) -> Vec<String> {
    let doubts = regions.iter().filter_map(|region| match &region.kind {
        RegionKind::Undecided(doubt) => Some((region, doubt)),
        _ => None,
    });
    let doubts: Vec<_> = doubts.collect();
    let told = doubts.chunk_by(|(a, _), (b, _)| a.loops == b.loops).map(|alike| {
        let (first, doubt) = alike[0];
        let [from, to] = first.extent().map(|[amplitude, frequency]| {
            format!("amplitude {}, frequency {}", brief(amplitude, 6), brief(frequency, 6))
        });
        let more = match alike.len() - 1 {
            0 => String::new(),
            more => format!("; and in {more} more places, see fig07_regions.csv"),
        };
        format!("p = {} is undecided, and hatched, from {from} to {to}: {doubt}{more}", first.loops)
    });
    told.collect()
}
