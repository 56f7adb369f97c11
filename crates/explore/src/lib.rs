//! `grazing explore`: a page in the browser on which the diagram of an oscillator is explored, and
//! the server behind it.
//!
//! The page holds all state: the oscillator's file, values of its constants, what is seen of the
//! plane, a place in it. Every request carries what it needs of that, so the server remembers
//! nothing. It computes with what `unfold` computes with, and what it sends are the same numbers.
//!
//! | module | |
//! |---|---|
//! | [`server`](Server) | connections, and where requests go |
//! | `turns` | computations: how many at once, for how long, and their end when nobody waits for them |
//! | `patient` | connections that are given up when nobody reads |
//! | `guard` | who may ask: token, Host, Origin; what answers say to browsers |
//! | `model` | from a request to an oscillator |
//! | `answer`, `stream` | one value as JSON, or events one after the other |
//! | `diagram`, `place`, `exact`, `cut`, `tiles` | what is asked for |
//! | `follow` | the curve through a solution |
//! | `measured` | what a rig did, beside the diagram |
//! | `figure` | what is exported |
//! | `kinds` | how kinds of curves look, for the page |
//!
//! HTTP is hyper's: it is what most Rust servers rest on, well kept, and small without a framework
//! around it (some ten seconds of compilation; tokio is in the tree anyway). The page is a folder
//! of small modules, `page/`, which needs no build step.

mod answer;
mod cut;
mod diagram;
mod exact;
mod figure;
mod files;
mod follow;
mod guard;
mod kinds;
mod measured;
mod model;
mod patient;
mod place;
mod server;
mod stream;
mod tiles;
mod turns;

pub use answer::Sheet;
pub use cut::CutLine;
pub use figure::{Figure, Seen, Wanted};
pub use files::Example;
pub use model::{Model, View};
pub use server::{Export, Server};
pub use turns::Limits;
