//! The unit in which a comparison prints lengths.

use crate::finding::Cell;
use crate::study::compare::ComparisonOutcome;

/// Unit in which lengths are printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LengthUnit {
    /// The scene's smallest radius.
    #[default]
    Radius,
    /// The scene's own unit.
    Scene,
}

impl LengthUnit {
    /// Every unit.
    pub const ALL: [LengthUnit; 2] = [LengthUnit::Radius, LengthUnit::Scene];

    /// Word of `--units`.
    pub fn id(self) -> &'static str {
        match self {
            LengthUnit::Radius => "R",
            LengthUnit::Scene => "scene",
        }
    }
}

/// How lengths are printed: a factor from R, and the unit's name.
pub struct Scale {
    /// Length in this unit of one R.
    pub factor: f64,
    /// Its name.
    pub unit: String,
}

impl Scale {
    /// The scale of a unit.
    pub fn new(outcome: &ComparisonOutcome, unit: LengthUnit) -> Self {
        match unit {
            LengthUnit::Radius => Scale {
                factor: 1.0,
                unit: "R".to_owned(),
            },
            LengthUnit::Scene => Scale {
                factor: outcome.scene.smallest_radius(),
                unit: outcome.scene.units.length.clone(),
            },
        }
    }

    /// A length given in R.
    pub fn cell(&self, in_radii: Option<f64>) -> Cell {
        Cell::maybe(in_radii.map(|r| r * self.factor))
    }

    /// A length given in R, with two digits, for a sentence.
    pub fn words(&self, in_radii: f64) -> String {
        let length = in_radii * self.factor;
        if length == 0.0 || (1e-3..1e5).contains(&length) {
            let digits = (1.0 - length.max(1e-3).log10().floor()).clamp(0.0, 4.0) as usize;
            format!("{length:.digits$} {}", self.unit)
        } else {
            format!("{length:.1e} {}", self.unit)
        }
    }

    /// A worst length given in R, with the ball that owns it.
    pub fn owned(&self, worst: Option<(f64, &str)>) -> Cell {
        match worst {
            Some((value, owner)) if !owner.is_empty() => {
                Cell::Owned(value * self.factor, owner.to_owned())
            }
            Some((value, _)) => Cell::Number(value * self.factor),
            None => Cell::Empty,
        }
    }
}
