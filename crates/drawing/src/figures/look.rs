//! Options by which figures of an oscillator differ from the paper's.

use grazing_input::{FigureStyle, LabelKind};
use grazing_results::plane::RegionKind;

use crate::ink::style::SheetWidth;

/// The width of sheets, and the style of two-parameter diagrams and magnifications on them.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// The width of the sheets.
    pub columns: SheetWidth,
    /// The style, as a file may ask for it. The width of the diagram applies only if the sheets do not have the width of a
    /// journal's columns.
    pub style: FigureStyle,
}

impl From<SheetWidth> for Look {
    /// The style of the paper's figures, on sheets of this width.
    fn from(columns: SheetWidth) -> Self {
        Self { columns, style: FigureStyle::default() }
    }
}

impl Look {
    /// The width of a diagram that is `paper` millimetres wide in the paper.
    pub(crate) fn width_mm(&self, paper: f64) -> f64 {
        self.columns.mm(self.style.width.unwrap_or(paper))
    }

    /// Whether objects of a kind have their names in the figure.
    pub(crate) fn names(&self, what: LabelKind) -> bool {
        self.style.names.contains(&what)
    }

    /// The look without an exchange of axes.
    pub(crate) fn unswapped(mut self) -> Self {
        self.style.swap = false;
        self
    }

    /// Whether regions of a kind are drawn; undecided regions always are.
    pub(crate) fn shows(&self, kind: RegionKind) -> bool {
        self.style.shading || kind == RegionKind::Undecided
    }
}

#[cfg(test)]
mod tests {
    use grazing_continuation::bifurcation::Bifurcation;
    use grazing_results::kinds::CurveLook;

    use super::*;
    use crate::ink::sheet::Sheet;
    use crate::ink::svg::hex;
    use crate::tests::inspection::paths;
    use crate::tests::sample_oscillator::{SampleOscillator, UNIT, oscillators, sample};
    use crate::{draw_diagram, draw_magnifications};

    const USUAL: SheetWidth = SheetWidth::Paper;

    fn styled(style: FigureStyle) -> Look {
        Look { columns: USUAL, style }
    }

    fn without(what: LabelKind) -> Look {
        let names = LabelKind::ALL.into_iter().filter(|named| *named != what).collect();
        styled(FigureStyle { names, ..FigureStyle::default() })
    }

    fn drawn(sample: &SampleOscillator, look: Look) -> Sheet {
        draw_diagram(&sample.diagram, &sample.heading(), look).unwrap()
    }

    #[test]
    fn axes_change_places_with_all_that_is_drawn() {
        for sample in oscillators() {
            let swapped = drawn(&sample, styled(FigureStyle { swap: true, ..FigureStyle::default() }));
            swapped.assert_well_placed(&sample.names);
            let usual = drawn(&sample, USUAL.into());
            let panel = |sheet: &Sheet| sheet.panels().next().unwrap().clone();
            let (swapped, usual) = (panel(&swapped), panel(&usual));
            assert_eq!([swapped.frame.x, swapped.frame.y], [usual.frame.y, usual.frame.x]);
            let [across, up] = usual.titles;
            assert_eq!(swapped.titles, [up, across]);
        }
        // A direction that was up is now to the right.
        let sample = SampleOscillator::new(["A", "omega"], UNIT, UNIT, 3);
        let grazing = |swapped: bool| {
            let svg = drawn(&sample, styled(FigureStyle { swap: swapped, ..FigureStyle::default() })).svg();
            paths(&svg, &hex(CurveLook::of(Bifurcation::NonImpactingGrazing).colours[0])).swap_remove(0)
        };
        let spread = |curve: &[(f64, f64)]| {
            let (first, last) = (curve[0], curve[curve.len() - 1]);
            [(last.0 - first.0).abs(), (last.1 - first.1).abs()]
        };
        let ([across, up], [across_after, up_after]) = (spread(&grazing(false)), spread(&grazing(true)));
        assert!((across > up) != (across_after > up_after), "{across} {up} {across_after} {up_after}");
        let magnified = |swapped: bool| {
            let look = styled(FigureStyle { swap: swapped, ..FigureStyle::default() });
            let sheets = draw_magnifications(&sample.magnifications, &sample.magnified(), look).unwrap();
            sheets[0].panels().next().unwrap().frame
        };
        let [swapped, usual] = [magnified(true), magnified(false)];
        assert_eq!([swapped.x, swapped.y], [usual.y, usual.x]);
    }

    #[test]
    fn colours_names_shading_and_size_are_those_asked_for() {
        let sample = sample(3);
        let [blue, red] =
            [Bifurcation::SaddleNode, Bifurcation::PeriodDoubling].map(|kind| CurveLook::of(kind).colours[0]);
        // Two colours are exchanged in the figure and in the legend.
        let colours = vec![(Bifurcation::SaddleNode, red), (Bifurcation::PeriodDoubling, blue)];
        let (usual, changed) = (
            drawn(&sample, USUAL.into()),
            drawn(&sample, styled(FigureStyle { colours, ..FigureStyle::default() })),
        );
        assert_eq!(paths(&changed.svg(), &hex(red)), paths(&usual.svg(), &hex(blue)));
        assert_eq!(paths(&changed.svg(), &hex(blue)), paths(&usual.svg(), &hex(red)));
        let sample_of = |sheet: &Sheet| {
            let (_, drawing) =
                sheet.legend.iter().find(|(words, _)| words.starts_with("saddle-node")).unwrap();
            drawing.contains(&hex(red))
        };
        assert_eq!([&usual, &changed].map(sample_of), [false, true]);

        let texts = |look: Look| drawn(&sample, look).texts();
        let has = |texts: &[String], start: &str| texts.iter().any(|text| text.starts_with(start));
        let all = texts(USUAL.into());
        assert!(["PD", "$p=", "(a)"].iter().all(|start| has(&all, start)), "{all:?}");
        for (look, gone) in [
            (without(LabelKind::Curves), "PD"),
            (without(LabelKind::Regions), "$p="),
            (without(LabelKind::Magnifications), "(a)"),
        ] {
            let left = texts(look);
            assert!(
                ["PD", "$p=", "(a)"].iter().all(|start| has(&left, start) == (*start != gone)),
                "{left:?}"
            );
        }

        let white = drawn(&sample, styled(FigureStyle { shading: false, ..FigureStyle::default() }));
        assert!(!white.svg().contains("fill-opacity") && usual.svg().contains("fill-opacity"));
        let [width, height] = [150.0, 60.0];
        let sized = drawn(
            &sample,
            styled(FigureStyle { width: Some(width), height: Some(height), ..FigureStyle::default() }),
        );
        assert!(sized.svg().contains("width=\"150mm\" height=\"60mm\""));
        let style = FigureStyle { width: Some(width), ..FigureStyle::default() };
        let column = Look { style, columns: SheetWidth::OneColumn };
        assert!(drawn(&sample, column).svg().contains("width=\"86mm\""));
    }
}
