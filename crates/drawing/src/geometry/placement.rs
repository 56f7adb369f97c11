//! Positions of labels: chosen greedily in a fixed order, each label at the first best position of a
//! fixed list.

use std::f64::consts::FRAC_1_SQRT_2;

use crate::geometry::sheet::{Bounds, Spot, along, cross, distance, inside, thinned};

/// The objects on a panel that labels must avoid.
pub struct Placer {
    panel: Bounds,
    blocked: Vec<Bounds>,
    segments: Vec<(Spot, Spot)>,
    /// Segments of curves that never have labels of their own.
    nameless: Vec<(Spot, Spot)>,
    dust: Vec<Spot>,
    /// The leaders of the labels placed so far.
    leaders: Vec<(Spot, Spot)>,
    /// The labels placed so far: their texts and boxes.
    placed: Vec<(String, Bounds)>,
}

/// A label that is to be placed: its text, and the size of its box in points.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WantedLabel<'a> {
    pub(crate) text: &'a str,
    pub(crate) width: f64,
    pub(crate) height: f64,
    /// The greatest distance from its spot, in points.
    pub(crate) farthest: f64,
    /// Whether it may cover lines and markers.
    pub(crate) covers: bool,
}

/// Distances of a label from its spot that are tried, in points; from [`LED`] on with a leader.
const GAPS: [f64; 9] = [0.0, 2.0, LED, 9.0, 14.0, 20.0, 28.0, 38.0, 50.0];
const LED: f64 = 5.0;
/// The length below which a leader would look like a stray stroke, in points.
const SHORTEST: f64 = 3.0;
/// The least distance between two labels of the same text, in points, so that each is seen to belong to
/// something of its own.
const TWINS: f64 = 10.0;
/// The points of distance that a label may be farther away so that its leader crosses one curve less, so
/// that it lies over one piece of a line less, and so that it covers a square point of a cloud less (visual
/// choices).
const CROSSING: f64 = 15.0;
const OVER_LINE: f64 = 45.0;
const COVERING: f64 = 2.0;

/// The position of a label.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LabelPlace {
    pub(crate) bounds: Bounds,
    /// A line towards the labelled object if that is far away.
    pub(crate) leader: Option<(Spot, Spot)>,
}

impl Placer {
    pub(crate) fn new(panel: Bounds) -> Self {
        let (blocked, segments, nameless, dust) = Default::default();
        let (leaders, placed) = Default::default();
        Placer { panel, blocked, segments, nameless, dust, leaders, placed }
    }

    /// Makes labels avoid a box.
    pub fn block(&mut self, bounds: Bounds) {
        self.blocked.push(bounds);
    }

    /// Makes labels avoid a curve.
    pub fn keep_off(&mut self, curve: &[Spot]) {
        self.segments.extend(thinned(curve).windows(2).map(|pair| (pair[0], pair[1])));
    }

    /// Makes labels avoid a curve to which no nearby label could be attributed by mistake.
    pub fn keep_off_nameless(&mut self, curve: &[Spot]) {
        self.nameless.extend(thinned(curve).windows(2).map(|pair| (pair[0], pair[1])));
    }

    /// Makes labels avoid a cloud of points where there is room elsewhere.
    pub fn avoid(&mut self, spots: impl Iterator<Item = Spot>) {
        let mut cells: Vec<(i64, i64)> = spots.map(|(x, y)| (x.floor() as i64, y.floor() as i64)).collect();
        cells.sort_unstable();
        cells.dedup();
        self.dust.extend(cells.into_iter().map(|(x, y)| (x as f64 + 0.5, y as f64 + 0.5)));
    }

    /// The area of a cloud, in square points, that a box covers.
    fn dusty(&self, bounds: &Bounds) -> usize {
        let covers =
            |&&(x, y): &&Spot| bounds.left <= x && x <= bounds.right && bounds.top <= y && y <= bounds.bottom;
        self.dust.iter().filter(covers).count()
    }

