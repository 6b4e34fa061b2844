//! The integer starts of an exhaustive sweep, in lexicographic order.
//!
//! The segment is [0, L] with L a multiple of N-1, so that every target is a grid point.
//! `resolution` is the least number of grid units across the region where internal drones may
//! start; L is the smallest such multiple that provides it:
//!
//! | start set | internal drones start at | region |
//! |---|---|---|
//! | ordered | strictly increasing integers inside (0, L) | the segment, L >= resolution |
//! | first subsegment (A2, A3) | strictly increasing integers inside (0, l), l = L/(N-1) | the first subsegment, l >= resolution |
//! | upper bounded (UB) | integers 0 ..= T_i, in any order | the segment |
//! | any | integers 0 ..= L, in any order, coincidences included | the segment |
//!
//! Scaling: the theorems are homogeneous, so a grid of length L also covers every grid whose
//! length divides L. Mirror: where the theorem is symmetric (see [`Grid::mirrored`]) only the
//! lexicographically smaller start of each mirror pair is run, and counted twice.
//!
//! The table only *proposes* starts; the hypothesis predicate of the spec decides about each.

use std::ops::RangeInclusive;

use cordon_spec::theorems::{StartSet, Theorem};
use num_bigint::BigUint;
use num_integer::binomial;

/// Starts of a grid: those whose first internal drones are at `before` and whose next one is
/// in `next`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    before: Vec<i64>,
    next: RangeInclusive<i64>,
}

/// A grid with fewer starts is one piece.
const SMALL: u32 = 2_000;

/// On a segment up to this length a piece fixes two drones: at most 65^2 pieces.
const SHORT: i64 = 64;

/// About how many pieces a longer one has.
const MANY: i64 = 1024;

/// The starts of one start set for N drones on one grid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Grid {
    /// Number of drones N, at least 3.
    pub count: usize,
    /// Length L of the segment in grid units.
    pub length: i64,
    ordered: bool,
    /// Largest position of each internal drone.
    highest: Vec<i64>,
    /// Least position of an internal drone.
    lowest: i64,
}

impl Grid {
    /// The grid of a start set. `None` where the length leaves the range of machine integers.
    pub fn new(starts: StartSet, count: usize, resolution: u32) -> Option<Self> {
        let gaps = i64::try_from(count).ok()?.checked_sub(1).filter(|g| *g >= 2)?;
        let resolution = i64::from(resolution.max(1));
        let spacing = match starts {
            StartSet::FirstSubsegment => resolution,
            _ => (resolution - 1) / gaps + 1,
        };
        Self::of_length(starts, count, gaps.checked_mul(spacing)?)
    }

    /// The starts on a segment of the given length, which need not be a multiple of N-1.
    pub fn of_length(starts: StartSet, count: usize, length: i64) -> Option<Self> {
        let gaps = i64::try_from(count).ok()?.checked_sub(1).filter(|g| *g >= 2)?;
        let internal = 1..gaps;
        let ordered = matches!(starts, StartSet::Ordered | StartSet::FirstSubsegment);
        let highest = match starts {
            StartSet::Any => internal.map(|_| Some(length)).collect::<Option<Vec<_>>>(),
            StartSet::UpperBounded => {
                internal.map(|i| length.checked_mul(i).map(|t| t / gaps)).collect()
            }
            StartSet::Ordered => internal.map(|i| Some(length - gaps + i)).collect(),
            StartSet::FirstSubsegment => {
                // The largest integer below length/(N-1), less the drones that follow.
                let below = (length + gaps - 1) / gaps - 1;
                internal.map(|i| Some(below - (gaps - 1 - i))).collect()
            }
        }?;
        Some(Self { count, length, ordered, highest, lowest: i64::from(ordered) })
    }

    /// How many starts are proposed: their number on this grid.
    pub fn size(&self) -> BigUint {
        let internal = self.highest.len();
        if self.ordered {
            // Strictly increasing within 1 ..= highest of the last.
            let places = self.highest.last().map_or(0, |h| (*h).max(0));
            return binomial(BigUint::from(places.unsigned_abs()), BigUint::from(internal));
        }
        self.highest.iter().map(|h| BigUint::from((h + 1).max(0).unsigned_abs())).product()
    }

    /// Where internal drone number `at` (from 0) may be, given the internal drones before it.
    pub fn choices(&self, before: &[i64]) -> RangeInclusive<i64> {
        let low = match before.last() {
            Some(x) if self.ordered => x + 1,
            _ => self.lowest,
        };
        low..=self.highest.get(before.len()).copied().unwrap_or(-1)
    }

    /// The whole grid as one piece.
    pub fn whole(&self) -> Piece {
        Piece { before: Vec::new(), next: self.choices(&[]) }
    }

