//! The two maps from each impact to a surface of comparison, and their consequences: the equations,
//! and the stability of their zeros.

use grazing_model::MapJet;
use nalgebra::{Matrix2, Matrix2x4, Vector2};
use smallvec::SmallVec;

use crate::newton::Linearisation;
use crate::solution::{Multipliers, StabilityFunctions};
use crate::tolerances::WITHOUT_LIMIT;
use crate::unknowns::{Square, Unknowns, unknown};

/// The two maps from an impact (y, z; μ, η): one to its own surface of comparison, the other to that
/// of the next impact.
#[derive(Clone, Copy, Debug)]
pub struct LoopPair {
    /// The map through recoil and loops: (x⁽ᵖ⁾, z⁽ᵖ⁾) = P_global^p ∘ P_virt ∘ R for VIVID.
    pub round_trip: MapJet,
    /// The map straight from the impact: (x̂, ẑ) = P_virt for VIVID.
    pub impact: MapJet,
}

impl LoopPair {
    /// The pair of two maps that lead to one surface if there is one impact.
    pub fn of<A, B, C, D>(round_trip: &MapJet<A, B>, impact: &MapJet<C, D>) -> Self {
        Self { round_trip: round_trip.plain(), impact: impact.plain() }
    }

    /// The difference V of the two maps and its derivatives in (y, z, μ, η), for one impact: its
    /// zeros are MPSs. Paper: eq:V.
    pub fn difference(&self) -> (Vector2<f64>, Matrix2x4<f64>) {
        (self.round_trip.value - self.impact.value, self.round_trip.jacobian - self.impact.jacobian)
    }
}

/// The maps of all impacts of a periodic solution, in the order of time. The solution is where the
/// map from each impact to the next surface agrees with the map straight from the next impact.
#[derive(Clone, Debug)]
pub struct Round(SmallVec<[LoopPair; 1]>);

/// Three numbers with which the multipliers λ satisfy D_L − λ T + λ² D_S = 0, or weights of them.
///
/// L are the derivatives of the maps to the next surface and S those of the maps straight from the
/// impact. T is the trace of the product of all L adj S, D_L the product of all det L, D_S that of
/// all det S. All stay smooth where an impact loses its velocity and S becomes singular.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Invariants {
    trace: f64,
    around: f64,
    straight: f64,
}

impl Invariants {
    fn characteristic(self, multiplier: f64) -> f64 {
        self.around - multiplier * self.trace + multiplier * multiplier * self.straight
    }

    /// Trace and determinant of the matrix with the multipliers.
    fn multipliers(self) -> Multipliers {
        Multipliers { trace: self.trace / self.straight, determinant: self.around / self.straight }
    }
}

impl From<LoopPair> for Round {
    fn from(pair: LoopPair) -> Self {
        Self(SmallVec::from_buf([pair]))
    }
}

impl FromIterator<LoopPair> for Round {
    fn from_iter<T: IntoIterator<Item = LoopPair>>(pairs: T) -> Self {
        Self(pairs.into_iter().collect())
    }
}

impl Round {
    /// The maps from the first impact.
    pub fn first(&self) -> &LoopPair {
        &self.0[0]
    }

    /// The index of the impact that follows one.
    fn next(&self, impact: usize) -> usize {
        (impact + 1) % self.0.len()
    }

    /// The differences of the maps, in the order of the impacts to which they lead: the second
    /// first, that of the first impact last. Their zeros are the periodic solutions.
    /// Paper: eq:V.
    pub fn differences(&self) -> impl Iterator<Item = Vector2<f64>> {
        (0..self.0.len()).map(|from| self.0[from].round_trip.value - self.0[self.next(from)].impact.value)
    }

    /// The length of all differences together.
    pub fn distance(&self) -> f64 {
        self.differences().map(|gap| gap.norm_squared()).sum::<f64>().sqrt()
    }

    /// The equations of the solution, with the last two rows left at zero.
    pub fn system(&self) -> Linearisation<Unknowns> {
        let size = 2 * self.0.len() + 2;
        let mut jacobian = Square::zeros(size);
        let mut residual = Unknowns::zeros(self.0.len());
        for (from, gap) in self.differences().enumerate() {
            let to = self.next(from);
            let columns = [from, to].map(unknown::of_impact);
            let maps = [&self.0[from].round_trip, &self.0[to].impact].map(|map| &map.jacobian);
            for component in 0..2 {
                let row = 2 * from + component;
                residual[row] = gap[component];
                for variable in 0..4 {
                    jacobian[[row, columns[0][variable]]] += maps[0][(component, variable)];
                }
                for variable in 0..4 {
                    jacobian[[row, columns[1][variable]]] -= maps[1][(component, variable)];
                }
            }
        }
        Linearisation { residual, jacobian }
    }