    /// The box of a label at a centre if the label may be there: inside the panel, off everything, and not
    /// beside another one of the same text.
    fn free(&self, centre: Spot, label: WantedLabel<'_>) -> Option<Bounds> {
        let bounds = Bounds::about(centre, label.width, label.height);
        let around = bounds.grown(TWINS);
        let meets = |(a, b): &(Spot, Spot)| bounds.meets(*a, *b);
        let is_free = self.panel.holds(&bounds)
            && !self.taken(label.covers).any(|other| other.overlaps(&bounds))
            && !self.placed.iter().any(|(text, twin)| text == label.text && twin.overlaps(&around))
            && !self.leaders.iter().any(meets)
            && (label.covers || !self.segments.iter().chain(&self.nameless).any(meets));
        is_free.then_some(bounds)
    }

    /// The boxes that a label must keep off: those of markers, unless it `covers` them, and of other labels.
    fn taken(&self, covers: bool) -> impl Iterator<Item = Bounds> {
        let markers = self.blocked.iter().filter(move |_| !covers).copied();
        markers.chain(self.placed.iter().map(|(_, label)| label.grown(1.0)))
    }

    fn take(&mut self, text: &str, place: Option<LabelPlace>) -> Option<LabelPlace> {
        if let Some(LabelPlace { bounds, leader }) = place {
            self.placed.push((text.to_owned(), bounds));
            self.leaders.extend(leader);
        }
        place
    }

    /// A position beside a curve, as near to its middle as there is room, on either side, and off clouds of
    /// points unless it may be `over_clouds`.
    pub(crate) fn beside_curve(
        &mut self,
        curve: &[Spot],
        label: WantedLabel<'_>,
        over_clouds: bool,
    ) -> Option<LabelPlace> {
        // Fractions of the curve from its middle to 0.08 from its ends.
        let fractions = (0..=14).flat_map(|k| [0.5 - 0.03 * f64::from(k), 0.5 + 0.03 * f64::from(k)]);
        let spots: Vec<(Spot, Spot)> = fractions.skip(1).filter_map(|f| along(curve, f)).collect();
        let foreign = self.all_but(curve);
        let centre = |(at, direction): (Spot, Spot), side: f64, gap: f64| {
            let normal = (direction.1 * side, -direction.0 * side);
            // The half-width of the box along the normal, which places its nearest corner or edge at the
            // gap.
            let reach = 0.5 * (label.width * normal.0.abs() + label.height * normal.1.abs()) + gap;
            (at.0 + normal.0 * reach, at.1 + normal.1 * reach)
        };
        // First positions where the label is clearly nearer to its own curve than to any other, then
        // those where it is only just nearer.
        let rounds = [(1.5, 2.0), (2.5, 2.0), (4.0, 2.0), (1.5, -0.3), (2.5, -0.3), (4.0, -0.3), (6.0, -0.3)];
        for (gap, lead) in rounds {
            for (&spot, side) in spots.iter().flat_map(|spot| [(spot, 1.0), (spot, -1.0)]) {
                let Some(bounds) = self.free(centre(spot, side, gap), label) else { continue };
                let near = bounds.grown(gap + lead);
                let own = !foreign.iter().any(|&(a, b)| near.meets(a, b));
                if own && (over_clouds || self.dusty(&bounds) == 0) {
                    return self.take(label.text, Some(LabelPlace { bounds, leader: None }));
                }
            }
        }
        None
    }

    /// All segments to avoid except those of one curve.
    fn all_but(&self, curve: &[Spot]) -> Vec<(Spot, Spot)> {
        let own: Vec<(Spot, Spot)> = thinned(curve).windows(2).map(|pair| (pair[0], pair[1])).collect();
        let start = self.segments.windows(own.len().max(1)).position(|run| run == own);
        let skipped = start.map_or(0..0, |start| start..start + own.len());
        let rest = self.segments.iter().enumerate().filter(|(i, _)| !skipped.contains(i));
        rest.map(|(_, segment)| *segment).collect()
    }

