//! A scenario builder, so that tests read like physics.

use carom::engine::{self, Engine, Limits, Roster, Setting};
use carom::math::Vec3;
use carom::math::angle::unit_vector;
use carom::physics::{Cloth, Contact, Cushion, Effects, State};
use carom::scene::{Ball, Scene, Simultaneous, Table, Units};
use carom::trace::{Record, Trace};
use std::sync::{Arc, LazyLock};

/// The report's ball radius, friction and gravity.
pub const R: f64 = 0.234375;
pub const MU: f64 = 0.2;
pub const G: f64 = 9.81;

/// The built-in engines.
pub fn roster() -> &'static Roster {
    static ROSTER: LazyLock<Roster> = LazyLock::new(Roster::built_in);
    &ROSTER
}

/// The built-in engine called `id`.
pub fn find(id: &str) -> Option<&'static Arc<dyn Engine>> {
    roster().find(id)
}

/// A scene in the making: unbounded plane, elastic contact, no cloth, until said otherwise.
pub struct Scenario(Scene);

pub fn scenario(name: &str) -> Scenario {
    Scenario(Scene {
        name: name.to_owned(),
        description: String::new(),
        sets: Vec::new(),
        duration: 20.0,
        run_to_duration: false,
        gravity: G,
        units: Units {
            length: "L".into(),
            length_in_metres: None,
            mass: "M".into(),
            mass_in_kg: None,
            time: "s".into(),
        },
        table: None,
        balls: Vec::new(),
        shot: None,
        effects: Effects {
            contact: Some(Contact::Elastic {}),
            ..Effects::default()
        },
        simultaneous: Simultaneous::Refuse,
        richer: None,
        try_settings: Vec::new(),
    })
}

impl Scenario {
    /// A ball of the report's radius at rest.
    pub fn resting(self, id: &str, position: [f64; 2]) -> Self {
        self.moving(id, position, [0.0, 0.0])
    }

    /// A ball of the report's radius and mass .107 with a velocity.
    pub fn moving(mut self, id: &str, position: [f64; 2], velocity: [f64; 2]) -> Self {
        self.0.balls.push(Ball {
            id: id.to_owned(),
            radius: R,
            mass: 0.107,
            state: State {
                position: Vec3::new(position[0], position[1], R),
                velocity: Vec3::new(velocity[0], velocity[1], 0.0),
                spin: Vec3::zeros(),
            },
        });
        self
    }

    /// A ball shot at `speed` along `angle_deg`.
    pub fn shot(self, id: &str, position: [f64; 2], speed: f64, angle_deg: f64) -> Self {
        let (c, s) = unit_vector(angle_deg);
        self.moving(id, position, [speed * c, speed * s])
    }

    /// Changes the ball added last.
    pub fn with_mass(mut self, mass: f64) -> Self {
        if let Some(ball) = self.0.balls.last_mut() {
            ball.mass = mass;
        }
        self
    }

    /// The report's cloth.
    pub fn cloth(mut self, mu: f64) -> Self {
        self.0.effects.cloth = Some(Cloth::Translational { mu });
        self
    }

    /// A table with elastic cushions and its corner at the origin.
    pub fn cushions(mut self, width: f64, length: f64) -> Self {
        self.0.table = Some(Table {
            min: [0.0, 0.0],
            max: [width, length],
        });
        self.0.effects.cushion = Some(Cushion::Elastic {});
        self
    }

    /// Fifteen resting balls "1" to "15", row by row from the apex, neighbours `gap` apart.
    pub fn rack(mut self, apex: [f64; 2], gap: f64) -> Self {
        let pitch = 2.0 * R + gap;
        let mut id = 0;
        for row in 0..5 {
            for place in 0..=row {
                id += 1;
                let x = apex[0] + pitch * (f64::from(place) - 0.5 * f64::from(row));
                let y = apex[1] + pitch * 0.75_f64.sqrt() * f64::from(row);
                self = self.resting(&id.to_string(), [x, y]);
            }
        }
        self
    }

    pub fn duration(mut self, seconds: f64) -> Self {
        self.0.duration = seconds;
        self
    }

    pub fn build(self) -> Scene {
        self.0
    }
}

/// Runs a scene in an engine, with settings as on the command line: `["dt=1e-3"]`.
pub fn run(engine: &str, settings: &[&str], scene: &Scene, record: Record) -> Trace {
    let setting = Setting::parse(settings.iter().copied()).unwrap();
    let engine = find(engine).unwrap();
    let run = engine::prepare(engine.as_ref(), scene, &setting)
        .unwrap_or_else(|refusal| panic!("{} on {}: {refusal}", engine.id(), scene.name));
    run.simulate(record, &Limits::NONE)
}

/// The report's shot: cue ball from the head spot at F t / m = 108 x .01 / .107 into a rack on the foot spot.
pub fn report_break(gap: f64, angle_deg: f64) -> Scene {
    scenario("report-break-in-a-test")
        .shot("cue", [6.315, 6.075], 108.0 * 0.01 / 0.107, angle_deg)
        .rack([6.315, 18.225], gap)
        .cloth(MU)
        .cushions(12.63, 24.3)
        .build()
}
