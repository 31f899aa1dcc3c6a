//! Engine `exact`: event-driven, in closed form; the reference that accuracy is measured against.
//!
//! - [`flight`], `spin`: a ball between two events, for any cloth, and how it turns meanwhile, where the scene calls for that.
//! - `world`: what stays the same during a run, and what its scalar can tell apart.
//! - `kinematics`: what every ball does, and the clock; the only place where a ball changes its course.
//! - `predict`: the next event of one ball, by the root finders of `math::first_root`; `queue`: which ball is next; `cells`: who may
//!   meet whom, where there are many balls; `agenda`: the three together.
//! - `impact`, `phases`: what an event does, as a value that is decided before it is applied; `ambiguity`, `simultaneous`: whether
//!   something else is in reach, and whether the order of impacts at one instant matters; `cluster_impact`: what becomes of such an instant
//!   where the scene names a convention, by `instant` (losses), `reflections` (normal impulses) and `rubbing` (friction); `collapse`: when
//!   impacts without time passing are too many to be finite.
//! - `contact`, where a run follows them: balls that stay in contact; `sustained` is the loop's part in them, `stretch` the next piece of their motion. `finer`: impacts that shrink to such a
//!   contact, in the next scalar with more digits. `encounter`: who meets whom.
//! - `solve`: the event loop, which applies what they decide; `journal`: what is written down of it; `range`: what cannot begin.
//! - `tangent`: the events of a trace again, with derivatives; `derived`, which `rerun` runs: the same by the solver itself in dual numbers, where balls
//!   stay in contact; from it `certainty` (margin, condition, error of each event), `sensitivity` (growth, and what moves the balls); `auto`
//!   goes to more digits by it. Up to where a run can be believed is the oracle's to say.
//!
//! A ball's prediction is kept with the ball; an event of a pair is known to at least one of the two, and a prediction whose
//! partner has changed since is made anew when its time comes. So an event costs two rows of predictions, whatever else is on
//! the table, and `cells` narrow the partners of a row where there are many balls.
//!
//! Everything is generic over the scalar; `solution` answers in it, a trace in f64. Where the scalar cannot tell what happens, the run ends and
//! says so; it never chooses silently.

mod agenda;
mod ambiguity;
mod auto;
mod cells;
mod certainty;
mod cluster_impact;
mod collapse;
mod contact;
mod derived;
mod encounter;
mod finer;
pub mod flight;
mod impact;
mod instant;
mod journal;
mod kinematics;
mod phases;
mod predict;
mod queue;
mod range;
mod reflections;
mod rerun;
mod rubbing;
pub mod sensitivity;
mod sheet;
mod simultaneous;
mod solution;
mod solve;
mod spin;
mod stretch;
mod sustained;
mod tangent;
mod world;

pub use agenda::Partners;
pub use certainty::{MOST_BALLS, certify, place_errors};
pub use solution::{Solution, final_positions, solve};

use super::setting::{knobs_of, parameters};
use super::{
    About, Engine, Inside, Knob, Limits, Name, Pace, Parameter, Preset, Refusal, Run, Setting,
};
use crate::math::{DoubleDouble, Octuple, Real};
use crate::physics::invariants::{Invariant, kinetic_energy, sphere_inertia};
use crate::physics::{Contact, Cushion, Friction};
use crate::scene::{Ball, Scene, Simultaneous};
use crate::trace::{Provenance, Record, Trace};
use contact::domain::{is_followed, starts_pressed};
use flight::Ground;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use solve::Solver;
use world::World;

/// The event-driven engine.
#[derive(Debug)]
pub struct Exact;

/// The key of the scalar.
const PRECISION: &str = "precision";

/// Settings of `exact`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Settings {
    /// Arithmetic: f64; f32; dd, double-double with 106 bits; f256, with 237 bits; auto, f64 and more where an event is too close to call. States are rounded to f64 in the trace only.
    pub precision: Precision,
    /// Balls that a prediction looks at: auto, those nearby where there are many; all; cells, those nearby. Changes cost only.
    pub partners: Partners,
    /// Where impacts accumulate, or balls stay in contact: auto, the run goes on to the limit and through the contact in scenes of balls and cloths that people build, and ends there as collapsed in others; follow, it goes on in all, of sizes for which rounding decides as well; collapse, it ends there.
    pub contacts: AtContacts,
}

/// What a run does where impacts have a limit, or contacts last.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum AtContacts {
    /// It goes on in scenes of balls and cloths that people build, and ends there in others.
    #[default]
    Auto,
    /// It goes on in any scene.
    Follow,
    /// It ends there, as collapsed.
    Collapse,
}

/// The scalar of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Precision {
    /// 53 bits.
    #[default]
    F64,
    /// 24 bits.
    F32,
    /// Double-double, 106 bits.
    Dd,
    /// 237 bits.
    F256,
    /// f64, and double-double or 237 bits where an event is closer to another than the estimated error of its time.
    Auto,
}

