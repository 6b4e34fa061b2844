//! The indices of a drone's units among all units.

use cordon_run::scenario::UnitName;

/// The role of a unit: its drone, and which of the drone's three units it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Seat {
    /// The drone's place in the line, from 0.
    pub drone: usize,
    /// Which of its units.
    pub unit: UnitName,
}

impl Seat {
    /// The coordination unit of a drone.
    pub fn coordination(drone: usize) -> Self {
        Self { drone, unit: UnitName::Coordination }
    }

    /// The controller of a drone.
    pub fn control(drone: usize) -> Self {
        Self { drone, unit: UnitName::Control }
    }

    /// The plant of a drone.
    pub fn plant(drone: usize) -> Self {
        Self { drone, unit: UnitName::Plant }
    }

    /// The seats of this many drones, in order of their index.
    pub fn all(drones: usize) -> impl Iterator<Item = Self> {
        (0..drones).flat_map(|drone| UnitName::ALL.map(|unit| Self { drone, unit }))
    }

    /// Its index in a [`Wiring`](crate::wiring::Wiring): drone by drone, the units of a drone in the
    /// order of [`UnitName::ALL`].
    pub fn index(self) -> usize {
        UnitName::ALL.len() * self.drone + self.unit.index()
    }

    /// The seat at an index.
    pub fn at(index: usize) -> Self {
        let [coordination, control, plant] = UnitName::ALL;
        let unit = match index % UnitName::ALL.len() {
            0 => coordination,
            1 => control,
            _ => plant,
        };
        Self { drone: index / UnitName::ALL.len(), unit }
    }

    /// The unit's name, unique in its co-simulation: `plant3`.
    pub fn name(self) -> String {
        format!("{}{}", self.unit.name(), self.drone)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seats_are_counted_through_without_a_gap() {
        let indices: Vec<usize> = Seat::all(4).map(Seat::index).collect();
        assert_eq!(indices, (0..12).collect::<Vec<_>>());
        assert!(Seat::all(4).all(|seat| Seat::at(seat.index()) == seat));
        assert_eq!(Seat::control(2).index(), 7);
        assert_eq!(Seat::plant(3).name(), "plant3");
    }
}
