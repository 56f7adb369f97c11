//! A suggestion of a better window for a diagram that fills little of its own.

use grazing_continuation::curve::Window;
use grazing_results::span;

use crate::Diagram;

/// A diagram that fills this fraction of a range or less is hard to read.
const LITTLE: f64 = 0.1;
/// Margin on either side, as a fraction of the filled part.
const MARGIN: f64 = 0.5;
/// A filled part smaller than this is a point or a straight line, which determines no width.
const NOTHING: f64 = 1e-6;

impl Diagram {
    /// A narrower window, if the results fill a tenth of a range or less: grazing curves,
    /// codimension-two points, and bifurcation curves between their landmarks. A curve that runs to
    /// the edge counts only up to its last turn: in every window, however wide, a few curves do so.
    pub fn suggested_window(&self) -> Option<Window> {
        if !self.unfinished.is_empty() {
            return None;
        }
        let window = self.scope.window;
        let narrower = |axis: usize, [low, high]: [f64; 2]| {
            let [from, to] = self.filled(axis)?;
            let share = to - from;
            let at = |share: f64| low + (high - low) * share.clamp(0.0, 1.0);
            (NOTHING..=LITTLE).contains(&share).then(|| [at(from - MARGIN * share), at(to + MARGIN * share)])
        };
        let [primary, secondary] = [narrower(0, window.primary), narrower(1, window.secondary)];
        (primary.is_some() || secondary.is_some()).then(|| Window {
            primary: primary.unwrap_or(window.primary),
            secondary: secondary.unwrap_or(window.secondary),
        })
    }

    /// The fractions of a range between which there are results.
    fn filled(&self, axis: usize) -> Option<[f64; 2]> {
        let share = |parameters: [f64; 2]| self.scope.window.shares(parameters)[axis];
        let grazing = self.grazing.iter().flat_map(|curve| curve.parameters()).map(share);
        let points = self.codimension_two.iter().map(|point| share(point.event.solution.parameters()));
        let curves = self.curves.iter().flat_map(|curve| {
            landmarks(&curve.curve.parameters().into_iter().map(share).collect::<Vec<_>>())
        });
        let inside = grazing.chain(points).chain(curves).filter(|share| (0.0..=1.0).contains(share));
        let [from, to] = span(inside);
        (from <= to).then_some([from, to])
    }
}

/// The values at which a curve turns, and those at its ends that lie inside.
fn landmarks(values: &[f64]) -> Vec<f64> {
    let turns = values.windows(3).filter(|three| (three[1] - three[0]) * (three[2] - three[1]) <= 0.0);
    let ends = [values.first(), values.last()].into_iter().flatten();
    // A curve that left the window ends at the edge or beyond.
    let inside = ends.filter(|value| (1e-9..=1.0 - 1e-9).contains(*value));
    turns.map(|three| three[1]).chain(inside.copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Scope;
    use crate::progress::Silent;

    fn suggested(primary: [f64; 2], secondary: [f64; 2]) -> Option<Window> {
        let window = Window { primary, secondary };
        let scope = Scope { window, loops: vec![1], start: None };
        let oscillator = crate::specimens::linear(0.02, [0.5, 0.8]);
        Diagram::compute(&oscillator, &scope, &Silent).expect("it grazes").suggested_window()
    }

    #[test]
    fn a_window_that_is_filled_is_left_alone() {
        assert_eq!(suggested([0.0, 1.2], [0.6, 1.1]), None);
    }

    #[test]
    fn a_window_that_is_much_too_wide_is_narrowed_to_what_is_in_it_and_then_left_alone() {
        let Window { primary, secondary } =
            suggested([0.0, 40.0], [0.6, 1.1]).expect("the diagram fills a twentieth");
        // The grazing curve goes from 0.04 to 0.64.
        assert!(primary[0] == 0.0 && (0.7..4.0).contains(&primary[1]), "{primary:?}");
        assert_eq!(secondary, [0.6, 1.1]);
        assert_eq!(suggested(primary, secondary), None);
        // At amplitudes up to one motion grazes below the frequency sqrt(2) only.
        let Window { primary, secondary } =
            suggested([0.0, 1.0], [0.6, 30.0]).expect("the diagram fills a fortieth");
        assert_eq!(primary, [0.0, 1.0]);
        assert!(secondary[0] == 0.6 && (1.4..4.0).contains(&secondary[1]), "{secondary:?}");
    }

    #[test]
    fn a_curve_that_leaves_the_window_counts_as_far_as_its_last_turn() {
        assert_eq!(landmarks(&[0.2, 0.3, 0.25, 0.5, 1.0]), [0.3, 0.25, 0.2]);
        assert_eq!(landmarks(&[0.2, 0.3, 0.5]), [0.2, 0.5]);
        assert!(landmarks(&[]).is_empty());
    }
}