    /// Completes a direction: the impacts after the first move as the flights before them do.
    pub(crate) fn follow_on(&self, direction: &mut Unknowns) {
        for next in 1..self.0.len() {
            let along = |jet: &MapJet, impact: usize, variables: core::ops::Range<usize>| {
                let columns = unknown::of_impact(impact);
                let mut moved = Vector2::zeros();
                variables.for_each(|k| moved += jet.jacobian.column(k) * direction[columns[k]]);
                moved
            };
            let (round_trip, straight) = (&self.0[next - 1].round_trip, &self.0[next].impact);
            let gap = along(round_trip, next - 1, 0..4) - along(straight, next, 2..4);
            let own = straight.derivative().lu().solve(&gap).unwrap_or(Vector2::repeat(f64::NAN));
            (direction[unknown::velocity(next)], direction[unknown::phase(next)]) = (own[0], own[1]);
        }
    }

    /// The derivatives L and S of the maps from each impact.
    pub(crate) fn derivatives(&self) -> impl DoubleEndedIterator<Item = [Matrix2<f64>; 2]> + Clone {
        self.0.iter().map(|pair| [pair.round_trip.derivative(), pair.impact.derivative()])
    }

    /// The product of all L adj S, the first impact's last, and the invariants.
    fn invariants(&self) -> (Matrix2<f64>, Invariants) {
        let (mut product, mut around, mut straight) = (Matrix2::identity(), 1.0, 1.0);
        for [l, s] in self.derivatives() {
            product = l * adjugate(s) * product;
            (around, straight) = (around * l.determinant(), straight * s.determinant());
        }
        (product, Invariants { trace: product.trace(), around, straight })
    }

    /// The gradient of the sum of the invariants with these weights. The jets are of order 2.
    fn gradient(&self, weights: Invariants) -> Unknowns {
        let mut gradient = Unknowns::zeros(self.0.len());
        for (impact, [by_l, by_s]) in self.slopes(weights).into_iter().enumerate() {
            let LoopPair { round_trip, impact: straight } = &self.0[impact];
            for (variable, index) in unknown::of_impact(impact).into_iter().enumerate() {
                let along = |jet: &MapJet, by: &Matrix2<f64>| {
                    let [of_x, of_y] = &jet.hessians;
                    of_x[(0, variable)] * by[(0, 0)]
                        + of_x[(1, variable)] * by[(0, 1)]
                        + of_y[(0, variable)] * by[(1, 0)]
                        + of_y[(1, variable)] * by[(1, 1)]
                };
                gradient[index] += along(round_trip, &by_l) + along(straight, &by_s);
            }
        }
        gradient
    }

    /// The derivatives of the sum of the invariants with these weights in the entries of L and S.
    fn slopes(&self, weights: Invariants) -> SmallVec<[[Matrix2<f64>; 2]; 1]> {
        let count = self.0.len();
        let factors = self.derivatives().map(|[l, s]| l * adjugate(s));
        // The products of the factors of all impacts before one, and of all after it.
        let before = factors.clone().scan(Matrix2::identity(), |product, factor| {
            let before = *product;
            *product = factor * before;
            Some(before)
        });
        let mut after: SmallVec<[Matrix2<f64>; 1]> = factors
            .rev()
            .scan(Matrix2::identity(), |product, factor| {
                let after = *product;
                *product = after * factor;
                Some(after)
            })
            .collect();
        after.reverse();
        let others = |which: usize, except: usize| -> f64 {
            let dets = self.derivatives().map(|matrices| matrices[which].determinant());
            dets.enumerate().filter(|(index, _)| *index != except).map(|(_, det)| det).product()
        };
        self.derivatives()
            .zip(before.zip(after))
            .enumerate()
            .map(|(index, ([l, s], (before, after)))| {
                // The trace is that of L adj S · rest.
                let rest = if count == 1 { before } else { before * after };
                let by_l =
                    (adjugate(s) * rest) * weights.trace + adjugate(l) * (weights.around * others(0, index));
                // adj S is linear in S, and tr(M adj S) = tr(adj M S).
                let by_s =
                    adjugate(rest * l) * weights.trace + adjugate(s) * (weights.straight * others(1, index));
                [by_l.transpose(), by_s.transpose()]
            })
            .collect()
    }