    /// A position around one of several spots: close to it if there is room, otherwise, or if it is `led`,
    /// farther away with a leader.
    pub(crate) fn around(
        &mut self,
        spots: &[Spot],
        clearance: f64,
        label: WantedLabel<'_>,
        led: bool,
    ) -> Option<LabelPlace> {
        // Unit vectors to the right, then at multiples of 22.5 degrees to either side: cos and sin of 0,
        // 22.5, 45, 67.5, 90.
        const TURNS: [Spot; 5] = [
            (1.0, 0.0),
            (0.923_88, 0.382_68),
            (FRAC_1_SQRT_2, FRAC_1_SQRT_2),
            (0.382_68, 0.923_88),
            (0.0, 1.0),
        ];
        let directions = TURNS.iter().flat_map(|&(c, s)| [(c, -s), (-c, -s), (c, s), (-c, s)]);
        let directions: Vec<Spot> = directions.collect();
        let mut best: Option<(f64, LabelPlace)> = None;
        for gap in GAPS.into_iter().filter(|gap| *gap <= label.farthest && (*gap > LED || !led)) {
            // Nothing costs less than its distance.
            if best.is_some_and(|(cheapest, _)| cheapest <= gap) {
                break;
            }
            let places = spots.iter().flat_map(|spot| directions.iter().map(move |turn| (*spot, *turn)));
            for (at, (right, down)) in places {
                let reach = clearance + gap;
                let (across, up) = (0.5 * label.width + reach, 0.5 * label.height + reach);
                let Some(bounds) = self.free((at.0 + right * across, at.1 + down * up), label) else {
                    continue;
                };
                let leader = (gap >= LED).then(|| leader(&bounds, at, clearance));
                let leader = leader.filter(|(from, to)| led || distance(*from, *to) >= SHORTEST);
                let Some(crossed) = leader.map_or(Some(0), |leader| self.crossed(label, leader)) else {
                    continue;
                };
                let lines = self.segments.iter().chain(&self.nameless);
                let covered = lines.filter(|(a, b)| label.covers && bounds.meets(*a, *b));
                let lines = CROSSING * crossed as f64 + OVER_LINE * covered.count() as f64;
                let cost = gap + lines + COVERING * self.dusty(&bounds) as f64;
                if best.is_none_or(|(cheapest, _)| cost < cheapest) {
                    best = Some((cost, LabelPlace { bounds, leader }));
                }
            }
        }
        self.take(label.text, best.map(|(_, place)| place))
    }

    /// The number of curves that a leader crosses; `None` if it passes through a blocked box or crosses
    /// another leader.
    fn crossed(&self, label: WantedLabel<'_>, (from, to): (Spot, Spot)) -> Option<usize> {
        let meets = |&&(a, b): &&(Spot, Spot)| cross((a, b), (from, to));
        let through = self.taken(label.covers).any(|other| other.meets(from, to));
        if through || self.leaders.iter().any(|other| meets(&other)) {
            return None;
        }
        Some(self.segments.iter().filter(meets).count())
    }

    /// The position inside a polygon that is farthest from everything else; `None` if the box does not
    /// fit.
    pub(crate) fn within(&mut self, polygon: &[Spot], label: WantedLabel<'_>) -> Option<LabelPlace> {
        let polygon = thinned(polygon);
        let Bounds { left, top, right, bottom } = Bounds::around(&polygon).common(self.panel);
        // About 900 trial positions, at least a point apart.
        let pitch = (((right - left) * (bottom - top)).max(0.0) / 900.0).sqrt().max(1.0);
        let mut best: Option<(f64, Bounds)> = None;
        let mut y = top + 0.5 * pitch;
        while y < bottom {
            let mut x = left + 0.5 * pitch;
            while x < right {
                if let Some(bounds) = self.free((x, y), label) {
                    let Bounds { left, top, right, bottom } = bounds;
                    let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
                    if corners.iter().all(|&corner| inside(&polygon, corner)) {
                        let clearance = self.clearance(&bounds);
                        if best.is_none_or(|(widest, _)| clearance > widest) {
                            best = Some((clearance, bounds));
                        }
                    }
                }
                x += pitch;
            }
            y += pitch;
        }
        self.take(label.text, best.map(|(_, bounds)| LabelPlace { bounds, leader: None }))
    }

