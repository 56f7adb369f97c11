//! The evidence by which the faces between curves are judged.

use grazing_continuation::locate::{Condition, locate_within};
use grazing_continuation::mps::unknown;
use grazing_model::smooth::Purpose;

use super::Survey;
use super::explain::is_wide;
use crate::curves::DiagramCurve;
use crate::faces::Point;
use crate::parallel;
use crate::region::Doubt;
use crate::segments::{broken_at, segments};
use crate::slice_stability::SliceStability;
use crate::slices::{CARRIED_OFF, Slice};
use crate::tolerances::CLEAR;

/// Displacements in impact velocity, or in position at phase zero, at which good solutions beside a
/// curve are looked for: from close to the curve to where they may belong to another face.
const ASIDE: [f64; 6] = [1e-3, 3e-3, 1e-2, 3e-2, -1e-3, -1e-2];
impl Survey<'_> {
    /// Places beside the middles of curves at which a solution is stable and admissible: each curve
    /// gives information about one of its sides.
    pub(crate) fn witnesses(&self) -> Vec<Point> {
        let equations = &self.net.equations;
        let window = self.scope.window;
        let beside = |curve: &DiagramCurve| {
            let points = &curve.curve.points;
            let middle = &points[points.len() / 2];
            let from = middle.solution.unknowns.clone();
            ASIDE.iter().find_map(|by| {
                let mut near = from.clone();
                near[unknown::VELOCITY] += by;
                let held = Condition::ImpactVelocity(near[unknown::VELOCITY]);
                let conditions = [Condition::Secondary(from[unknown::SECONDARY]), held];
                let found =
                    locate_within(CARRIED_OFF, equations, conditions, near, &mut middle.times.clone());
                let solution = equations.solution(&found.ok()?);
                let [place, curve] = [&solution, &middle.solution].map(|it| window.shares(it.parameters()));
                let apart = (place[0] - curve[0]).abs() > CLEAR;
                (apart && solution.attracts() && window.contains(solution.parameters()))
                    .then(|| solution.parameters())
            })
        };
        let found = parallel::map(&self.net.curves, |curve| Purpose::Witnesses.during(|| beside(curve)));
        found.into_iter().flatten().collect()
    }

    /// What all slices show.
    pub(crate) fn stabilities(&self) -> Vec<SliceStability> {
        let stability = |slice: &Slice| {
            let mut stability = SliceStability::of(slice);
            for branch in &slice.branches {
                let (segments, borders) = segments(&self.net.equations, branch);
                for segment in segments.iter().filter(|segment| segment.good) {
                    stability.see(segment.primary);
                }
                let unnamed = borders.iter().filter(|border| border.event.is_none());
                for border in unnamed.filter(|border| is_wide(border, self.scope.window)) {
                    stability.doubt(border.primary, Doubt::UnnamedChange);
                }
                for (primary, reason) in broken_at(branch) {
                    stability.doubt(primary, Doubt::Broken(reason));
                }
            }
            stability
        };
        self.slices.iter().map(stability).collect()
    }
}
