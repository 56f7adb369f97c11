//! Figure 9 (fig:Bb): an impact and the points on Σ and Π that it defines, for p loops.

use grazing_model::maps::{MapError, global_map, virtual_map};
use grazing_model::motion::Motion;
use grazing_model::{AtRest, ImpactOscillator, LinearOscillator, OnWall, State};
use grazing_results::space::{CurveKind, MarkKind, Scene, SurfaceKind};

use crate::space::{Drawn, Space, axes, line, outline, recoil, trajectory};
use crate::{Study, StudyError, parameters};

impl Study {
    /// Figure 9: real and virtual parts of the orbit near the wall, the reset law, P_global from
    /// point to point, and Π on both sides of the wall; marks are the impact, the recoil, (x̂, 0,
    /// ẑ) as virtual, and (x⁽ʲ⁾, 0, z⁽ʲ⁾) with number j.
    ///
    /// # Errors
    /// P_virt or P_global is not defined at a point.
    pub fn fig09(&self) -> Result<Scene, StudyError> {
        let shown = self.parameters.fig09.get()?;
        let oscillator = shown.oscillator;
        let theory =
            grazing_theorems::LinearOscillator::new(oscillator.damping_ratio(), oscillator.restitution())?;
        let origin = theory.grazing(oscillator.frequency())?.phase();
        let space = Space::new(&shown.view, None);

        let failed = |reason: MapError| StudyError::Failed(format!("figure 9: {reason}"));
        // The virtual point of a state on the wall, and the time to it.
        let virtual_point = |from: State| {
            let landing = virtual_map::<_, 1>(&oscillator, OnWall::new(from.velocity, from.phase), None);
            let landing = landing.map_err(failed)?;
            Ok::<_, StudyError>((State::at_rest(landing.jet.value[0], landing.jet.value[1]), landing.time))
        };
        let impact = State::on_wall(shown.impact[0], origin + shown.impact[1]);
        let recoil = recoil(&oscillator, impact);
        let (ahead, time_ahead) = virtual_point(impact)?;
        let (behind, time_behind) = virtual_point(recoil)?;
        let mut points = vec![
            space.mark(MarkKind::Impact, 0, impact),
            space.mark(MarkKind::Recoil, 0, recoil),
            space.mark(MarkKind::Virtual, 0, ahead),
            space.mark(MarkKind::Section, 0, behind),
        ];

        let piece = |state: State, from: f64, to: f64| trajectory(&oscillator, state, from, to);
        let fallen = |state: State, forwards, level| to_level(&oscillator, state, forwards, level);
        let edge = shown.position[0];
        let mut drawn = Drawn::new(&space);
        drawn.curve(CurveKind::Orbit, &piece(impact, fallen(impact, false, edge), 0.0));
        drawn.curve(CurveKind::Virtual, &piece(impact, 0.0, time_ahead));
        drawn.curve(CurveKind::Reset, &line(impact, recoil));
        drawn.curve(CurveKind::Virtual, &piece(recoil, time_behind, 0.0));
        drawn.curve(CurveKind::Orbit, &piece(recoil, 0.0, fallen(recoil, true, edge)));
        let mut last = behind;
        for number in 1..=shown.loops {
            let landing = global_map::<_, 1>(&oscillator, AtRest::new(last.position, last.phase), None);
            let landing = landing.map_err(failed)?;
            let next = State::at_rest(landing.jet.value[0], landing.jet.value[1]);
            points.push(space.mark(MarkKind::Section, number, next));
            drawn.curve(CurveKind::Global, &line(last, next));
            let beyond = next.position > 0.0;
            let kind = if beyond { CurveKind::Virtual } else { CurveKind::Orbit };
            let begin = fallen(next, false, edge);
            if beyond {
                let wall = fallen(next, false, 0.0);
                drawn.curve(CurveKind::Orbit, &piece(next, begin, wall));
                drawn.curve(kind, &piece(next, wall, 0.0));
            } else {
                drawn.curve(kind, &piece(next, begin, 0.0));
            }
            if number < shown.loops {
                drawn.curve(kind, &piece(next, 0.0, fallen(next, true, edge)));
            }
            last = next;
        }
        let surfaces = surfaces(&space, shown, origin).vertices;
        Ok(Scene { curves: drawn.vertices, points, surfaces })
    }
}

/// The time from a state near the wall, in either direction of time, to where x has fallen to a
/// level, or to the turning point if it does not fall so far.
fn to_level(oscillator: &LinearOscillator, state: State, forwards: bool, level: f64) -> f64 {
    /// The orbit starts at rest on Π; this share of a period later it moves.
    const MOMENT: f64 = 1e-3;
    let motion = oscillator.motion(state);
    let period = oscillator.forcing_period() * if forwards { 1.0 } else { -1.0 };
    let moment = if state.velocity == 0.0 { MOMENT * period } else { 0.0 };
    let there = motion.at(moment);
    let phase = state.phase + oscillator.frequency() * moment;
    let moving = State { position: there.position, velocity: there.velocity, phase };
    let rest = oscillator.motion(moving).first_rest(forwards, period.abs());
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