    /// A spot well inside a polygon and outside all blocked boxes: of a grid of trial spots, the one
    /// farthest from the outline.
    pub(crate) fn deep_inside(&self, polygon: &[Spot]) -> Option<Spot> {
        const TRIALS: u32 = 40;
        let outline = thinned(polygon);
        let Bounds { left, top, right, bottom } = Bounds::around(&outline);
        let at =
            |low: f64, high: f64, i: u32| low + (high - low) * ((f64::from(i) + 0.5) / f64::from(TRIALS));
        let mut best: Option<(f64, Spot)> = None;
        for (i, j) in (0..TRIALS).flat_map(|j| (0..TRIALS).map(move |i| (i, j))) {
            let spot = (at(left, right, i), at(top, bottom, j));
            let around = Bounds::about(spot, 2.0, 2.0);
            if !inside(&outline, spot) || self.taken(false).any(|b| b.overlaps(&around)) {
                continue;
            }
            let depth = outline.iter().map(|&p| distance(p, spot)).fold(f64::INFINITY, f64::min);
            if best.is_none_or(|(deepest, _)| depth > deepest) {
                best = Some((depth, spot));
            }
        }
        best.map(|(_, spot)| spot)
    }

    /// The distance from a box to the nearest curve, blocked box or edge of the panel (Chebyshev distance
    /// for boxes).
    fn clearance(&self, bounds: &Bounds) -> f64 {
        let outside = |(x, y): Spot| {
            let dx = (bounds.left - x).max(x - bounds.right).max(0.0);
            let dy = (bounds.top - y).max(y - bounds.bottom).max(0.0);
            (dx * dx + dy * dy).sqrt()
        };
        let edges = (bounds.left - self.panel.left)
            .min(self.panel.right - bounds.right)
            .min(bounds.top - self.panel.top)
            .min(self.panel.bottom - bounds.bottom);
        let lines = self.segments.iter().chain(&self.leaders);
        let curves = lines.map(|s| outside(s.0).min(outside(s.1)));
        let boxes = self.taken(false).map(|b| {
            let dx = (b.left - bounds.right).max(bounds.left - b.right);
            let dy = (b.top - bounds.bottom).max(bounds.top - b.bottom);
            dx.max(dy)
        });
        curves.chain(boxes).fold(edges, f64::min)
    }
}

/// The centres of boxes side by side, in the given order, as near as possible to the wanted ones with
/// gaps of at least `gap`.
///
/// The wanted centres must ascend. Boxes that would meet move together, so that the sum of squared
/// displacements is least.
pub fn side_by_side(wanted: &[(f64, f64)], gap: f64) -> Vec<f64> {
    // Offsets of the boxes in a row without slack. Centres minus offsets must ascend; those that descend
    // are pooled.
    let mut offsets = Vec::with_capacity(wanted.len());
    let mut pools: Vec<(f64, usize)> = Vec::new();
    for (index, &(centre, width)) in wanted.iter().enumerate() {
        let offset = match index.checked_sub(1) {
            None => 0.0,
            Some(before) => offsets[before] + 0.5 * (wanted[before].1 + width) + gap,
        };
        offsets.push(offset);
        pools.push((centre - offset, 1));
        while let [.., (a, m), (b, n)] = pools[..]
            && a > b
        {
            pools.truncate(pools.len() - 2);
            pools.push(((a * m as f64 + b * n as f64) / (m + n) as f64, m + n));
        }
    }
    let starts = pools.iter().flat_map(|&(start, members)| std::iter::repeat_n(start, members));
    starts.zip(offsets).map(|(start, offset)| start + offset).collect()
}

