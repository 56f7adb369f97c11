//! What a diagram shows while its regions are being decided.

use std::sync::{Mutex, PoisonError};

use super::Diagram;
use crate::curves::{DiagramCurve, Net};
use crate::region::Region;

/// Passes on what a diagram shows so far.
pub(super) struct Drafts<'a> {
    known: &'a Diagram,
    parts: Mutex<Vec<Part>>,
    receive: &'a (dyn Fn(Diagram) + Sync),
}

/// What is known of the solutions of one p.
#[derive(Clone)]
struct Part {
    loops: u32,
    curves: Vec<DiagramCurve>,
    regions: Vec<Region>,
}

impl<'a> Drafts<'a> {
    /// Passes on a diagram with the curves of all p, of which no region is decided.
    pub(super) fn begin(known: &'a Diagram, nets: &[Net], receive: &'a (dyn Fn(Diagram) + Sync)) -> Self {
        let part = |net: &Net| Part {
            loops: net.loops(),
            curves: net.curves.clone(),
            regions: vec![Region::not_finished(known.scope.window, net.loops())],
        };
        let drafts = Self { known, parts: Mutex::new(nets.iter().map(part).collect()), receive };
        drafts.pass_on(|_| ());
        drafts
    }

    /// Passes on the diagram once the regions of a p are decided, with the curves found on the way.
    pub(super) fn decided(&self, loops: u32, curves: &[DiagramCurve], regions: &[Region]) {
        self.pass_on(|parts| {
            for part in parts.iter_mut().filter(|part| part.loops == loops) {
                (part.curves, part.regions) = (curves.to_vec(), regions.to_vec());
            }
        });
    }

    fn pass_on(&self, change: impl FnOnce(&mut Vec<Part>)) {
        let mut parts = self.parts.lock().unwrap_or_else(PoisonError::into_inner);
        change(&mut parts);
        let now = parts.clone();
        drop(parts);
        let mut draft = self.known.clone();
        for Part { curves, regions, .. } in now {
            draft.curves.extend(curves);
            draft.regions.extend(regions);
        }
        (self.receive)(draft);
    }
}
