//! `grazing explore`: a page in the browser on which the diagram of an oscillator is explored, and
//! the server behind it.
//!
//! The page holds all state: the oscillator's file, values of its constants, the view of the plane,
//! a place in it. Every request carries what it needs of that, so the server stores nothing but the last
//! diagrams, beside which measurements are laid, and which are computed again if they are gone. It
//! computes with the code of `unfold`, and sends the same numbers: rows under the names of their columns
//! (`answer::told`), with what no row has, and answers that are no rows (`answers!`).
//!
//! | module | |
//! |---|---|
//! | `asked` | requests, and the functions that answer them |
//! | `answer`, `events` | one value or file, or events one after the other |
//! | `model` | from a request to an oscillator |
//! | `diagram`, `place`, `exact`, `cut`, `tiles` | the computations that can be requested |
//! | `follow` | the curve through a solution |
//! | `kept` | the last diagrams |
//! | `measured` | measurements as they are read, and beside the diagram |
//! | `figure` | exported figures |
//! | `kinds` | the looks of kinds of curves, for the page |
//! | `files` | the page |
//! | [`server`](Server) | connections, and the routes of requests |
//! | `server::turns` | computations: how many at once, for how long, and their end without a reader |
//! | `server::patient` | connections that are closed when nobody reads |
//! | `server::guard` | access: token, Host, Origin; security headers of answers |
//! | `server::response`, `server::stream` | answers as HTTP carries them |
//!
//! Without the feature `server` there are no connections, no threads of this crate, no clocks and
//! no files: the rest answers a request wherever it is called, in a worker of the page itself if it
//! is compiled to WebAssembly (`packaging/web/`).
//!
//! HTTP is hyper's: most Rust servers are based on it, it is well maintained, and small without a
//! framework around it (some ten seconds of compilation; tokio is in the tree anyway). The page is
//! a folder of small modules, `page/`, which needs no build step.

mod answer;
mod asked;
mod cut;
mod diagram;
mod events;
mod exact;
mod figure;
#[cfg(feature = "server")]
mod files;
mod follow;
mod kept;
#[cfg(feature = "server")]
mod kinds;
mod measured;
mod model;
mod place;
#[cfg(feature = "server")]
mod server;
mod tiles;

pub use answer::ExportedFile;
pub use asked::{Export, answer};
pub use cut::CutLine;
pub use events::{Clock, Listener};
pub use figure::{Figure, Seen, Wanted};
#[cfg(feature = "server")]
pub use files::{Example, alone};
pub use model::{Model, View};
#[cfg(feature = "server")]
pub use server::{Limits, Server};
