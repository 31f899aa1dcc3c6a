//! The report's balls, so that tests read like physics.

use carom::engine::{self, Engine, Limits, Roster, Setting};
use carom::physics::{Cloth, Cushion};
use carom::scene::{Scene, SceneBuilder};
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

/// A scene of the report's balls in the making: unbounded plane, elastic contact, no cloth, until said otherwise.
pub struct Scenario(SceneBuilder);

pub fn scenario(name: &str) -> Scenario {
    let scene = Scene::builder(name, 20.0).gravity(G).balls_of(R, 0.107);
    Scenario(scene.elastic())
}

impl Scenario {
    /// A ball at rest.
    pub fn resting(self, id: &str, position: [f64; 2]) -> Self {
        Scenario(self.0.resting(id, position))
    }

    /// A ball with a velocity.
    pub fn moving(self, id: &str, position: [f64; 2], velocity: [f64; 2]) -> Self {
        Scenario(self.0.moving(id, position, velocity))
    }

    /// A ball shot at `speed` along `angle_deg`.
    pub fn shot(self, id: &str, position: [f64; 2], speed: f64, angle_deg: f64) -> Self {
        Scenario(self.0.shot(id, position, speed, angle_deg))
    }

    /// Changes the ball added last.
    pub fn with_mass(self, mass: f64) -> Self {
        Scenario(self.0.with_mass(mass))
    }

    /// The report's cloth.
    pub fn cloth(self, mu: f64) -> Self {
        Scenario(self.0.cloth(Cloth::Translational { mu }))
    }

    /// A table with elastic cushions and its corner at the origin.
    pub fn cushions(self, width: f64, length: f64) -> Self {
        Scenario(self.0.table(width, length, Cushion::Elastic {}))
    }

    /// Fifteen resting balls "1" to "15", row by row from the apex, neighbours `gap` apart.
    pub fn rack(self, apex: [f64; 2], gap: f64) -> Self {
        Scenario(self.0.rack(apex, 5, gap))
    }

    pub fn duration(self, seconds: f64) -> Self {
        Scenario(self.0.duration(seconds))
    }

    pub fn build(self) -> Scene {
        self.0.unchecked()
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
