//! The server from outside, and the page in a browser.

mod browser;
mod server;