impl Precision {
    /// Every fixed precision, from coarse to fine.
    pub const FIXED: [Precision; 4] = [
        Precision::F32,
        Precision::F64,
        Precision::Dd,
        Precision::F256,
    ];

    /// Those with a finer one to be held against, from coarse to fine.
    pub const WITNESSED: [Precision; 3] = [Precision::F32, Precision::F64, Precision::Dd];

    /// The precision called `id`.
    pub fn find(id: &str) -> Option<Precision> {
        let all = Precision::FIXED.into_iter().chain([Precision::Auto]);
        all.into_iter().find(|precision| precision.id() == id)
    }

    /// Spacing of its numbers just above 1; where more digits may be taken, that of the first.
    pub fn ulp(self) -> f64 {
        match self {
            Precision::F64 | Precision::Auto => f64::ULP,
            Precision::F32 => f32::ULP,
            Precision::Dd => DoubleDouble::ULP,
            Precision::F256 => Octuple::ULP,
        }
    }

    /// The word of `--set precision=`.
    pub fn id(self) -> &'static str {
        match self {
            Precision::F64 => "f64",
            Precision::F32 => "f32",
            Precision::Dd => "dd",
            Precision::F256 => "f256",
            Precision::Auto => "auto",
        }
    }
}

impl Exact {
    /// The setting that asks for a precision.
    pub fn in_precision(precision: Precision) -> Setting {
        Setting::default().with(PRECISION, precision.id())
    }

    /// The precision that a setting asks for; `None` if it is no setting of this engine.
    pub fn precision(setting: &Setting) -> Option<Precision> {
        let settings: Settings = setting.read().ok()?;
        Some(settings.precision)
    }
}

/// True where an impact may lose energy, or friction acts in it.
fn lossy(scene: &Scene) -> bool {
    let effects = &scene.effects;
    let contact = match effects.contact {
        None | Some(Contact::Elastic {}) => false,
        Some(Contact::Inelastic { .. }) => true,
    };
    let cushion = match effects.cushion {
        None | Some(Cushion::Elastic {}) => false,
        Some(
            Cushion::Restitution { .. } | Cushion::Han2005 { .. } | Cushion::Mathavan2010 { .. },
        ) => true,
    };
    contact || cushion || effects.friction.is_some()
}

impl Engine for Exact {
    fn id(&self) -> &str {
        "exact"
    }

    fn version(&self) -> String {
        format!("carom {}", env!("CARGO_PKG_VERSION"))
    }

    fn about(&self) -> About {
        About {
            name: "the exact engine".into(),
            method: "Event-driven: every ball moves in closed form from one event to the next, and the time of each event is the \
                     first root of its equation; there is no time step."
                .into(),
            shares: "The impact laws (physics: contact, friction, cushion) with stepper; the cloth is written anew."
                .into(),
        }
    }

    fn knobs(&self) -> Vec<Knob> {
        knobs_of::<Settings>(&[])
    }

    fn solves(&self) -> bool {
        true
    }

    fn ulp(&self, setting: &Setting) -> f64 {
        Exact::precision(setting).map_or(f64::EPSILON, Precision::ulp)
    }

    fn presets(&self) -> Vec<Preset> {
        vec![Preset {
            sampled: true,
            sound: true,
            swept: false,
            ..Preset::default()
        }]
    }

    fn missing(&self, _scene: &Scene) -> Vec<Name> {
        // every law of the scene format is built, and every convention for any of them
        Vec::new()
    }

    fn promises(&self, scene: &Scene, setting: &Setting) -> Vec<Invariant> {
        // the bounds of the other promises are those of f64
        if Exact::precision(setting) == Some(Precision::F32) {
            return vec![Invariant::Finite, Invariant::Rerun];
        }
        // scenes of sizes far from those of billiards do not keep the others where contacts are followed in them
        let asked = setting.read::<Settings>().map(|settings| settings.contacts);
        let is_plain = is_followed(scene) && !starts_pressed(scene);
        if asked.ok() == Some(AtContacts::Follow) && !is_plain {
            return vec![Invariant::Finite, Invariant::Bounds, Invariant::Rerun];
        }
        let mut promised = vec![
            Invariant::Finite,
            Invariant::Momentum,
            Invariant::EnergyNeverGrows,
            Invariant::Bounds,
            Invariant::Overlap,
            Invariant::Rerun,
            Invariant::Mirror,
            Invariant::Relabelling,
            Invariant::QuarterTurn,
            Invariant::Laws,
        ];
        // a law with a speed or a unit of its own does not scale
        if !matches!(scene.effects.friction, Some(Friction::Alciatore { .. })) {
            promised.push(Invariant::Scaling);
        }
        let lossy = lossy(scene);
        match scene.simultaneous {
            Simultaneous::Refuse | Simultaneous::Ensemble if !lossy => {
                promised.push(Invariant::ImpactEnergy);
            }
            // several impacts share an instant: their sum keeps the energy, one of them may not
            _ => {}
        }
        let world = World::<f64>::new(scene);
        match (world.ground, &world.rotation) {
            // d/dt sqrt(E) is at most -mu g sqrt(m/2) with the lightest mass while anything moves
            (Ground::Coulomb(deceleration), None)
                if world.fastest / deceleration <= scene.duration =>
            {
                promised.push(Invariant::EverythingStops);
            }
            // what a convention resolves at one instant comes back at several
            (Ground::Frictionless, None)
                if !lossy
                    && world.pockets.is_empty()
                    && scene.simultaneous != Simultaneous::GeneralizedReflections =>
            {
                promised.push(Invariant::TimeReversal);
            }
            // how long balls slide, roll and spin has no such bound
            _ => {}
        }
        promised
    }

