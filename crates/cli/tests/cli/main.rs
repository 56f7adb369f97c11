//! The built program, run as a person would run it.

// What the tests of the report's page have to open it with.
#[path = "../../../report/tests/browser/mod.rs"]
mod browser;
mod program;
// What the tests of exported figures read off them.
#[path = "../../../export/tests/reading/mod.rs"]
mod reading;

mod archive;
mod attractors;
mod bad_input;
mod claims;
mod compare;
mod examples;
mod explore;
mod exported;
mod family;
mod folder;
mod help;
mod journal;
mod measured;
mod motion;
mod mutations;
mod new;
mod places;
mod readme;
mod report;
mod reproduce;
mod scripts;
mod signals;
mod snapshots;
mod tables;
mod unfold;
mod visual;
mod workflow;
