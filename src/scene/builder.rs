//! A scene made by a program, so that it reads like physics: what a file would say, one call after another.

use super::file::{BallFile, RackFile, SceneFile, TableFile};
use super::located::Located;
use super::resolve::whatever;
use super::{Scene, SceneError, Simultaneous, parse};
use crate::math::angle::unit_vector;
use crate::physics::{Cloth, Contact, Cushion, Effects, Friction};
use toml::de::DeTable;

/// A scene in the making: an unbounded plane without gravity or effects, until it is told otherwise.
///
/// It is a scene file that no one has written: [`SceneBuilder::build`] holds it against the same rules, with the same words.
///
/// ```
/// use carom::scene::Scene;
/// let scene = Scene::builder("head-on", 2.0)
///     .balls_of(0.028575, 0.17)
///     .moving("cue", [0.0, 0.0], [1.0, 0.0])
///     .resting("1", [0.5, 0.0])
///     .elastic()
///     .build()?;
/// assert_eq!(scene.balls.len(), 2);
/// # Ok::<(), carom::scene::SceneError>(())
/// ```
#[derive(Clone, Debug)]
pub struct SceneBuilder(SceneFile);

impl Scene {
    /// Begins a scene. `name`: in kebab-case; `duration`: longest simulated time, s, > 0.
    pub fn builder(name: &str, duration: f64) -> SceneBuilder {
        SceneBuilder(SceneFile {
            name: name.to_owned(),
            duration,
            ..SceneFile::default()
        })
    }
}

impl SceneBuilder {
    /// Radius (length) and mass of every ball that does not say otherwise, those of a rack included.
    pub fn balls_of(mut self, radius: f64, mass: f64) -> Self {
        self.0.ball.radius = Some(radius);
        self.0.ball.mass = Some(mass);
        self
    }

    /// A ball at rest; centre, length.
    pub fn resting(self, id: &str, position: [f64; 2]) -> Self {
        self.moving(id, position, [0.0, 0.0])
    }

    /// A ball with a velocity, length/s.
    pub fn moving(mut self, id: &str, position: [f64; 2], velocity: [f64; 2]) -> Self {
        self.0.balls.push(BallFile {
            id: id.to_owned(),
            position,
            velocity: Some(velocity),
            spin: None,
            radius: None,
            mass: None,
        });
        self
    }

    /// A ball shot at `speed`, length/s, along `angle_deg`, degrees counter-clockwise from +x.
    pub fn shot(self, id: &str, position: [f64; 2], speed: f64, angle_deg: f64) -> Self {
        let (cos, sin) = unit_vector(angle_deg);
        self.moving(id, position, [speed * cos, speed * sin])
    }

    /// Another radius, length, for the ball added last.
    pub fn with_radius(self, radius: f64) -> Self {
        self.last(|ball| ball.radius = Some(radius))
    }

    /// Another mass for the ball added last.
    pub fn with_mass(self, mass: f64) -> Self {
        self.last(|ball| ball.mass = Some(mass))
    }

    /// A spin, rad/s, for the ball added last.
    pub fn with_spin(self, spin: [f64; 3]) -> Self {
        self.last(|ball| ball.spin = Some(spin))
    }

    fn last(mut self, change: impl FnOnce(&mut BallFile)) -> Self {
        if let Some(ball) = self.0.balls.last_mut() {
            change(ball);
        }
        self
    }

    /// Resting balls "1", "2", ... in so many rows from the apex, after all others; neighbours `gap` apart, length.
    pub fn rack(mut self, apex: [f64; 2], rows: u8, gap: f64) -> Self {
        self.0.rack = Some(RackFile {
            apex,
            rows,
            gap,
            jitter: None,
            seed: None,
        });
        self
    }

    /// Another longest simulated time, s, > 0.
    pub fn duration(mut self, duration: f64) -> Self {
        self.0.duration = duration;
        self
    }

    /// Gravity, length/s^2.
    pub fn gravity(mut self, gravity: f64) -> Self {
        self.0.gravity = Some(gravity);
        self
    }

    /// A table with its corner at the origin, and what its cushions do.
    pub fn table(mut self, width: f64, length: f64, cushion: Cushion) -> Self {
        self.0.table = Some(TableFile {
            width,
            length,
            origin: [0.0, 0.0],
        });
        self.0.effects.cushion = Some(cushion);
        self
    }

