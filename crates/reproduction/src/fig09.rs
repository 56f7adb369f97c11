//! Figure 9 (fig:Bb): an impact and the points on Σ and Π that it defines, for p loops.

use grazing_model::maps::{MapError, global_map, virtual_map};
use grazing_model::motion::{Motion, first_rest};
use grazing_model::{AtRest, ImpactOscillator, LinearOscillator, OnWall, State};
use grazing_results::space::{CurveKind, Mark, MarkKind, Scene, SurfaceKind};

use crate::space::{Drawn, Space, axes, line, outline, trajectory};
use crate::{Study, StudyError, parameters};

/// The points of Figure 9, phases near z_graz.
struct Marks {
    impact: State,
    recoil: State,
    /// (x̂, 0, ẑ) and the time to it from the impact.
    ahead: (State, f64),
    /// (x⁽⁰⁾, 0, z⁽⁰⁾) and the time, negative, to it from the recoil.
    behind: (State, f64),
    /// (x⁽ʲ⁾, 0, z⁽ʲ⁾) for j from 1 to p.
    iterates: Vec<State>,
}

impl Marks {
    fn compute(oscillator: &LinearOscillator, impact: State, loops: u32) -> Result<Self, StudyError> {
        let failed = |reason: MapError| StudyError::Failed(format!("figure 9: {reason}"));
        let reset = oscillator.reset::<1>(OnWall::new(impact.velocity, impact.phase)).value;
        let recoil = State::on_wall(reset[0], reset[1]);
        let virtual_point = |from: State| {
            let landing = virtual_map::<_, 1>(oscillator, OnWall::new(from.velocity, from.phase), None)?;
            Ok((State::at_rest(landing.jet.value[0], landing.jet.value[1]), landing.time))
        };
        let (ahead, behind) =
            (virtual_point(impact).map_err(failed)?, virtual_point(recoil).map_err(failed)?);
        let mut iterates = Vec::new();
        let mut last = behind.0;
        for _ in 0..loops {
            let landing = global_map::<_, 1>(oscillator, AtRest::new(last.position, last.phase), None)
                .map_err(failed)?;
            last = State::at_rest(landing.jet.value[0], landing.jet.value[1]);
            iterates.push(last);
        }
        Ok(Self { impact, recoil, ahead, behind, iterates })
    }
}

impl Study<'_> {
    /// Figure 9: real and virtual parts of the orbit near the wall, the reset law, P_global from point to point, and Π on both sides of
    /// the wall; marks are the impact, the recoil, (x̂, 0, ẑ) as virtual, and (x⁽ʲ⁾, 0, z⁽ʲ⁾) with number j.
    ///
    /// # Errors
    /// P_virt or P_global is not defined at a point.
    pub fn fig09(&self) -> Result<Scene, StudyError> {
        let shown = self.parameters.fig09.get()?;
        let of = shown.specimen;
        let oscillator = LinearOscillator::new(of.zeta, of.epsilon, of.amplitude, of.frequency)?;
        let theory = grazing_theorems::LinearOscillator::new(of.zeta, of.epsilon)?;
        let origin = theory.grazing(of.frequency)?.phase();
        let [velocity, phase] = shown.impact;
        let marks = Marks::compute(&oscillator, State::on_wall(velocity, origin + phase), shown.loops)?;
        let space = Space::new(&shown.view, None);
        let curves = curves(&space, &oscillator, &marks, shown.position[0]);
        let surfaces = surfaces(&space, shown, origin).vertices;
        Ok(Scene { plans: Scene::FIG09, curves: curves.vertices, points: points(&space, &marks), surfaces })
    }
}

