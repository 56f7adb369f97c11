//! The coefficients at the resonances of Figure 7, and the computed values of the numbers that the paper
//! prints.

use std::collections::BTreeMap;

use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_results::plane::{MagnifiedPanel, StraightenedCurves};
use grazing_unfold::resonances::FoundResonance;
use grazing_unfold::straightened::{self, straighten};
use grazing_unfold::verdict;
use rayon::prelude::*;

use crate::coefficients::{CoefficientTable, ComparedCoefficients, closed_form_coefficients};
use crate::figures::fig02;
use crate::{Study, StudyError};

impl Study {
    /// The coefficients at all resonances of Figure 7.
    ///
    /// # Errors
    /// There is no grazing in the window.
    pub fn coefficients(&self) -> Result<&CoefficientTable, StudyError> {
        let compute = || {
            let theory = self.parameters.oscillator()?;
            let resonances: Vec<_> = self.diagram()?.unfolding().collect();
            let rows = resonances.into_par_iter().map(|(found, located)| {
                let closed_form = theory.resonance(found.loops, found.n)?;
                Ok(ComparedCoefficients {
                    loops: closed_form.loops(),
                    n: closed_form.index(),
                    frequency: closed_form.forcing_frequency(),
                    amplitude: closed_form.grazing().amplitude(),
                    stability: closed_form.stability_coefficients(),
                    closed_form: closed_form_coefficients(&closed_form),
                    measured: verdict::coefficients(located),
                })
            });
            Ok(CoefficientTable { rows: rows.collect::<Result<_, StudyError>>()? })
        };
        self.coefficients.get_or_init(compute).as_ref().map_err(Clone::clone)
    }

    /// The curves that leave all resonances of Figure 7, in straightened coordinates, with the limits by
    /// closed form.
    ///
    /// # Errors
    /// There is no grazing in the window.
    pub fn straightened(&self) -> Result<StraightenedCurves, StudyError> {
        let (theory, diagram) = (self.parameters.oscillator()?, self.diagram()?);
        let etas = straightened::etas(diagram.scope.window.secondary);
        let resonances: Vec<_> = diagram.unfolding().collect();
        let curves = |&(found, point): &(&FoundResonance, &ResonantGrazingPoint)| {
            let coefficients = closed_form_coefficients(&theory.resonance(found.loops, found.n)?);
            Ok((coefficients, straighten(diagram, (found, point), &verdict::near(point), &etas)))
        };
        let all: Vec<_> = resonances.par_iter().map(curves).collect::<Result<_, StudyError>>()?;
        let panels = (1..).zip(resonances.iter().zip(&all)).map(|(panel, ((found, _), (known, curves)))| {
            let (frame, loops, n) = (diagram.scope.window.into(), found.loops, Some(found.n));
            let coefficients = *known;
            (MagnifiedPanel { panel, frame, loops, wall: 0, n, coefficients }, curves.as_slice())
        });
        Ok(straightened::panels(panels))
    }

    /// The computed values of the numbers that the paper prints, under the names of
    /// `expected/published.toml`.
    ///
    /// # Errors
    /// There is no grazing in the window of Figure 7.
    pub fn published_values(&self) -> Result<BTreeMap<String, f64>, StudyError> {
        let theory = self.parameters.oscillator()?;
        let frequency = fig02::frequency(&self.parameters)?;
        let grazing = theory.grazing(frequency)?;
        let mut values = BTreeMap::from([
            ("zeta".to_owned(), theory.damping_ratio()),
            ("epsilon".to_owned(), theory.coefficient_of_restitution()),
            ("fig02_frequency".to_owned(), frequency),
            ("fig02_amplitude_graz".to_owned(), grazing.amplitude()),
            ("fig02_tau".to_owned(), grazing.trace()),
            ("fig02_delta".to_owned(), grazing.determinant()),
        ]);
        for c in &self.coefficients()?.rows {
            let name = |quantity: &str| format!("{quantity}_p{}_n{}", c.loops, c.n);
            values.insert(name("omega"), c.frequency);
            values.insert(name("c_sn"), c.closed_form.saddle_node);
            values.insert(name("c_pd"), c.closed_form.period_doubling);
        }
        Ok(values)
    }
}
