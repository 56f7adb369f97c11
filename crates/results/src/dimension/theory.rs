//! The dimensions of what theory and continuation give.

use grazing_continuation::curve::Window;
use grazing_continuation::fit::Measurement;
use grazing_theorems::hypothesis::{Hypothesis, ImposedCondition, Quantity};
use grazing_theorems::{GrazingPoint, ResonantPoint};

use super::{Dimension, Dimensioned};
use crate::dimensioned;

dimensioned! {
    Window, |own| {
        own.primary[0] => "{primary}",
        own.primary[1] => "{primary}",
        own.secondary[0] => "{secondary}",
        own.secondary[1] => "{secondary}",
    }

    GrazingPoint, |own| {
        own.map.a.m12 => "length",
        own.map.a.m21 => "1/length",
        own.map.b.x => "length/{primary}",
        own.map.b.y => "1/{primary}",
        own.forcing_frequency => "rad/time",
        own.gamma => "length/time^2",
        own.psi => "time/length",
    }

    Measurement, |own| {
        own.coefficient.value => "{primary}/{secondary}^2",
        own.coefficient.error => "{primary}/{secondary}^2",
        own.eta[0] => "{secondary}*time/length",
        own.eta[1] => "{secondary}*time^2/length^2",
        own.mu[0] => "{primary}*time^2/length^2",
        own.mu[1] => "{primary}*time^3/length^3",
        own.velocity => "length/time",
    }
}

/// All quantities computed by formulas have these units as well.
impl Dimensioned for ResonantPoint {
    fn each_number(&mut self, visit: &mut dyn FnMut(Dimension, &mut f64)) {
        self.grazing.each_number(visit);
        visit(Dimension::of("length"), &mut self.second_phase_derivative);
        // The derivative of a₁₂, which is a length, or of κ_p, which is a number.
        let derivative = if self.unfolding.loops == 1 { "length/{secondary}" } else { "1/{secondary}" };
        visit(Dimension::of(derivative), &mut self.unfolding.derivative);
    }
}

/// Whether the hypothesis holds is the same in all units.
impl Dimensioned for Hypothesis {
    fn each_number(&mut self, visit: &mut dyn FnMut(Dimension, &mut f64)) {
        let dimension = Dimension::of(match self.quantity {
            Quantity::ForcingFrequency => "rad/time",
            Quantity::Deceleration => "length/time^2",
            Quantity::OffDiagonal | Quantity::OffDiagonalTimesSquareRootFactor => "length",
            Quantity::OffDiagonalTimesTransversality => "length^2/{primary}",
            Quantity::Transversality | Quantity::TransversalityTimesDetuning => "length/{primary}",
            Quantity::OffDiagonalDerivative => "length/{secondary}",
            Quantity::DetuningDerivative => "1/{secondary}",
            Quantity::Loops
            | Quantity::Restitution
            | Quantity::Determinant
            | Quantity::Contraction
            | Quantity::StabilityMargin
            | Quantity::SquareRootFactor
            | Quantity::AdmissibilityMargin
            | Quantity::Detuning
            | Quantity::SaddleNodeStability
            | Quantity::PeriodDoublingStability => "1",
        });
        visit(dimension, &mut self.value);
        if let ImposedCondition::Zero { tolerance } = &mut self.condition {
            visit(dimension, tolerance);
        }
    }
}