    /// What the cloth does.
    pub fn cloth(self, cloth: Cloth) -> Self {
        self.effects(|effects| effects.cloth = Some(cloth))
    }

    /// Balls that meet lose nothing.
    pub fn elastic(self) -> Self {
        self.contact(Contact::Elastic {})
    }

    /// What two balls do that meet.
    pub fn contact(self, contact: Contact) -> Self {
        self.effects(|effects| effects.contact = Some(contact))
    }

    /// How two balls that meet rub.
    pub fn friction(self, friction: Friction) -> Self {
        self.effects(|effects| effects.friction = Some(friction))
    }

    /// Any other effect.
    pub fn effects(mut self, change: impl FnOnce(&mut Effects)) -> Self {
        change(&mut self.0.effects);
        self
    }

    /// What the exact engine does when an impact involves touching balls.
    pub fn simultaneous(mut self, simultaneous: Simultaneous) -> Self {
        self.0.simultaneous = simultaneous;
        self
    }

    /// The run goes on to its duration after everything has come to rest.
    pub fn to_duration(mut self) -> Self {
        self.0.run_to_duration = true;
        self
    }

    /// The scene, whatever is wrong with it: for tests of what engines do with scenes that no file may say. A ball without radius or mass
    /// is none.
    pub fn unchecked(&self) -> Scene {
        let nowhere = Located::whole("", DeTable::new());
        whatever(self.0.clone(), &nowhere).0
    }

    /// The scene. Errors: what is wrong with it, as in a file, with the text that says so.
    pub fn build(&self) -> Result<Scene, SceneError> {
        // a file can hold all that these types can; should that ever fail, the empty text is told to lack everything
        let text = self.0.text().unwrap_or_default();
        parse(&self.0.name, &text)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use crate::physics::{Cloth, Cushion};
    use crate::scene::{Scene, parse};

    #[test]
    fn what_is_built_is_what_the_file_says() {
        let built = Scene::builder("shot", 5.0)
            .gravity(9.81)
            .balls_of(0.25, 0.107)
            .moving("cue", [5.0, 5.0], [0.0, 2.0])
            .with_spin([1.0, 0.0, 3.0])
            .resting("heavy", [5.0, 8.0])
            .with_mass(0.2)
            .with_radius(0.3)
            .rack([5.0, 12.0], 2, 0.01)
            .table(10.0, 20.0, Cushion::Restitution { e: 0.8 })
            .cloth(Cloth::Rotational {
                mu_slide: 0.2,
                mu_roll: 0.01,
                mu_spin: 0.02,
            })
            .elastic()
            .to_duration()
            .build()
            .unwrap();
        let written = r#"
            name = "shot"
            duration = 5.0
            gravity = 9.81
            run_to_duration = true
            table = { width = 10.0, length = 20.0 }
            ball = { radius = 0.25, mass = 0.107 }
            rack = { apex = [5.0, 12.0], rows = 2, gap = 0.01 }
            [[balls]]
            id = "cue"
            position = [5.0, 5.0]
            velocity = [0.0, 2.0]
            spin = [1.0, 0.0, 3.0]
            [[balls]]
            id = "heavy"
            position = [5.0, 8.0]
            radius = 0.3
            mass = 0.2
            [effects.cloth.rotational]
            mu_slide = 0.2
            mu_roll = 0.01
            mu_spin = 0.02
            [effects.contact.elastic]
            [effects.cushion.restitution]
            e = 0.8
        "#;
        // the ball that rests says so in one and not in the other: that is all the same
        assert_eq!(built, parse("shot.toml", written).unwrap());
    }

    #[test]
    fn what_no_file_may_say_is_not_built() {
        let two = Scene::builder("two", 1.0).balls_of(0.1, 1.0);
        let two = two.resting("a", [0.0, 0.0]).resting("b", [0.15, 0.0]);
        let error = two.elastic().build().unwrap_err().to_string();
        assert!(error.contains("overlap"), "{error}");
        let error = Scene::builder("none", 1.0).build().unwrap_err().to_string();
        assert!(error.contains("a scene must have a ball"), "{error}");
    }
}
