//! Numbers as text: the shortest decimal that reads back to the same bits, and a form for JSON that keeps NaN and infinities.

use serde::de::{self, Deserializer, Visitor};
use serde::ser::Serializer;
use std::fmt;

/// The shortest decimal that reads back to the same number: `0.1`, `-0`, `1e300`, `inf`, `-inf`, `NaN`.
///
/// Of the plain and the exponent form the shorter one, plain where they are equally long. Only a NaN's sign and payload are
/// not kept.
pub fn shortest(x: f64) -> String {
    let magnitude = x.abs();
    // between these the plain form is never the longer one, and zero, infinities and NaN have no exponent form
    let plain_is_shorter =
        (0.01..1000.0).contains(&magnitude) || magnitude == 0.0 || !x.is_finite();
    if plain_is_shorter {
        return x.to_string();
    }
    let exponent = format!("{x:e}");
    // the plain form of 1e300 has 301 digits; do not even write it
    if !(1e-30..1e30).contains(&magnitude) {
        return exponent;
    }
    let plain = x.to_string();
    if plain.len() <= exponent.len() {
        plain
    } else {
        exponent
    }
}

/// Writes a number into JSON; a NaN or infinity as the text `"NaN"`, `"inf"` or `"-inf"`.
pub fn serialize<S: Serializer>(x: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    if x.is_finite() {
        serializer.serialize_f64(*x)
    } else {
        serializer.serialize_str(&shortest(*x))
    }
}

/// Reads what [`serialize`] writes, and any other JSON number.
pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    struct Number;

    impl Visitor<'_> for Number {
        type Value = f64;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("a number, \"NaN\", \"inf\" or \"-inf\"")
        }

        fn visit_f64<E: de::Error>(self, x: f64) -> Result<f64, E> {
            Ok(x)
        }

        fn visit_u64<E: de::Error>(self, x: u64) -> Result<f64, E> {
            Ok(x as f64)
        }

        fn visit_i64<E: de::Error>(self, x: i64) -> Result<f64, E> {
            Ok(x as f64)
        }

        fn visit_str<E: de::Error>(self, text: &str) -> Result<f64, E> {
            match text {
                "NaN" => Ok(f64::NAN),
                "inf" => Ok(f64::INFINITY),
                "-inf" => Ok(f64::NEG_INFINITY),
                _ => Err(E::invalid_value(de::Unexpected::Str(text), &self)),
            }
        }
    }

    deserializer.deserialize_any(Number)
}

/// Numbers of JSON that must be finite: times, steps, speeds.
pub mod finite {
    use serde::de::{Deserializer, Error, Unexpected};

    pub use super::serialize;

    /// Reads a JSON number and refuses one that is none, with what would be right.
    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
        let x = super::deserialize(deserializer)?;
        if x.is_finite() {
            return Ok(x);
        }
        let found = super::shortest(x);
        Err(D::Error::invalid_value(
            Unexpected::Str(&found),
            &"a finite number",
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::shortest;

    #[test]
    fn numbers_are_written_in_their_shorter_form() {
        for (x, expected) in [
            (0.0, "0"),
            (-0.0, "-0"),
            (1.0, "1"),
            (0.1, "0.1"),
            (0.01, "0.01"),
            (0.001, "1e-3"),
            (0.0012, "0.0012"),
            (100.0, "100"),
            (1000.0, "1e3"),
            (1001.0, "1001"),
            (-1e300, "-1e300"),
            (5e-324, "5e-324"),
            (f64::INFINITY, "inf"),
            (f64::NEG_INFINITY, "-inf"),
            (f64::NAN, "NaN"),
            (-f64::NAN, "NaN"),
        ] {
            assert_eq!(shortest(x), expected);
        }
    }

    #[test]
    fn no_other_decimal_form_is_shorter() {
        // the claim behind the shortcuts, at 12 digits and few, over 80 decades
        for exponent in -40..40 {
            for digits in [1.0, 1.2, 1.23, 9.99, 1.234_567_890_123, 7.0 / 3.0] {
                let x = digits * 10f64.powi(exponent);
                let best = x.to_string().len().min(format!("{x:e}").len());
                assert_eq!(shortest(x).len(), best, "{x:e}");
            }
        }
    }
}
