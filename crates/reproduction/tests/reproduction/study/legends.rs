//! Tests of the legends of figures.

use grazing_drawing::SheetWidth;
use grazing_reproduction::StudyFigure;
use grazing_reproduction::figures::fig01::Figure1;
use grazing_reproduction::figures::fig02::Figure2;
use grazing_reproduction::figures::fig03::Figure3;
use grazing_reproduction::figures::fig04::Figure4;
use grazing_reproduction::figures::fig05::Figure5;
use grazing_reproduction::figures::fig06::Figure6;
use grazing_reproduction::figures::fig07::Figure7;
use grazing_reproduction::figures::fig08::Figure8;
use grazing_reproduction::figures::fig09::Figure9;
use grazing_reproduction::figures::fig10::Figure10;

use super::made;

fn meanings<F: StudyFigure>(shown: &F::Shown) -> Vec<String> {
    let sheet = F::draw(shown, SheetWidth::Paper).expect("it can be drawn");
    sheet.legend.into_iter().map(|(meaning, _)| meaning).collect()
}

fn legend<F: StudyFigure>() -> Vec<String> {
    meanings::<F>(&made().study.shown::<F>().expect("it can be computed"))
}

#[test]
fn sketches_have_no_legends() {
    for (legend, figure) in [
        (legend::<Figure1>(), 1),
        (legend::<Figure3>(), 3),
        (legend::<Figure6>(), 6),
        (legend::<Figure9>(), 9),
        (legend::<Figure10>(), 10),
    ] {
        assert_eq!(legend, [""; 0], "figure {figure}");
    }
}

#[test]
fn diagrams_have_legends_of_what_they_show() {
    let [fig04, fig05] = [legend::<Figure4>(), legend::<Figure5>()];
    let fig02 = meanings::<Figure2>(&made().fig02);
    let fig07 = meanings::<Figure7>(&made().fig07);
    let fig08 = meanings::<Figure8>(&made().fig08);
    for (legend, words, there) in [
        (&fig02, "unstable", true),
        (&fig02, "long-time behaviour", true),
        (&fig02, "$p=3$", true),
        (&fig02, "$p=6$", false),
        (&fig04, "$h_p$", true),
        (&fig04, "$p=6$", true),
        (&fig05, "period-doubling bifurcation", true),
        (&fig05, "(GZ)", false),
        (&fig05, "a maximal periodic solution is stable", true),
        (&fig07, "(GZ)", true),
        (&fig07, "line of a one-parameter diagram", true),
        (&fig07, "quadratic approximation", false),
        (&fig07, "other codimension-two point", true),
        (&fig08, "quadratic approximation to PD", true),
        (&fig08, "the non-impacting solution is stable", true),
        (&fig08, "stability is undecided", false),
    ] {
        let found = legend.iter().any(|meaning| meaning.contains(words));
        assert_eq!(found, there, "{words}: {legend:?}");
    }
}
