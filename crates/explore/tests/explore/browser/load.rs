//! Pages that drag at once, in a real browser. `cargo bench -p grazing-explore --bench load`
//! measures their performance.

use std::time::Duration;

use super::Running;
use super::crowd::{assert_right, drag_all, open, window};

/// One page of each kind: by pointer and by keys, for either constant.
const PAGES: usize = 4;

#[test]
fn pages_that_drag_at_once_see_what_unfold_computes() {
    let server = Running::new();
    let Some(mut pages) = open(&server.address, PAGES) else { return };
    let window = window(&mut pages[0]);
    let dragged = drag_all(&mut pages, Duration::ZERO, || false);
    assert!(assert_right(&dragged, window) > 0);
}
