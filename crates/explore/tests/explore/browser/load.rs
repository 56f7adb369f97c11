//! Pages that drag at once, in a real browser. What they do a second is measured by `cargo bench -p
//! grazing-explore --bench load`.

use std::time::Duration;

use super::Running;
use super::crowd::{assert_right, drag_all, open, window};

/// One of each kind: by pointer and by keys, either constant.
const PAGES: usize = 4;

#[test]
fn pages_that_drag_at_once_see_what_unfold_computes() {
    let server = Running::new();
    let Some(mut pages) = open(&server.address, PAGES) else { return };
    let window = window(&mut pages[0]);
    let dragged = drag_all(&mut pages, Duration::ZERO, || false);
    assert!(assert_right(&dragged, window) > 0);
}
