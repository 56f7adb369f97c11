//! The built program, run as a user would run it.

// Opening the page in a browser, shared with the tests of the report.
#[path = "../../../report/tests/browser/mod.rs"]
mod browser;
mod program;
// Reading exported figures, shared with the tests of the exports.
#[path = "../../../report/tests/formats/reading/mod.rs"]
mod reading;

mod archive;
mod attractors;
mod bad_input;
mod claims;
mod commands;
mod compare;
mod examples;
mod explore;
mod exported;
mod family;
mod folder;
mod help;
mod journal;
mod limits;
mod measured;
mod motion;
mod mutations;
mod new;
mod places;
mod readme;
mod report;
mod reproduce;
mod schema;
mod scripts;
mod signals;
mod snapshots;
mod tables;
mod unfold;
mod visual;
mod walls;
mod workflow;