    /// The grid in pieces that can be swept apart, in lexicographic order: several times as
    /// many as a machine has cores where the grid is large, never more than a few thousand.
    pub fn pieces(&self) -> Vec<Piece> {
        let Piece { next: first, .. } = self.whole();
        if self.size() < SMALL.into() {
            return vec![self.whole()];
        }
        if self.length <= SHORT {
            // One piece for each place of the first two internal drones.
            let second = |x: i64| self.choices(&[x]).map(move |y| (x, y));
            return first
                .flat_map(second)
                .map(|(x, y)| Piece { before: vec![x], next: y..=y })
                .collect();
        }
        let width = (first.end() - first.start()) / MANY + 1;
        let last = *first.end();
        let starts = std::iter::successors(Some(*first.start()), |x| x.checked_add(width));
        starts
            .take_while(|x| *x <= last)
            .map(|x| Piece { before: Vec::new(), next: x..=(x + (width - 1)).min(last) })
            .collect()
    }

    /// Visits every start of a piece in lexicographic order; drone 0 is at 0 and drone N-1 at
    /// L. Ends early when `visit` answers false.
    pub fn for_each(&self, piece: &Piece, visit: impl FnMut(&[i64]) -> bool) {
        self.visit(piece, false, visit);
    }

    /// [`Self::for_each`] without starts that are greater than their mirror images because drone
    /// N-2 is nearer to drone N-1 than drone 1 to drone 0: all that weigh nothing (see
    /// [`Self::mirror_weight`]), but for ties.
    pub fn for_each_smaller(&self, piece: &Piece, visit: impl FnMut(&[i64]) -> bool) {
        self.visit(piece, true, visit);
    }

    fn visit(&self, piece: &Piece, smaller: bool, mut visit: impl FnMut(&[i64]) -> bool) {
        let mut start = Vec::with_capacity(self.count);
        start.push(0);
        start.extend_from_slice(&piece.before);
        let at = start.len();
        start.resize(self.count, self.length);
        for x in piece.next.clone() {
            if let Some(place) = start.get_mut(at) {
                *place = x;
            }
            if !self.descend(at, &mut start, smaller, &mut visit) {
                return;
            }
        }
    }

    /// Places internal drone number `at` and those after it. The depth is N-2.
    fn descend(
        &self,
        at: usize,
        start: &mut [i64],
        smaller: bool,
        visit: &mut impl FnMut(&[i64]) -> bool,
    ) -> bool {
        let internal = self.highest.len();
        if at >= internal {
            return visit(start);
        }
        let (low, mut high) = self.choices(start.get(1..=at).unwrap_or_default()).into_inner();
        if let (true, Some(first)) = (smaller && at + 1 == internal, start.get(1)) {
            high = high.min(self.length - first);
        }
        for x in low..=high {
            if let Some(place) = start.get_mut(at + 1) {
                *place = x;
            }
            let on = if at + 1 == internal {
                visit(start)
            } else {
                self.descend(at + 1, start, smaller, visit)
            };
            if !on {
                return false;
            }
        }
        true
    }

    /// Draws a start, each equally likely, `below(b)` being a random number in `0 .. b`.
    /// Answers false where there is no start.
    pub fn draw(&self, below: &mut impl FnMut(u64) -> u64, start: &mut Vec<i64>) -> bool {
        let possible = |highest: i64| u64::try_from(highest - self.lowest + 1).unwrap_or(0);
        start.clear();
        start.push(0);
        if self.ordered {
            // A set of N-2 places, each set equally likely (Floyd): the largest place allowed
            // grows by one, and it is taken if the place drawn already is.
            for highest in &self.highest {
                let places = possible(*highest);
                if places == 0 {
                    return false;
                }
                let place = self.lowest + below(places) as i64;
                let taken = start.iter().skip(1).any(|x| *x == place);
                start.push(if taken { *highest } else { place });
            }
            start.sort_unstable();
        } else {
            start.extend(self.highest.iter().map(|h| self.lowest + below(possible(*h)) as i64));
        }
        start.push(self.length);
        true
    }

    /// Whether a theorem says the same of a start and of its mirror image
    /// `X_i -> L - X_{N-1-i}`: so where the start set is its own mirror image and the
    /// conclusion speaks of order, of targets or of squared errors, not of the sum's
    /// direction or of one side of the targets.
    pub fn mirrored(theorem: Theorem, starts: StartSet) -> bool {
        matches!(starts, StartSet::Ordered | StartSet::Any)
            && matches!(
                theorem,
                Theorem::Ordering | Theorem::SumStationary | Theorem::TargetsFixed | Theorem::Limit
            )
    }

