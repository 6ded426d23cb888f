//! Batches divided among threads.

use super::LANES;

/// Number of items of one part: enough work to be worth a thread, few enough that all threads end together.
#[cfg(feature = "parallel")]
const PART: usize = 2048;

/// Runs `work(state, first item, entries)` over all items, with `per_group` entries for every eight of them. With the
/// feature `parallel` and many items it runs in parts on several threads, each with a copy of the state. Results must
/// depend on the items alone.
pub fn over_parts<S, T>(
    entries: &mut [T],
    per_group: usize,
    state: &mut S,
    work: impl Fn(&mut S, usize, &mut [T]) + Sync,
) where
    S: Clone + Send + Sync,
    T: Send,
{
    #[cfg(feature = "parallel")]
    if entries.len() > PART / LANES * per_group && rayon::current_num_threads() > 1 {
        use rayon::prelude::*;
        let parts = entries.par_chunks_mut(PART / LANES * per_group).enumerate();
        parts.for_each_init(|| state.clone(), |state, (part, entries)| work(state, part * PART, entries));
        return;
    }
    let _ = (LANES, per_group);
    work(state, 0, entries);
}

/// Items that are worth being handed to [`over_parts`] at once: `alone` where one thread does all, else some parts for each.
pub fn chunk_for_threads(alone: usize) -> usize {
    #[cfg(feature = "parallel")]
    if rayon::current_num_threads() > 1 {
        return 4 * PART * rayon::current_num_threads();
    }
    alone
}

/// Results of `work(0)` to `work(count - 1)` in this order, computed on several threads.
#[cfg(feature = "parallel")]
pub fn map_all<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    use rayon::prelude::*;
    (0..count).into_par_iter().map(work).collect()
}

/// Results of `work(0)` to `work(count - 1)` in this order.
#[cfg(not(feature = "parallel"))]
pub fn map_all<T>(count: usize, work: impl Fn(usize) -> T) -> Vec<T> {
    (0..count).map(work).collect()
}
