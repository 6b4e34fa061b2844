//! Random starts of a grid, for grids too large to exhaust.

use super::exhaust::{Engine, Tally};
use super::grid::Grid;

/// Draws one start after another go into pieces of this many, each with its own generator:
/// the pieces can be drawn in any order, by any number of threads.
pub const PIECE: u64 = 1024;

/// SplitMix64 (Steele, Lea and Flood 2014): a few lines whose sequence no dependency can
/// change, so that a seed means the same draws for ever.
struct SplitMix(u64);

impl SplitMix {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in `0 .. bound`, each equally likely up to 2^-64; `bound > 0`.
    fn below(&mut self, bound: u64) -> u64 {
        let product = u128::from(self.next()) * u128::from(bound);
        // The upper half of a product of two 64-bit numbers is below either.
        (product >> 64) as u64
    }
}

/// Tries the draws of one piece of a work item: those numbered `piece * PIECE` and up, below
/// `samples`. Every start of the grid is equally likely in every draw.
pub fn sample(
    engine: &dyn Engine,
    grid: &Grid,
    samples: u64,
    piece: u64,
    seed: u64,
    item: usize,
) -> Tally {
    let mut tally = Tally::default();
    let mut random = SplitMix(seed);
    // A seed a piece: the generator's own output keeps neighbouring pieces apart.
    random.0 = random.next() ^ (item as u64).rotate_left(40) ^ piece;
    let mut start = Vec::with_capacity(grid.count);
    let draws = samples.saturating_sub(piece.saturating_mul(PIECE)).min(PIECE);
    for _ in 0..draws {
        if !grid.draw(&mut |bound| random.below(bound), &mut start) {
            break;
        }
        engine.start(&start, true, &mut tally);
    }
    tally
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use cordon_spec::theorems::StartSet;

    use super::*;

    #[test]
    fn draws_are_the_published_sequence() {
        // The first outputs of SplitMix64 with seed 1234567, as in its reference code.
        let mut random = SplitMix(1_234_567);
        let drawn = [random.next(), random.next(), random.next()];
        assert_eq!(
            drawn,
            [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423]
        );
    }

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
            let mut random = SplitMix(7);
            let mut start = Vec::new();
            let mut wanted = 0u32;
            grid.for_each(&[], |_| {
                wanted += 1;
                true
            });
            for _ in 0..1000 * wanted {
                assert!(grid.draw(&mut |bound| random.below(bound), &mut start));
                *seen.entry(start.clone()).or_default() += 1;
            }
            grid.for_each(&[], |start| {
                let times = seen.remove(start).unwrap_or(0);
                assert!((850..1150).contains(&times), "{starts:?} {start:?} {times}");
                true
            });
            assert!(seen.is_empty(), "{starts:?} {seen:?}");
        }
    }
}
