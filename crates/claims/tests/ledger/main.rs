//! Tests of the ledger, of what its claims cite, and of what its checks measure with.

mod convergence;
mod files;
mod holds;
mod ledger;
mod outcome;
mod polygon;
mod published;
mod sampling;
mod source;
mod specimen;
mod sweep;
mod tally;
