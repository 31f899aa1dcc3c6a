//! Directions given in degrees, as a scene writes them.

/// (cos, sin) of an angle in degrees.
///
/// Reduced by quarter turns before any rounding, so multiples of 90 degrees are exact and angles mirrored about a
/// quarter turn give components that are mirrored to the bit. Without this, a "central" shot at 90 degrees would be
/// 6e-17 off the axis and break a symmetric rack asymmetrically.
pub fn unit_vector(degrees: f64) -> (f64, f64) {
    let quarter = (degrees / 90.0).round();
    let rest = (degrees - quarter * 90.0).to_radians();
    let (c, s) = (rest.cos(), rest.sin());
    match quarter.rem_euclid(4.0) as u8 {
        0 => (c, s),
        1 => (-s, c),
        2 => (-c, -s),
        _ => (s, -c),
    }
}

#[cfg(test)]
mod tests {
    use super::unit_vector;

    #[test]
    fn quarter_turns_are_exact() {
        let expected = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
        for k in -8..8_i32 {
            let (c, s) = unit_vector(90.0 * f64::from(k));
            let (x, y) = expected[k.rem_euclid(4) as usize];
            assert_eq!((c, s), (x, y), "{k} quarter turns");
        }
    }

    #[test]
    fn mirrored_aims_have_mirrored_components_to_the_bit() {
        for offset in [0.2, 0.5, 1.0 / 3.0, 12.25, 44.0] {
            let (left, right) = (unit_vector(90.0 + offset), unit_vector(90.0 - offset));
            // 90 + offset and 90 - offset round differently; hold the angles that f64 can mirror
            if (90.0 + offset) - 90.0 == 90.0 - (90.0 - offset) {
                assert_eq!(left, (-right.0, right.1), "offset {offset}");
            }
        }
        assert_eq!(unit_vector(90.2).0, -unit_vector(89.8).0);
    }

    #[test]
    fn agrees_with_the_library_everywhere() {
        for i in -2000..2000 {
            let d = f64::from(i) * 0.37;
            let (c, s) = unit_vector(d);
            let r = d.to_radians();
            assert!(
                (c - r.cos()).abs() < 1e-14 && (s - r.sin()).abs() < 1e-14,
                "{d} degrees"
            );
        }
    }
}
