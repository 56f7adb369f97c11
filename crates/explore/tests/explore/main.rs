//! The server from outside, the page in a browser, and the oscillators of requests.

mod browser;
mod model;
mod server;
mod walls;
