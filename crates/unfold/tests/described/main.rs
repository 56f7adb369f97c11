//! Tests of what is computed of oscillators from text files: rows, and reasons why there are none.

mod family;
mod finished;
mod known_motion;
mod nothing;
mod place;
mod plane;
mod walls;