/// A line from the edge of the box towards the spot, ending at distance `short` from it.
fn leader(bounds: &Bounds, at: Spot, short: f64) -> (Spot, Spot) {
    let nearest = (at.0.clamp(bounds.left, bounds.right), at.1.clamp(bounds.top, bounds.bottom));
    let length = distance(nearest, at);
    let kept = if length > short { (length - short) / length } else { 0.0 };
    (nearest, (nearest.0 + kept * (at.0 - nearest.0), nearest.1 + kept * (at.1 - nearest.1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn label(text: &str, width: f64, height: f64) -> WantedLabel<'_> {
        WantedLabel { text, width, height, farthest: f64::INFINITY, covers: false }
    }

    const SHEET: Bounds = Bounds { left: 0.0, top: 0.0, right: 100.0, bottom: 100.0 };

    #[test]
    fn labels_of_one_curve_take_different_places_off_the_curve() {
        let curve: Vec<Spot> = (0..=50).map(|i| (10.0 + 1.6 * f64::from(i), 50.0)).collect();
        let mut placer = Placer::new(SHEET);
        placer.keep_off(&curve);
        let places: Vec<Bounds> = ["SN", "PD", "GZ"]
            .map(|text| placer.beside_curve(&curve, label(text, 20.0, 8.0), false).unwrap().bounds)
            .into();
        for (index, place) in places.iter().enumerate() {
            assert!(!curve.windows(2).any(|s| place.meets(s[0], s[1])));
            assert!(places[..index].iter().all(|other| !other.overlaps(place)));
            assert!(SHEET.holds(place));
        }
    }

    #[test]
    fn a_label_in_a_square_stands_in_its_middle() {
        let square = [(20.0, 20.0), (60.0, 20.0), (60.0, 60.0), (20.0, 60.0)];
        let mut placer = Placer::new(SHEET);
        placer.keep_off(&[square[0], square[1], square[2], square[3], square[0]]);
        let (x, y) = placer.within(&square, label("p", 10.0, 6.0)).unwrap().bounds.centre();
        // Trial positions are 4/3 apart, and as the box is 10 by 6 the best ones form a short line.
        assert!((x - 40.0).abs() < 2.0 && (y - 40.0).abs() < 4.0, "{x} {y}");
    }

    #[test]
    fn a_label_too_large_for_its_region_finds_no_place_within_and_gets_a_leader_around() {
        let sliver = [(40.0, 50.0), (60.0, 50.0), (60.0, 52.0), (40.0, 52.0)];
        let mut placer = Placer::new(SHEET);
        assert_eq!(placer.within(&sliver, label("p", 10.0, 6.0)), None);
        // A ring that blocks all nearby positions; a leader may cross it.
        placer.keep_off(&[(42.0, 47.0), (58.0, 47.0), (58.0, 55.0), (42.0, 55.0), (42.0, 47.0)]);
        let place = placer.around(&[(50.0, 51.0)], 1.0, label("p", 10.0, 6.0), false).unwrap();
        assert!(place.leader.is_some());
        // The leader stops at the requested clearance.
        assert!((distance(place.leader.unwrap().1, (50.0, 51.0)) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn boxes_side_by_side_keep_their_gap_and_move_only_if_they_must() {
        let centres = side_by_side(&[(0.0, 4.0), (10.0, 4.0), (11.0, 6.0), (30.0, 4.0)], 1.0);
        // The two that would meet need 6 between their centres and share the shortfall of 5.
        assert_eq!(centres, [0.0, 7.5, 13.5, 30.0]);
        assert!(side_by_side(&[], 1.0).is_empty());
    }

    #[test]
    fn without_room_there_is_no_place() {
        let mut placer = Placer::new(SHEET);
        placer.block(SHEET);
        assert_eq!(placer.around(&[(50.0, 50.0)], 1.0, label("p", 10.0, 6.0), false), None);
    }

    #[test]
    fn leaders_do_not_cross_and_equal_labels_keep_apart() {
        let mut placer = Placer::new(SHEET);
        // Spots in a corridor so narrow that labels stand outside.
        placer.keep_off(&[(20.0, 46.0), (80.0, 46.0)]);
        placer.keep_off(&[(20.0, 54.0), (80.0, 54.0)]);
        let spots = [(48.0, 50.0), (50.0, 50.0), (52.0, 50.0)];
        let places = spots.map(|spot| placer.around(&[spot], 1.0, label("PD", 12.0, 9.0), false).unwrap());
        for (index, place) in places.iter().enumerate() {
            for other in &places[..index] {
                assert!(!cross(place.leader.unwrap(), other.leader.unwrap()), "{places:?}");
                assert!(!place.bounds.grown(TWINS).overlaps(&other.bounds), "{places:?}");
            }
        }
    }

    #[test]
    fn a_label_covers_a_cloud_only_if_it_may() {
        let curve: Vec<Spot> = (0..=50).map(|i| (10.0 + 1.6 * f64::from(i), 50.0)).collect();
        let mut placer = Placer::new(SHEET);
        placer.keep_off(&curve);
        placer.avoid((0..10_000).map(|i| (f64::from(i % 100), f64::from(i / 100))));
        assert_eq!(placer.beside_curve(&curve, label("PD", 12.0, 6.0), false), None);
        assert!(placer.beside_curve(&curve, label("PD", 12.0, 6.0), true).is_some());
    }
}
