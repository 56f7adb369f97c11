//! Work on rayon's threads. All of this crate shares one parallel loop, which is compiled once: rayon's own iterators are
//! compiled anew for every closure, which took a sixth of this crate's compilation.

use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

/// The results of a function of each of some items, in the order of the items, on all threads. The items may take very
/// different times.
///
/// # Panics
/// If the function does.
pub(crate) fn map<T: Send, R: Send>(
    items: impl IntoIterator<Item = T>,
    of: impl Fn(T) -> R + Sync,
) -> Vec<R> {
    let slots: Vec<Mutex<Slot<T, R>>> =
        items.into_iter().map(|item| Mutex::new(Slot { item: Some(item), result: None })).collect();
    each(slots.len(), &|k| {
        let slot = || slots[k].lock().unwrap_or_else(PoisonError::into_inner);
        let item = slot().item.take();
        // Nothing is held while the function is computed.
        let result = item.map(&of);
        slot().result = result;
    });
    let done =
        slots.into_iter().filter_map(|slot| slot.into_inner().unwrap_or_else(PoisonError::into_inner).result);
    done.collect()
}

/// An item, until it is taken, and its result, once there is one.
struct Slot<T, R> {
    item: Option<T>,
    result: Option<R>,
}

/// Calls a function with all numbers below a count.
fn each(count: usize, one: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().with_max_len(1).for_each(one);
}
