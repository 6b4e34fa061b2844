//! Where the values of a harness come from: the model checker, an enumeration, or bytes.

/// A range of integers to draw from, both ends included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Domain {
    /// The least value.
    pub low: i32,
    /// The greatest value; at most 65,535 above `low`.
    pub high: i32,
    /// The greatest value of an exhaustive test, which cannot try as many as the model checker
    /// covers; at most `high`.
    pub small: i32,
}

impl Domain {
    /// `low ..= high`, of which an exhaustive test tries `low ..= small`.
    pub const fn new(low: i32, high: i32, small: i32) -> Self {
        assert!(low <= small && small <= high && high - low <= 65_535);
        Self { low, high, small }
    }

    /// `low ..= high`, all of it in every mode.
    pub const fn whole(low: i32, high: i32) -> Self {
        Self::new(low, high, high)
    }

    /// Width of the draws in bits, as the tables of measurements name them.
    pub fn bits(self) -> u32 {
        (self.high - self.low).checked_ilog2().map_or(0, |log| log + 1)
    }
}

/// What a run of a harness body came to: `None` where an assumption was not met and nothing was
/// checked, else the [`Witness`].
pub type Case = Option<Witness>;

/// Whether a run that was checked saw the state that its harness wants seen, so that the harness
/// is not true of nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Witness(pub bool);

/// Hands out the values of a run.
pub trait Source {
    /// An integer of the domain.
    fn integer(&mut self, domain: Domain) -> i32;

    /// Any 32-bit word.
    fn word(&mut self) -> u32;

    /// Goes on only where the condition holds: a body writes `source.assume(..)?`.
    fn assume(&mut self, condition: bool) -> Option<()>;

    /// A yes or no.
    fn flag(&mut self) -> bool {
        self.integer(Domain::whole(0, 1)) == 1
    }

    /// Integers of the domain, one for each place.
    fn integers<const N: usize>(&mut self, domain: Domain) -> [i32; N] {
        core::array::from_fn(|_| self.integer(domain))
    }
}

/// The model checker's source: every value at once.
#[cfg(kani)]
#[derive(Debug)]
pub struct Any;

#[cfg(kani)]
impl Source for Any {
    fn integer(&mut self, domain: Domain) -> i32 {
        // As few free bits as will do: a wide value with an assumption costs the solver more.
        let above = match domain.high - domain.low {
            0 => 0,
            1..=255 => i32::from(kani::any::<u8>()),
            _ => i32::from(kani::any::<u16>()),
        };
        kani::assume(above <= domain.high - domain.low);
        domain.low + above
    }

    fn word(&mut self) -> u32 {
        kani::any()
    }

    fn assume(&mut self, condition: bool) -> Option<()> {
        kani::assume(condition);
        Some(())
    }
}

/// Tries every value of every draw, the domains in their small form: an odometer whose wheels
/// are the draws of a run.
#[derive(Debug, Default)]
pub struct Enumerator {
    wheels: Vec<Wheel>,
    at: usize,
}

/// One draw: which of how many values.
#[derive(Debug)]
struct Wheel {
    value: u32,
    values: u32,
}

impl Enumerator {
    /// Words at which arithmetic changes, in the place of all 2^32.
    pub const WORDS: [u32; 7] = [0, 1, 2, 3, 4, u32::MAX - 1, u32::MAX];

    fn turn(&mut self, values: u32) -> u32 {
        if self.at == self.wheels.len() {
            self.wheels.push(Wheel { value: 0, values });
        }
        let value = self.wheels[self.at].value;
        self.at += 1;
        value
    }

    /// Makes the next run draw the next combination; false after the last.
    pub fn advance(&mut self) -> bool {
        // Wheels that the run did not reach belong to no combination of this beginning.
        self.wheels.truncate(self.at);
        self.at = 0;
        while let Some(wheel) = self.wheels.last_mut() {
            wheel.value += 1;
            if wheel.value < wheel.values {
                return true;
            }
            self.wheels.pop();
        }
        false
    }
}