fn curves<'a>(
    space: &'a Space,
    oscillator: &LinearOscillator,
    marks: &Marks,
    edge: f64,
) -> Drawn<'a, CurveKind> {
    let mut drawn = Drawn::new(space);
    let from_edge =
        |state: State| trajectory(oscillator, state, to_level(oscillator, state, false, edge), 0.0);
    let till_edge =
        |state: State| trajectory(oscillator, state, 0.0, to_level(oscillator, state, true, edge));
    drawn.curve(CurveKind::Orbit, &from_edge(marks.impact));
    drawn.curve(CurveKind::Virtual, &trajectory(oscillator, marks.impact, 0.0, marks.ahead.1));
    drawn.curve(CurveKind::Reset, &line(marks.impact, marks.recoil));
    drawn.curve(CurveKind::Virtual, &trajectory(oscillator, marks.recoil, marks.behind.1, 0.0));
    drawn.curve(CurveKind::Orbit, &till_edge(marks.recoil));
    let mut last = marks.behind.0;
    for (place, &next) in marks.iterates.iter().enumerate() {
        drawn.curve(CurveKind::Global, &line(last, next));
        let go_on = place + 1 < marks.iterates.len();
        if next.position > 0.0 {
            let [edge, wall] = [edge, 0.0].map(|level| to_level(oscillator, next, false, level));
            drawn.curve(CurveKind::Orbit, &trajectory(oscillator, next, edge, wall));
            drawn.curve(CurveKind::Virtual, &trajectory(oscillator, next, wall, 0.0));
        } else {
            drawn.curve(CurveKind::Orbit, &from_edge(next));
        }
        if go_on {
            drawn.curve(
                if next.position > 0.0 { CurveKind::Virtual } else { CurveKind::Orbit },
                &till_edge(next),
            );
        }
        last = next;
    }
    drawn
}

/// The time from a state near the wall, in either direction of time, to where x has fallen to a level, or to the turning
/// point if it does not fall so far.
fn to_level(oscillator: &LinearOscillator, state: State, forwards: bool, level: f64) -> f64 {
    /// The orbit starts at rest on Π; this share of a period later it moves.
    const MOMENT: f64 = 1e-3;
    let motion = oscillator.motion(state);
    let period = oscillator.forcing_period() * if forwards { 1.0 } else { -1.0 };
    let moment = if state.velocity == 0.0 { MOMENT * period } else { 0.0 };
    let there = motion.at(moment);
    let phase = state.phase + oscillator.frequency() * moment;
    let moving = State { position: there.position, velocity: there.velocity, phase };
    let rest = first_rest(&oscillator.motion(moving), forwards, period.abs());
    let turning = moment + rest.unwrap_or(period);
    if motion.at(turning).position >= level {
        return turning;
    }
    // Up to the turning point x only falls.
    let (mut above, mut below) = (0.0, turning);
    loop {
        let middle = 0.5 * (above + below);
        if middle == above || middle == below {
            return middle;
        }
        if motion.at(middle).position >= level {
            above = middle;
        } else {
            below = middle;
        }
    }
}

fn points(space: &Space, marks: &Marks) -> Vec<Mark> {
    let named = [
        (MarkKind::Impact, marks.impact),
        (MarkKind::Recoil, marks.recoil),
        (MarkKind::Virtual, marks.ahead.0),
        (MarkKind::Section, marks.behind.0),
    ];
    let named = named.map(|(kind, state)| space.mark(kind, 0, state));
    let iterates = (1..).zip(&marks.iterates);
    named
        .into_iter()
        .chain(iterates.map(|(number, &state)| space.mark(MarkKind::Section, number, state)))
        .collect()
}

fn surfaces<'a>(space: &'a Space, shown: &parameters::Figure9, origin: f64) -> Drawn<'a, SurfaceKind> {
    let parameters::Figure9 { position, velocity, .. } = *shown;
    let phase = shown.phase.map(|z| origin + z);
    let mut drawn = Drawn::new(space);
    let corners = |end: f64| [(0.0, phase[0]), (end, phase[0]), (end, phase[1]), (0.0, phase[1])];
    for (kind, end) in [(SurfaceKind::Outgoing, velocity[0]), (SurfaceKind::Incoming, velocity[1])] {
        drawn.face(kind, [0.0, end], &outline(corners(end).map(|(y, z)| State::on_wall(y, z))));
    }
    for end in position {
        drawn.face(
            SurfaceKind::Section,
            [end, 0.0],
            &outline(corners(end).map(|(x, z)| State::at_rest(x, z))),
        );
    }
    drawn.curve(SurfaceKind::Tangency, &line(State::on_wall(0.0, phase[0]), State::on_wall(0.0, phase[1])));
    axes(&mut drawn, [position, velocity, phase], phase[0]);
    drawn
}
