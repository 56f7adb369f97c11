//! The outputs that `reproduce` writes: the figures and tables of the paper, and those beyond it.

use std::error::Error;

use grazing_beyond::{all_figures, limit_maps};
use grazing_drawing::SheetWidth;
use grazing_reproduction::figures::fig07::Figure7;
use grazing_reproduction::parameters::ParameterError;
use grazing_reproduction::{
    CoefficientTable, ComparedCoefficients, Remarks, Study, StudyError, StudyFigure, TheoremsInAction,
};
use grazing_results::columns::{C_2GZ, LOOPS, M_2GZ, M_PD, M_SN, RESONANCE_INDEX, SIGMA};
use grazing_results::plane::StraightenedCurves;
use grazing_results::{Names, Tables, Title};
use grazing_unfold::limit_map::LimitTable;

use super::latex::Caption;
use super::{COEFFICIENT_COLUMNS, ComputedOutput, DrawnFigure, Output, PrintedTable};
use crate::failure::Failure;

/// All outputs, in the order in which they are computed.
pub const ALL: &[Output<Study>] =
    &all_figures!(figure, first COEFFICIENTS, last STRAIGHTENED, THEOREMS, LIMITS);

/// The output of a figure of the study.
pub(crate) const fn figure<F: StudyFigure>() -> Output<Study> {
    Output {
        label: F::LABEL,
        is_figure: true,
        check: |study| study.parameters.section::<F>().map(drop),
        keys: F::REMEDY,
        ..Output::new(F::NAME, F::TITLE, F::TABLES, |output, study: &Study, width| {
            let section: F = study.parameters.section().map_err(StudyError::from)?;
            computed(output, &section, study, &*study.shown::<F>()?, width)
        })
    }
}

/// A figure of the study, drawn and as tables.
pub(crate) fn computed<F: StudyFigure>(
    output: &Output<Study>,
    section: &F,
    study: &Study,
    shown: &F::Shown,
    width: SheetWidth,
) -> Result<ComputedOutput, Box<dyn Error>> {
    let constants: Vec<String> =
        F::constants(study)?.iter().map(|(name, value)| format!("${name} = {value}$")).collect();
    let remark =
        if constants.is_empty() { String::new() } else { format!(" Here {}.", constants.join(", ")) };
    let figure = DrawnFigure {
        file: output.figure_file(),
        sheet: F::draw(shown, width)?,
        caption: Caption { remark, ..output.caption() },
        tables: output.table_names(),
        only: None,
    };
    let Remarks { notes, gaps } = section.remarks(study, shown)?;
    let tables = shown.tables_as(output.tables, &Names::of_the_paper());
    Ok(ComputedOutput { notes, gaps, ..ComputedOutput::new(vec![figure], tables) })
}

pub(crate) const COEFFICIENTS: Output<Study> = Output {
    label: "tab:coefficients",
    printed: Some(COEFFICIENT_COLUMNS),
    check: |study| study.parameters.section::<Figure7>().map(drop),
    keys: Figure7::REMEDY,
    ..Output::new(
        "coefficients",
        Title::plain("Coefficients at all resonances of Figure~7"),
        CoefficientTable::TABLES,
        |output, study: &Study, _| {
            let table = study.coefficients()?;
            Ok(ComputedOutput {
                tables: table.tables(&Names::of_the_paper()),
                notes: table.rows.iter().flat_map(ComparedCoefficients::doubts).collect(),
                gaps: study.unlocated()?,
                printed: vec![(COEFFICIENT_COLUMNS, output.caption())],
                ..ComputedOutput::default()
            })
        },
    )
};

const STRAIGHTENED: Output<Study> = Output {
    label: "tab:straightened",
    check: |study| study.parameters.section::<Figure7>().map(drop),
    keys: Figure7::REMEDY,
    ..Output::new(
        "straightened",
        Title::plain("Curves of Figure~7 in straightened coordinates"),
        StraightenedCurves::TABLES,
        |_, study: &Study, _| {
            Ok(ComputedOutput::new(Vec::new(), study.straightened()?.tables(&Names::of_the_paper())))
        },
    )
};

/// The table of the theorems, which depends on no parameter.
const THEOREMS: Output<Study> = Output {
    label: "tab:theorems",
    ..Output::new(
        "theorems",
        Title::plain("Theorems 2.2 to 2.5 compared with continuation and simulation"),
        TheoremsInAction::TABLES,
        |_, study: &Study, _| {
            let tables = study.theorems_in_action()?.tables(&Names::of_the_paper());
            Ok(ComputedOutput::new(Vec::new(), tables))
        },
    )
};

/// The limit maps that a document prints, with their columns.
const LIMIT_COLUMNS: PrintedTable =
    ("beyond_limits", &[LOOPS, RESONANCE_INDEX, SIGMA, M_SN, M_PD, M_2GZ, C_2GZ]);

const LIMITS: Output<Study> = Output {
    label: "tab:limits",
    printed: Some(LIMIT_COLUMNS),
    check: |study| study.parameters.section::<Figure7>().map(drop),
    keys: Figure7::REMEDY,
    ..Output::new(
        "beyond_limits",
        Title::beyond("the limit map at the resonances of Figure~7"),
        LimitTable::TABLES,
        |output, study: &Study, _| {
            let tables = limit_maps::at_resonances(study)?.tables(&Names::of_the_paper());
            let printed = vec![(LIMIT_COLUMNS, output.caption())];
            Ok(ComputedOutput { printed, ..ComputedOutput::new(Vec::new(), tables) })
        },
    )
};

impl Output<Study> {
    /// The caption of the output in a document.
    fn caption(&self) -> Caption {
        Caption { title: self.title.owned(), label: self.label.to_owned(), remark: String::new() }
    }
}

/// Rejects parameters that would be wrong for any oscillator: they are slips, which are better
/// corrected than worked around.
///
/// # Errors
/// The first such error in the parameters that some output needs.
pub(crate) fn refuse_malformed<'a>(
    outputs: impl Iterator<Item = &'a Output<Study>>,
    study: &Study,
) -> Result<(), Failure> {
    let mut refused = outputs.filter_map(|output| (output.check)(study).err());
    match refused.find(|error| matches!(error, ParameterError::Malformed(_))) {
        Some(error) => Err(error.into()),
        None => Ok(()),
    }
}
