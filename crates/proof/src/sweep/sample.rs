//! Random starts of a grid, for grids too large to exhaust.

use super::exhaust::{Exhaust, Tally, Trial};
use super::grid::Grid;
use cordon_core::random::SplitMix;

/// Draws one start after another go into pieces of this many, each with its own generator:
/// the pieces can be drawn in any order, by any number of threads.
pub const PIECE: u64 = 1024;

/// Tries the draws of one piece of a work item: those numbered `piece * PIECE` and up, below
/// `samples`. Every start of the grid is equally likely in every draw.
pub fn sample(
    engine: &Exhaust,
    grid: &Grid,
    samples: u64,
    piece: u64,
    seed: u64,
    item: usize,
) -> Tally {
    let mut trial = Trial::new(engine, false);
    let mut seeds = SplitMix::new(seed);
    // A seed a piece: the generator's own output keeps neighbouring pieces apart.
    let mut random = SplitMix::new(seeds.bits() ^ (item as u64).rotate_left(40) ^ piece);
    let mut start = Vec::with_capacity(grid.count);
    let draws = samples.saturating_sub(piece.saturating_mul(PIECE)).min(PIECE);
    for _ in 0..draws {
        if !grid.draw(&mut |bound| random.below(bound), &mut start) {
            break;
        }
        trial.start(&start);
    }
    trial.end()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use cordon_spec::theorems::StartSet;

    use super::*;

    #[test]
    fn every_start_is_drawn_about_equally_often() {
        for (starts, count, resolution) in [
            (StartSet::Ordered, 5, 8),
            (StartSet::UpperBounded, 4, 6),
            (StartSet::FirstSubsegment, 5, 6),
            (StartSet::Any, 4, 3),
        ] {
            let Some(grid) = Grid::new(starts, count, resolution) else { unreachable!("small") };
            let mut seen: BTreeMap<Vec<i64>, u32> = BTreeMap::new();
            let mut random = SplitMix::new(7);
            let mut start = Vec::new();
            let mut wanted = 0u32;
            grid.for_each(&grid.whole(), |_| {
                wanted += 1;
                true
            });
            for _ in 0..1000 * wanted {
                assert!(grid.draw(&mut |bound| random.below(bound), &mut start));
                *seen.entry(start.clone()).or_default() += 1;
            }
            grid.for_each(&grid.whole(), |start| {
                let times = seen.remove(start).unwrap_or(0);
                assert!((850..1150).contains(&times), "{starts:?} {start:?} {times}");
                true
            });
            assert!(seen.is_empty(), "{starts:?} {seen:?}");
        }
    }
}
