//! Coulomb friction: one coefficient, whatever the slip speed.

/// Coefficient of friction, >= 0: `mu` itself.
pub fn coefficient<T>(mu: T) -> T {
    mu
}
