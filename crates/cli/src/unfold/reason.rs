//! What is missing in a diagram, and why, with the parameters' own names.

use grazing_input::Description;
use grazing_model::smooth::Units;
use grazing_unfold::Diagram;
use grazing_unfold::nothing::place;
use grazing_unfold::regions::Region;
use grazing_unfold::unfinished::Unfinished;

/// Resonances that could not be located, or whose curves could not be followed: which, and why.
pub(crate) fn lost(
    description: &Description,
    units: &Units,
    diagram: &Diagram,
) -> impl Iterator<Item = (String, String)> {
    let unlocated = diagram.unlocated.iter().map(|lost| {
        let at = place(description, units.parameters(lost.near));
        (format!("p = {}", lost.loops), format!("near {at}: {}", lost.reason))
    });
    let not_unfolded = diagram.not_unfolded.iter().map(|lost| (lost.name(), lost.reason.to_string()));
    unlocated.chain(not_unfolded)
}

/// The unfinished work, as `bifurcation curves of p = 2, n = 1 at A = 0.5, omega = 0.8`.
pub(crate) fn unfinished(description: &Description, units: &Units, cut: &Unfinished) -> String {
    let mut text = cut.stage.to_string();
    if let Some([loops, n]) = cut.resonance {
        text.push_str(&format!(" of p = {loops}, n = {n}"));
    }
    if let Some(at) = cut.at {
        text.push_str(&format!(" at {}", place(description, units.parameters(at))));
    }
    text
}

/// The extent of a region in which stability is undecided, and the reason; none if it is decided.
pub(crate) fn undecided(description: &Description, units: &Units, region: &Region) -> Option<String> {
    let doubt = region.doubt.as_ref()?;
    let [from, to] = region.extent().map(|corner| place(description, units.parameters(corner)));
    Some(format!("from {from} to {to}: {doubt}"))
}

/// Regions that are too thin to be drawn, with their extent.
pub(crate) fn thin(description: &Description, units: &Units, diagram: &Diagram) -> Vec<(u32, String)> {
    let regions = diagram.regions.iter().filter(|region| region.is_thin(diagram.scope.window));
    let line = |region: &Region| {
        let [from, to] = region.extent().map(|corner| place(description, units.parameters(corner)));
        (region.loops, format!("from {from} to {to}"))
    };
    regions.map(line).collect()
}