    fn ladders(&self) -> Vec<(Name, Vec<Setting>)> {
        vec![(
            "precision".into(),
            Precision::FIXED.map(Exact::in_precision).to_vec(),
        )]
    }

    fn pace(&self, scene: &Scene, setting: &Setting) -> Result<Pace, Refusal> {
        let settings: Settings = setting.read()?;
        let operation = match settings.precision {
            Precision::F32 | Precision::F64 | Precision::Auto => 1.0,
            Precision::Dd => 20.0,
            Precision::F256 => 200.0,
        };
        Ok(Pace {
            step: 0.0,
            cost: 1000.0 * operation * scene.balls.len() as f64,
        })
    }

    fn ablations(&self, _scene: &Scene, setting: &Setting) -> Vec<(Name, Setting)> {
        match Exact::precision(setting) {
            Some(Precision::F32) => {
                let finer = setting.clone().with(PRECISION, Precision::F64.id());
                vec![("the arithmetic".into(), finer)]
            }
            _ => Vec::new(),
        }
    }

    fn prepare<'a>(
        &self,
        scene: &'a Scene,
        setting: &Setting,
    ) -> Result<Box<dyn Run + 'a>, Refusal> {
        let settings: Settings = setting.read()?;
        let provenance = Provenance {
            engine: self.id().to_owned(),
            version: self.version(),
            parameters: parameters(&settings),
            scene: scene.name.clone(),
            scene_hash: scene.hash(),
            resolution: 0.0,
            rest_speed: 0.0,
            ulp: settings.precision.ulp(),
        };
        Ok(match settings.precision {
            Precision::F64 => Prepared::<f64>::boxed(scene, provenance, &settings),
            Precision::F32 => Prepared::<f32>::boxed(scene, provenance, &settings),
            Precision::Dd => Prepared::<DoubleDouble>::boxed(scene, provenance, &settings),
            Precision::F256 => Prepared::<Octuple>::boxed(scene, provenance, &settings),
            Precision::Auto => auto::Escalating::boxed(scene, provenance, &settings)?,
        })
    }
}

/// A scene inside the engine, in the scalar `T`.
struct Prepared<'a, T: Real> {
    scene: &'a Scene,
    solver: Solver<'a, T>,
    provenance: Provenance,
    precision: Precision,
    contacts: AtContacts,
}

impl<'a, T: Real> Prepared<'a, T> {
    fn new(scene: &'a Scene, provenance: Provenance, settings: &Settings) -> Self {
        Prepared {
            scene,
            solver: Solver::new(scene)
                .looking_at(settings.partners)
                .at_contacts(settings.contacts),
            contacts: settings.contacts,
            provenance,
            precision: settings.precision,
        }
    }

    fn boxed(scene: &'a Scene, provenance: Provenance, settings: &Settings) -> Box<dyn Run + 'a> {
        Box::new(Prepared::<T>::new(scene, provenance, settings))
    }
}

impl<T: Real> Run for Prepared<'_, T> {
    fn inside(&self) -> Inside {
        let balls = self.solver.balls();
        let (world, states) = (balls.world(), balls.first_states());
        let balls: Vec<Ball> = (0..states.len())
            .map(|i| Ball {
                id: self.scene.balls[i].id.clone(),
                radius: world.radius[i].to_f64(),
                mass: world.mass[i].to_f64(),
                state: states[i],
            })
            .collect();
        // the laws of rotation are those of a uniform solid sphere
        let sphere = |b: &Ball| sphere_inertia(b.mass, b.radius);
        let inertia: Vec<Option<f64>> = balls
            .iter()
            .map(|b| world.rotation.map(|_| sphere(b)))
            .collect();
        Inside {
            energy: balls
                .iter()
                .zip(&inertia)
                .map(|(b, inertia)| kinetic_energy(&b.state, b.mass, *inertia))
                .sum(),
            inertia,
            materials: self.materials(balls.len()),
            balls,
            // what is read back is f64, whatever the scalar
            ulp: T::ULP.max(f64::EPSILON),
            contact_time: None,
        }
    }

    fn sheet(&self) -> Vec<Parameter> {
        self.parameters()
    }

    fn simulate(self: Box<Self>, record: Record, limits: &Limits<'_>) -> Trace {
        let mut trace = self.solver.run(self.provenance, record, limits);
        if let Record::Every(_) = record {
            certainty::certify_run(self.scene, &mut trace, T::ULP, limits);
        }
        trace
    }
}