impl Source for Enumerator {
    fn integer(&mut self, domain: Domain) -> i32 {
        let values = (domain.small - domain.low).unsigned_abs() + 1;
        domain.low.saturating_add_unsigned(self.turn(values))
    }

    fn word(&mut self) -> u32 {
        Self::WORDS[self.turn(7) as usize]
    }

    fn assume(&mut self, condition: bool) -> Option<()> {
        condition.then_some(())
    }
}

/// Reads its values from bytes: random ones in tests, a fuzzer's otherwise. Past the end it reads
/// zeros.
#[derive(Debug)]
pub struct Bytes<'b>(&'b [u8]);

impl<'b> Bytes<'b> {
    /// The source that reads these bytes.
    pub fn new(bytes: &'b [u8]) -> Self {
        Self(bytes)
    }

    fn byte(&mut self) -> u32 {
        match self.0 {
            [first, rest @ ..] => {
                self.0 = rest;
                u32::from(*first)
            }
            [] => 0,
        }
    }
}

impl Source for Bytes<'_> {
    fn integer(&mut self, domain: Domain) -> i32 {
        let values = (domain.high - domain.low).unsigned_abs() + 1;
        let drawn = if values <= 256 { self.byte() } else { self.byte() << 8 | self.byte() };
        domain.low.saturating_add_unsigned(drawn % values)
    }

    fn word(&mut self) -> u32 {
        (0..4).fold(0, |word, _| word << 8 | self.byte())
    }

    fn assume(&mut self, condition: bool) -> Option<()> {
        condition.then_some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DOMAIN: Domain = Domain::new(-3, 300, 2);

    #[test]
    fn the_enumerator_draws_every_combination_once() {
        let mut source = Enumerator::default();
        let mut drawn = Vec::new();
        loop {
            let first = source.integer(DOMAIN);
            // A draw that depends on one before it.
            let second = if first > 0 { source.integer(Domain::whole(first, 2)) } else { 0 };
            drawn.push((first, second));
            if !source.advance() {
                break;
            }
        }
        assert_eq!(drawn, [(-3, 0), (-2, 0), (-1, 0), (0, 0), (1, 1), (1, 2), (2, 2)]);
    }

    #[test]
    fn the_enumerator_draws_every_chosen_word() {
        let mut source = Enumerator::default();
        let mut drawn = vec![source.word()];
        while source.advance() {
            drawn.push(source.word());
        }
        assert_eq!(drawn, Enumerator::WORDS);
    }

    #[test]
    fn bytes_reach_both_extremes_and_nothing_beyond() {
        let mut seen = std::collections::BTreeSet::new();
        for high in 0..=255 {
            for low in 0..=255 {
                seen.insert(Bytes::new(&[high, low]).integer(DOMAIN));
            }
        }
        assert_eq!(seen.first(), Some(&DOMAIN.low));
        assert_eq!(seen.last(), Some(&DOMAIN.high));
        assert_eq!(seen.len(), 304);
        let byte = Domain::whole(0, 255);
        let narrow: std::collections::BTreeSet<_> =
            (0..=255).map(|b| Bytes::new(&[b]).integer(byte)).collect();
        assert_eq!(narrow.len(), 256);
        assert_eq!(Bytes::new(&[0xff; 4]).word(), u32::MAX);
        assert_eq!(Bytes::new(&[1, 2, 3, 4]).word(), 0x0102_0304);
        assert_eq!(Bytes::new(&[]).word(), 0);
    }

    #[test]
    fn an_unmet_assumption_ends_the_run() {
        assert_eq!(Enumerator::default().assume(false), None);
        assert_eq!(Bytes::new(&[]).assume(false), None);
        assert_eq!(Bytes::new(&[]).assume(true), Some(()));
    }

    #[test]
    fn widths_are_counted_in_bits() {
        assert_eq!(Domain::whole(7, 7).bits(), 0);
        assert_eq!(Domain::whole(0, 1).bits(), 1);
        assert_eq!(Domain::whole(0, 255).bits(), 8);
        assert_eq!(Domain::whole(1, 257).bits(), 9);
        assert_eq!(Domain::whole(0, 65_535).bits(), 16);
    }
}
