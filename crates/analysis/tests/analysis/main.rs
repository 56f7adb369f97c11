//! Tests of rows that are computed from diagrams and places.

mod finished;
mod place;
mod plane;
