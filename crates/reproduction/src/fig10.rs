//! Figure 10 (fig:I): the path of the proof of Theorem 2.3, Step 3.

use grazing_results::sketches::{Figure10, Visit};
use grazing_theorems::auxiliary::lucas_sequence;
use nalgebra::Vector2;

use crate::{Study, StudyError};

impl Study {
    /// Figure 10: the vertices as iterates of (0, −b₁ₚ / (a₁₂ β)) under the affine map Q(u, w) = A
    /// (u, w) + (S_p / β) b.
    ///
    /// Paper: eq:affineMap and the line after eq:affineMapj. The scaling S_p / β of eq:ujwj makes
    /// u⁽ʲ⁾ free of μ.
    pub fn fig10(&self) -> Result<Figure10, StudyError> {
        let (shown, oscillator) = (self.parameters.fig10.get()?, self.parameters.oscillator.get()?);
        let map = oscillator.grazing(shown.frequency)?.linearised_map();
        let (p, beta) = (shown.loops, map.transversality());
        let drift = map.b * (lucas_sequence(p, map.trace(), map.determinant()) / beta);
        let mut vertex = Vector2::new(0.0, -map.iterate(p).b.x / (map.a.m12 * beta));
        let mut path = Vec::new();
        for visit in 0..=p {
            path.push(Visit { visit, u: vertex.x, w: vertex.y });
            vertex = map.a * vertex + drift;
        }
        Ok(Figure10 { path })
    }
}
