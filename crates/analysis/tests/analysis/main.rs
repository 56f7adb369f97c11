//! Tests of rows that are computed from diagrams and places, and of reasons
//! why there are none.

mod family;
mod finished;
mod known_motion;
mod nothing;
mod place;
mod plane;
mod walls;
