//! An engine by `World`: balls that slide to rest; beside the built-in ones, all of which end v^2 / (2 mu g) = 6.371 away.
#![allow(clippy::print_stdout)]
use carom::engine::stepped::{Load, Push, World, WorldEngine, materials};
use carom::engine::{Inside, Limits, Partner, Roster, Setting, prepare};
use carom::{physics::State, scene::Scene, scene::catalogue, trace::Record};

struct Sliding(Scene, Option<materials::Material>);

impl World for Sliding {
    fn step(&mut self, dt: f64) {
        let lost = self.1.map_or(0.0, |cloth| cloth.friction) * self.0.gravity * dt;
        for state in self.0.balls.iter_mut().map(|ball| &mut ball.state) {
            let after = state.velocity * (1.0 - lost / state.velocity.norm()).max(0.0);
            state.position += (state.velocity + after) * dt / 2.0;
            state.velocity = after;
        }
    }
    fn read(&self, states: &mut Vec<State>) {
        *states = self.0.initial_states();
    }
    fn inside(&self) -> Inside {
        materials::inside(&self.0.balls, &[(Partner::Cloth, self.1)])
    }
    fn pushes(&self, _: &mut Vec<Push>) {}
    fn remove(&mut self, _: usize) {}
    fn load(&mut self, _: usize, _: &Load) {}
    fn presses(&self, _: &mut Vec<f64>) {}
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let world = |scene: &Scene| Sliding(scene.clone(), materials::cloth(&scene.effects));
    for engine in &Roster::built_in().with(WorldEngine::new("sliding", world))? {
        let scene = catalogue::scene("slide")?;
        let run = prepare(engine.as_ref(), &scene, &Setting::default())?;
        let trace = run.simulate(Record::Events, &Limits::NONE);
        println!("{:10} {:?}", engine.id(), trace.final_states()[0]);
    }
    Ok(())
}
