//! Random numbers that are a pure function of a seed and an index, so that no draw depends on the order of drawing.
//!
//! The generator is SplitMix64 (Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators"): a counter that
//! goes up by an odd constant, and a bijective scrambler. Seed and index are scrambled together into the start of the counter.

/// The golden ratio as a 64-bit fraction: the step of the counter.
const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// One stream of draws: that of item `index` under `seed`.
#[derive(Clone, Debug)]
pub struct Draws {
    counter: u64,
}

impl Draws {
    /// The stream of item `index` under `seed`; the same on every machine, for ever.
    pub fn new(seed: u64, index: u64) -> Self {
        Draws {
            counter: scramble(scramble(seed).wrapping_add(index.wrapping_mul(STEP))),
        }
    }

    /// The next 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.counter = self.counter.wrapping_add(STEP);
        scramble(self.counter)
    }

    /// The next number, uniform in [0, 1), a multiple of 2^-53.
    pub fn uniform(&mut self) -> f64 {
        // the upper 53 bits fit an f64 exactly
        (self.bits() >> 11) as f64 * (f64::EPSILON / 2.0)
    }

    /// The next number, uniform in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }

    /// A point uniform in the disc of radius `radius` around (0, 0): draws from the square until one is inside.
    pub fn in_disc(&mut self, radius: f64) -> (f64, f64) {
        loop {
            let (x, y) = (self.between(-1.0, 1.0), self.between(-1.0, 1.0));
            if x * x + y * y <= 1.0 {
                return (radius * x, radius * y);
            }
        }
    }
}

/// The finaliser of SplitMix64, a bijection on 64 bits.
fn scramble(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::Draws;

    #[test]
    fn bits_are_those_of_the_published_generator() {
        // SplitMix64 with seed 0, first three outputs (reference implementation, Vigna 2015)
        let mut draws = Draws { counter: 0 };
        let expected = [
            0xe220_a839_7b1d_cdaf,
            0x6e78_9e6a_a1b9_65f4,
            0x06c4_5d18_8009_454f,
        ];
        for want in expected {
            assert_eq!(draws.bits(), want);
        }
    }

    #[test]
    fn a_stream_depends_on_seed_and_index_only() {
        let first = |seed, index| Draws::new(seed, index).bits();
        assert_eq!(first(7, 3), first(7, 3));
        assert_ne!(first(7, 3), first(7, 4));
        assert_ne!(first(7, 3), first(8, 3));
        assert_ne!(first(0, 0), first(0, 1));
    }

    #[test]
    fn points_fill_the_disc_evenly() {
        let n = 20_000_u64;
        let points: Vec<(f64, f64)> = (0..n).map(|i| Draws::new(1, i).in_disc(2.0)).collect();
        assert!(points.iter().all(|(x, y)| x.hypot(*y) <= 2.0));
        // half the area lies within radius/sqrt(2); 5 standard deviations of a fair coin tossed n times
        let inner = points.iter().filter(|(x, y)| x * x + y * y <= 2.0).count() as f64;
        let deviation = (n as f64).sqrt() / 2.0;
        assert!(
            (inner - n as f64 / 2.0).abs() < 5.0 * deviation,
            "{inner} of {n}"
        );
        let mean_x = points.iter().map(|p| p.0).sum::<f64>() / n as f64;
        // a coordinate of a uniform point in a disc of radius 2 has standard deviation 1
        assert!(mean_x.abs() < 5.0 / (n as f64).sqrt(), "mean x {mean_x}");
    }
}