    /// How many starts this one stands for: 2 for the smaller of a mirror pair, 1 for its own
    /// mirror image, 0 for the larger.
    pub fn mirror_weight(start: &[i64]) -> u64 {
        let (Some(first), Some(last)) = (start.first(), start.last()) else { return 1 };
        let mirror = start.iter().rev().map(|x| first + last - x);
        match start.iter().copied().cmp(mirror) {
            std::cmp::Ordering::Less => 2,
            std::cmp::Ordering::Equal => 1,
            std::cmp::Ordering::Greater => 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use cordon_spec::theorems::{Setting, Truth};

    use super::*;

    const SETS: [StartSet; 4] =
        [StartSet::Any, StartSet::Ordered, StartSet::FirstSubsegment, StartSet::UpperBounded];

    fn listed(grid: &Grid, pieces: &[Piece]) -> Vec<Vec<i64>> {
        let mut all = Vec::new();
        for piece in pieces {
            grid.for_each(piece, |start| {
                all.push(start.to_vec());
                true
            });
        }
        all
    }

    /// Every integer placement within the segment that the spec's predicate accepts.
    fn by_brute_force(starts: StartSet, count: usize, length: i64) -> Vec<Vec<i64>> {
        let setting = Setting { min: 0, max: length, eps_num: 0, eps_den: 1 };
        let mut all = Vec::new();
        let everywhere = Grid::of_length(StartSet::Any, count, length);
        let everywhere = everywhere.unwrap_or_else(|| unreachable!("small"));
        everywhere.for_each(&everywhere.whole(), |x| {
            if starts.contains(&setting, x) == Truth::True {
                all.push(x.to_vec());
            }
            true
        });
        all
    }

    #[test]
    fn every_start_of_the_set_is_proposed_and_no_other() {
        let mut seen = 0;
        for starts in SETS {
            for count in 3..=6 {
                for length in 1..=9 {
                    let Some(grid) = Grid::of_length(starts, count, length) else {
                        unreachable!("small")
                    };
                    let wanted = by_brute_force(starts, count, length);
                    let got = listed(&grid, &[grid.whole()]);
                    assert_eq!(got, wanted, "{starts:?} {count} {length}");
                    assert_eq!(grid.size(), BigUint::from(wanted.len()));
                    assert!(wanted.is_sorted());
                    seen += wanted.len();
                }
            }
        }
        assert_eq!(seen, 30_795);
    }

    /// Small, short and long grids: in one piece, by two drones, by ranges of one.
    #[test]
    fn pieces_are_the_whole_in_order() {
        let mut numbers = Vec::new();
        for starts in SETS {
            for (count, length) in [(3, 60), (5, 40), (4, 120), (3, 50_000)] {
                let Some(grid) = Grid::of_length(starts, count, length) else {
                    unreachable!("small")
                };
                let pieces = grid.pieces();
                assert_eq!(listed(&grid, &pieces), listed(&grid, &[grid.whole()]));
                numbers.push(pieces.len());
            }
        }
        let wanted = [1, 1681, 121, 1021, 1, 703, 118, 1021, 1, 1, 1, 1000, 1, 231, 41, 1001];
        assert_eq!(numbers, wanted);
    }

    #[test]
    fn targets_are_grid_points_and_the_region_is_fine_enough() {
        for starts in SETS {
            for count in 3..=9 {
                for resolution in 1..=20 {
                    let Some(grid) = Grid::new(starts, count, resolution) else {
                        unreachable!("small")
                    };
                    let gaps = count as i64 - 1;
                    assert_eq!(grid.length % gaps, 0);
                    let region = if starts == StartSet::FirstSubsegment { gaps } else { 1 };
                    assert!(grid.length >= i64::from(resolution) * region);
                    assert!(grid.length - gaps < i64::from(resolution) * region);
                }
            }
        }
    }

    #[test]
    fn mirror_weights_count_every_start_once() {
        let (mut visited, mut whole) = (0, 0);
        for starts in [StartSet::Ordered, StartSet::Any] {
            for (count, length) in [(3, 6), (4, 6), (5, 8), (6, 5)] {
                let all = by_brute_force(starts, count, length);
                let weighted: u64 = all.iter().map(|x| Grid::mirror_weight(x)).sum();
                assert_eq!(weighted, all.len() as u64);
                let Some(grid) = Grid::of_length(starts, count, length) else {
                    unreachable!("small")
                };
                let mut smaller = 0;
                for piece in grid.pieces() {
                    grid.for_each_smaller(&piece, |x| {
                        smaller += Grid::mirror_weight(x);
                        visited += 1;
                        true
                    });
                }
                assert_eq!(smaller, weighted);
                whole += all.len();
            }
        }
        assert_eq!((visited, whole), (1230, 2132));
    }
}