    /// The function D_L − λ T + λ² D_S and its gradient in the unknowns; for one impact
    /// det(D round trip − λ D impact).
    ///
    /// Zero when λ is a stability multiplier: λ = 1 at a saddle-node, λ = −1 at a period-doubling
    /// bifurcation. In contrast to the multipliers it stays smooth through y = 0; up to a smooth
    /// factor it is y (1 − λT + D) for λ = ±1, the paper's y Ψ± (eq:Psi). The gradient needs jets
    /// of order 2.
    pub fn characteristic(&self, multiplier: f64) -> (f64, Unknowns) {
        let value = self.invariants().1.characteristic(multiplier);
        let weights = Invariants { trace: -multiplier, around: 1.0, straight: multiplier * multiplier };
        (value, self.gradient(weights))
    }

    /// The difference D_L − d D_S and its gradient in the unknowns.
    ///
    /// Zero when the product of the multipliers is d; smooth through y = 0, as
    /// [`characteristic`](Self::characteristic) is, and of the same order there.
    pub fn product_less(&self, product: f64) -> (f64, Unknowns) {
        let (_, Invariants { around, straight, .. }) = self.invariants();
        let weights = Invariants { trace: 0.0, around: 1.0, straight: -product };
        (around - product * straight, self.gradient(weights))
    }

    /// The unit vector at the first impact that the round trip stretches by a multiplier.
    pub fn direction(&self, multiplier: f64) -> Option<Vector2<f64>> {
        let LoopPair { round_trip, impact } = self.first();
        if self.0.len() == 1 {
            return kernel(round_trip.derivative() - impact.derivative() * multiplier);
        }
        let (product, Invariants { straight, .. }) = self.invariants();
        // Seen from the plane of the first impact.
        let there = kernel(product - Matrix2::identity() * (multiplier * straight))?;
        (adjugate(impact.derivative()) * there).try_normalize(0.0)
    }

    /// The stability that follows from the maps.
    pub(crate) fn stability(&self) -> StabilityFunctions {
        let (product, invariants) = self.invariants();
        let [saddle_node, period_doubling] =
            [1.0, -1.0].map(|multiplier| invariants.characteristic(multiplier));
        let torus = invariants.around - invariants.straight;
        let (multipliers, violence) = (invariants.multipliers(), product.norm());
        StabilityFunctions { multipliers, saddle_node, period_doubling, pitchfork: None, torus, violence }
    }

    /// Trace and determinant of U = D(P_global^p ∘ P_disc). Paper: eq:U, eq:TD.
    pub fn multipliers(&self) -> Multipliers {
        self.invariants().1.multipliers()
    }

    /// Limits of trace and determinant at a point at which an impact has no velocity, approached along a
    /// curve with the given tangent.
    ///
    /// Numerators and denominator vanish together at a resonance; the limits are the ratios of
    /// their derivatives along the curve. Elsewhere the trace is infinite. Jets of order 2.
    pub fn limiting_multipliers(&self, tangent: &Unknowns) -> Multipliers {
        let none = Invariants { trace: 0.0, around: 0.0, straight: 0.0 };
        let weights = [
            Invariants { trace: 1.0, ..none },
            Invariants { around: 1.0, ..none },
            Invariants { straight: 1.0, ..none },
        ];
        let slopes = weights.map(|weights| self.gradient(weights));
        let [mut trace, around, straight] = slopes.each_ref().map(|slope| slope.dot(tangent));
        let here = self.invariants().1.trace;
        if here.abs() > WITHOUT_LIMIT * (slopes[0].norm() + slopes[2].norm()) {
            trace = f64::INFINITY.copysign(here);
        }
        Invariants { trace, around, straight }.multipliers()
    }
}

fn adjugate(m: Matrix2<f64>) -> Matrix2<f64> {
    Matrix2::new(m[(1, 1)], -m[(0, 1)], -m[(1, 0)], m[(0, 0)])
}

/// The unit vector that a singular matrix maps to zero.
fn kernel(matrix: Matrix2<f64>) -> Option<Vector2<f64>> {
    let across = [matrix.row(0), matrix.row(1)].map(|row| Vector2::new(-row[1], row[0]));
    let longest = across.into_iter().max_by(|a, b| a.norm().total_cmp(&b.norm()))?;
    longest.try_normalize(0.0)
}
