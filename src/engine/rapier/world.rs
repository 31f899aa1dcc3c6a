//! The equivalent scene inside rapier. Compiled twice, in [`super`] against the f64 crate and against the f32 crate.
//!
//! Balls are dynamic bodies with one ball collider each. The cloth is a half-space below them with the scene's friction,
//! and gravity presses them onto it, so that rapier itself supplies the law of friction; a scene without a cloth has
//! neither, and nothing moves its balls off the plane. A cushion is a vertical half-space at the edge of the table. Balls
//! do not rotate where the scene does not call for it. Friction between balls that depends on their slip speed is the one
//! thing that rapier asks for before each step; loads from outside are set by the stepping loop.

use super::rapier::dynamics::{
    CoefficientCombineRule, FrictionModel, IntegrationParameters, LockedAxes, RigidBody,
    RigidBodyBuilder, RigidBodyHandle, RigidBodySet, SpringCoefficients,
};
use super::rapier::geometry::{
    Collider, ColliderBuilder, ColliderHandle, ContactManifold, ContactPair, Group,
    InteractionGroups, InteractionTestMode, SharedShape,
};
use super::rapier::math::{Real, Vector};
use super::rapier::parry::shape::HalfSpace;
use super::rapier::pipeline::{
    ActiveHooks, ContactModificationContext, PhysicsHooks, PhysicsWorld,
};
use crate::engine::rapier::materials::{self, Coefficient, Material, Rule};
use crate::engine::rapier::settings::{Ccd, Friction, Settings};
use crate::engine::stepped::{Load, Other, Push, World};
use crate::engine::{Inside, PairMaterial, Partner};
use crate::math::{Real as Scalar, Vec3};
use crate::physics::{self, Body, Side, State};
use crate::scene::{Ball, Scene};
use std::cell::Cell;
use std::panic::Location;

/// Collision group of the balls.
const BALLS: Group = Group::GROUP_1;
/// Collision group of everything that does not move.
const TABLE: Group = Group::GROUP_2;

/// What the `user_data` of a half-space says; a ball's is its index.
const CLOTH_TAG: u128 = 1 << 64;
/// The first of four consecutive tags, in the order of [`Side::ALL`].
const CUSHION_TAG: u128 = 1 << 65;

/// The path of a source file of rapier, as the compiler saw it: where rapier turns what it is given into a body.
pub(in crate::engine::rapier) fn compiled_at() -> &'static str {
    struct Witness<'a>(&'a Cell<&'static str>);
    impl From<Witness<'_>> for RigidBody {
        #[track_caller]
        fn from(witness: Witness<'_>) -> RigidBody {
            witness.0.set(Location::caller().file());
            RigidBodyBuilder::fixed().build()
        }
    }
    let place = Cell::new("");
    RigidBodySet::new().insert(Witness(&place));
    place.get()
}

/// A scene inside rapier.
pub(in crate::engine::rapier) struct Billiard {
    world: PhysicsWorld,
    ids: Vec<String>,
    bodies: Vec<RigidBodyHandle>,
    colliders: Vec<ColliderHandle>,
    cloth: Option<ColliderHandle>,
    cushions: Vec<ColliderHandle>,
    rub: Rub,
    /// Which balls slept when the last step began; empty where nothing may sleep.
    slept: Vec<bool>,
}

impl Billiard {
    /// Puts the scene into a new world.
    pub fn new(scene: &Scene, settings: &Settings) -> Self {
        let mut billiard = Billiard {
            world: PhysicsWorld::new(),
            ids: scene.balls.iter().map(|ball| ball.id.clone()).collect(),
            bodies: Vec::new(),
            colliders: Vec::new(),
            cloth: None,
            cushions: Vec::new(),
            rub: Rub::of(scene),
            slept: vec![
                false;
                if settings.can_sleep {
                    scene.balls.len()
                } else {
                    0
                }
            ],
        };
        billiard.world.integration_parameters = parameters(settings);
        billiard.world.gravity = Vector::ZERO;
        if let Some(material) = materials::cloth(&scene.effects) {
            billiard.world.gravity = Vector::new(0.0, 0.0, -lift(scene.gravity));
            billiard.cloth = Some(billiard.lay_cloth(material));
        }
        if let (Some(material), Some(table)) = (materials::cushion(&scene.effects), scene.table) {
            for side in Side::ALL {
                let edges = if side.sign() < 0 {
                    table.min
                } else {
                    table.max
                };
                let cushion = billiard.put_cushion(material, side, edges[side.axis()]);
                billiard.cushions.push(cushion);
            }
        }
        for (index, ball) in scene.balls.iter().enumerate() {
            billiard.put_ball(scene, settings, index, ball);
        }
        billiard
    }

    fn lay_cloth(&mut self, material: Material) -> ColliderHandle {
        let collider = of(half_space(Vector::Z, Vector::ZERO), material).user_data(CLOTH_TAG);
        self.world.insert_collider(collider, None)
    }

    fn put_cushion(&mut self, material: Material, side: Side, edge: f64) -> ColliderHandle {
        let mut inward = [0.0; 3];
        inward[side.axis()] = -lift(f64::from(side.sign()));
        let mut foot = [0.0; 3];
        foot[side.axis()] = lift(edge);
        let collider = half_space(Vector::from(inward), Vector::from(foot));
        let collider = of(collider, material).user_data(CUSHION_TAG + side as u128);
        self.world.insert_collider(collider, None)
    }

    fn put_ball(&mut self, scene: &Scene, settings: &Settings, index: usize, ball: &Ball) {
        let bullet = match settings.ccd {
            Ccd::All => true,
            Ccd::Cue => index == scene.cue_ball(),
            Ccd::Off | Ccd::Auto | Ccd::Fixed => false,
        };
        let mut locked = LockedAxes::empty();
        if !scene.effects.rotates() {
            locked |= LockedAxes::ROTATION_LOCKED;
        }
        let start = scene.start(index);
        let body = RigidBodyBuilder::dynamic()
            .translation(vector(&start.position))
            .linvel(vector(&start.velocity))
            .angvel(vector(&start.spin))
            .locked_axes(locked)
            .can_sleep(settings.can_sleep)
            .ccd_enabled(bullet)
            .soft_ccd_prediction(lift(settings.soft_ccd_prediction))
            .allow_fast_rotation(settings.allow_fast_rotation);
        let met = match scene.effects.contact {
            Some(_) => BALLS | TABLE,
            None => TABLE,
        };
        let collider = ColliderBuilder::ball(lift(ball.radius))
            .mass(lift(ball.mass))
            .collision_groups(InteractionGroups::new(BALLS, met, InteractionTestMode::And))
            .active_hooks(self.rub.hooks())
            .user_data(index as u128);
        let collider = of(collider, materials::ball(&scene.effects));
        let (body, collider) = self.world.insert(body, collider);
        self.world.bodies[body].recompute_mass_properties_from_colliders(&self.world.colliders);
        self.bodies.push(body);
        self.colliders.push(collider);
    }

    /// Gravity, length/s^2, as rapier holds it.
    pub fn gravity(&self) -> f64 {
        -self.world.gravity.z.to_f64()
    }

    /// Materials of every pair of colliders that may meet, equal ones of a ball and a kind of partner only once.
    fn materials(&self) -> Vec<PairMaterial> {
        let mut materials = Vec::new();
        for (ball, handle) in self.colliders.iter().enumerate() {
            let own = &self.world.colliders[*handle];
            let mut meets = |partner, handle: &ColliderHandle| {
                let other = &self.world.colliders[*handle];
                let material = combined(ball, partner, own, other);
                let meet = own.collision_groups().test(other.collision_groups());
                if meet && materials.last() != Some(&material) {
                    materials.push(material);
                }
            };
            let others = self.colliders.iter().filter(|other| *other != handle);
            others.for_each(|other| meets(Partner::Ball, other));
            self.cloth.iter().for_each(|c| meets(Partner::Cloth, c));
            self.cushions
                .iter()
                .for_each(|c| meets(Partner::Cushion, c));
        }
        materials
    }

    fn ball(&self, index: usize) -> Ball {
        let body = &self.world.bodies[self.bodies[index]];
        let collider = &self.world.colliders[self.colliders[index]];
        let named = self.ids.get(collider.user_data as usize);
        Ball {
            id: named.cloned().unwrap_or_default(),
            radius: collider
                .shape()
                .as_ball()
                .map_or(f64::NAN, |shape| shape.radius.to_f64()),
            mass: body.mass().to_f64(),
            state: State {
                position: read(body.translation()),
                velocity: read(body.linvel()),
                spin: read(body.angvel()),
            },
        }
    }

    fn inertia(&self, index: usize) -> Option<f64> {
        let body = &self.world.bodies[self.bodies[index]];
        if body.is_rotation_locked().iter().all(|locked| *locked) {
            return None;
        }
        let inertia = read(body.mass_properties().local_mprops.principal_inertia());
        // a sphere's three are equal; anything else is no sphere
        let sphere = inertia.x == inertia.y && inertia.y == inertia.z;
        Some(if sphere { inertia.x } else { f64::NAN })
    }

    /// Who pushed whom, or `None` for a pair that did nothing in the last step.
    #[inline(never)]
    fn push(&self, pair: &ContactPair) -> Option<Push> {
        let mut on_first = Vec3::zeros();
        for (normal, size) in acting(pair) {
            on_first -= normal * size;
        }
        if on_first == Vec3::zeros() {
            return None;
        }
        let tag = |handle| self.world.colliders.get(handle).map(|c| c.user_data);
        let (first, second) = (tag(pair.collider1)?, tag(pair.collider2)?);
        if self.both_sleep(first, second) {
            return None;
        }
        let side = |tag: u128| Side::ALL.get((tag - CUSHION_TAG) as usize).copied();
        let (ball, other, impulse) = if first >= CUSHION_TAG {
            (second as usize, Other::Cushion(side(first)?), -on_first)
        } else if second >= CUSHION_TAG {
            (first as usize, Other::Cushion(side(second)?), on_first)
        } else if first < second {
            (first as usize, Other::Ball(second as usize), on_first)
        } else {
            (second as usize, Other::Ball(first as usize), -on_first)
        };
        Some(Push {
            ball,
            other,
            impulse,
        })
    }

    fn is_with_cloth(&self, pair: &ContactPair) -> bool {
        let is_cloth = |handle| self.cloth.is_some_and(|cloth| cloth == handle);
        is_cloth(pair.collider1) || is_cloth(pair.collider2)
    }

    /// True when everything that could move in a pair slept through the last step: its impulses are old.
    fn both_sleep(&self, first: u128, second: u128) -> bool {
        let sleeps = |tag: u128| {
            tag >= CLOTH_TAG
                || self.slept.get(tag as usize).is_some_and(|slept| *slept)
                    && self.world.bodies[self.bodies[tag as usize]].is_sleeping()
        };
        sleeps(first) && sleeps(second)
    }
}

impl World for Billiard {
    fn step(&mut self, dt: f64) {
        for (slept, body) in self.slept.iter_mut().zip(&self.bodies) {
            *slept = self.world.bodies[*body].is_sleeping();
        }
        self.world.integration_parameters.dt = lift(dt);
        self.world.step_with_events(&self.rub, &());
    }

    fn load(&mut self, ball: usize, load: &Load) {
        let body = &mut self.world.bodies[self.bodies[ball]];
        body.reset_forces(false);
        body.reset_torques(false);
        if !body.is_sleeping() {
            body.add_force(vector(&load.force), false);
            body.add_torque(vector(&load.torque), false);
        }
    }

    fn remove(&mut self, ball: usize) {
        self.world.bodies[self.bodies[ball]].set_enabled(false);
    }

    fn presses(&self, presses: &mut Vec<f64>) {
        presses.clear();
        presses.resize(self.bodies.len(), 0.0);
        let Some(cloth) = self.cloth else {
            return;
        };
        for pair in self.world.narrow_phase.contact_pairs_with(cloth) {
            let ball = if pair.collider1 == cloth {
                pair.collider2
            } else {
                pair.collider1
            };
            let index = self.world.colliders.get(ball).map(|c| c.user_data as usize);
            if let Some(press) = index.and_then(|index| presses.get_mut(index)) {
                *press = acting(pair).map(|(_, size)| size).sum();
            }
        }
    }

    fn read(&self, states: &mut Vec<State>) {
        states.clear();
        states.extend(self.bodies.iter().map(|handle| {
            let body = &self.world.bodies[*handle];
            State {
                position: read(body.translation()),
                velocity: read(body.linvel()),
                spin: read(body.angvel()),
            }
        }));
    }

    fn pushes(&self, pushes: &mut Vec<Push>) {
        pushes.clear();
        for pair in self.world.narrow_phase.contact_pairs() {
            // most pairs did nothing, or are a ball's with the cloth, which always pushes: they must be cheap to see, and what
            // costs is the way to a manifold in memory
            if !self.is_with_cloth(pair) && pair.solver_manifolds().iter().any(pushed) {
                pushes.extend(self.push(pair));
            }
        }
    }

    fn quarantined(&self) -> Vec<u32> {
        let quarantine = self.world.quarantine();
        let body = |h: &RigidBodyHandle| self.bodies.iter().position(|b| b == h);
        let collider = |h: &ColliderHandle| self.colliders.iter().position(|c| c == h);
        let bodies = quarantine.bodies().iter().filter_map(body);
        let colliders = quarantine.colliders().iter().filter_map(collider);
        bodies.chain(colliders).map(|i| i as u32).collect()
    }

    fn inside(&self) -> Inside {
        let all = 0..self.bodies.len();
        // summed in f64: the sum is ours, the energies are rapier's
        let energy =
            |handle: &RigidBodyHandle| self.world.bodies[*handle].kinetic_energy().to_f64();
        Inside {
            balls: all.clone().map(|i| self.ball(i)).collect(),
            inertia: all.map(|i| self.inertia(i)).collect(),
            energy: self.bodies.iter().map(energy).sum(),
            materials: self.materials(),
            ulp: <Real as Scalar>::ULP,
            contact_time: None,
        }
    }
}

/// rapier's own parameters for these settings.
fn parameters(settings: &Settings) -> IntegrationParameters {
    let spring = |frequency, damping| SpringCoefficients::new(lift(frequency), lift(damping));
    IntegrationParameters {
        dt: lift(settings.dt),
        num_solver_iterations: settings.substeps as usize,
        num_internal_pgs_iterations: settings.internal_iterations as usize,
        num_internal_stabilization_iterations: settings.stabilization_iterations as usize,
        contact_softness: spring(
            settings.contact_natural_frequency,
            settings.contact_damping_ratio,
        ),
        static_contact_softness: spring(
            settings.static_contact_natural_frequency,
            settings.static_contact_damping_ratio,
        ),
        warmstart_coefficient: lift(settings.warmstart_coefficient),
        length_unit: lift(settings.length_unit),
        normalized_allowed_linear_error: lift(settings.allowed_linear_error),
        normalized_max_corrective_velocity: lift(settings.max_corrective_velocity),
        normalized_prediction_distance: lift(settings.prediction_distance),
        normalized_max_linear_velocity: lift(settings.normalized_max_linear_velocity)
            .min(Real::MAX),
        // never more than one: of several, rapier keeps the impulses of the last only, and hits would go unseen
        max_ccd_substeps: match settings.ccd {
            Ccd::Off | Ccd::Auto => 0,
            Ccd::Fixed | Ccd::Cue | Ccd::All => 1,
        },
        contact_clustering: settings.contact_clustering,
        contact_recycling: settings.contact_recycling,
        normalized_contact_recycle_distance: lift(settings.contact_recycle_distance),
        friction_in_bias_pass: settings.friction_in_bias_pass,
        friction_model: match settings.friction_model {
            Friction::Simplified => FrictionModel::Simplified,
            Friction::Coulomb => FrictionModel::Coulomb,
        },
        ..IntegrationParameters::default()
    }
}

/// A fixed half-space that only balls meet, with everything on the side of `normal` left free.
fn half_space(normal: Vector, foot: Vector) -> ColliderBuilder {
    let groups = InteractionGroups::new(TABLE, BALLS, InteractionTestMode::And);
    ColliderBuilder::new(SharedShape::new(HalfSpace::new(normal)))
        .translation(foot)
        .collision_groups(groups)
}

/// A collider of the given material.
fn of(collider: ColliderBuilder, material: Material) -> ColliderBuilder {
    let rule = |coefficient: Coefficient| match coefficient.rule {
        Rule::Average => CoefficientCombineRule::Average,
        Rule::Min => CoefficientCombineRule::Min,
        Rule::Max => CoefficientCombineRule::Max,
    };
    collider
        .friction(lift(material.friction.value))
        .friction_combine_rule(rule(material.friction))
        .restitution(lift(material.restitution.value))
        .restitution_combine_rule(rule(material.restitution))
}

/// Normal and normal impulse of every contact that acted between two colliders in the last step.
fn acting(pair: &ContactPair) -> impl Iterator<Item = (Vec3, f64)> {
    let manifolds = pair.solver_manifolds().iter();
    manifolds.filter(|manifold| acts(manifold)).map(|manifold| {
        let impulses = manifold.points.iter().map(|p| p.data.impulse.to_f64());
        (read(manifold.data.normal), impulses.sum())
    })
}

/// True when a manifold acted in the last step: without a solver contact its impulses are those of an earlier one.
fn acts(manifold: &ContactManifold) -> bool {
    !manifold.data.solver_contacts.is_empty()
}

/// True when a manifold acted in the last step with an impulse.
fn pushed(manifold: &ContactManifold) -> bool {
    acts(manifold) && manifold.points.iter().any(|p| p.data.impulse != 0.0)
}

/// Friction between balls that depends on their slip speed: rapier asks for the coefficient before every step.
struct Rub {
    /// `None` where one number does for every slip speed.
    law: Option<physics::Friction>,
}

impl Rub {
    fn of(scene: &Scene) -> Self {
        let law = scene.effects.friction.filter(|law| match law {
            physics::Friction::Constant { .. } => false,
            physics::Friction::Alciatore { .. } => true,
        });
        Rub { law }
    }

    fn hooks(&self) -> ActiveHooks {
        match self.law {
            Some(_) => ActiveHooks::MODIFY_SOLVER_CONTACTS,
            None => ActiveHooks::empty(),
        }
    }
}

impl PhysicsHooks for Rub {
    fn modify_solver_contacts(&self, context: &mut ContactModificationContext<'_>) {
        let (Some(law), Some(first), Some(second)) =
            (self.law, context.rigid_body1, context.rigid_body2)
        else {
            return;
        };
        let ball = |body: RigidBodyHandle, collider: ColliderHandle| {
            let body = &context.bodies[body];
            let shape = context.colliders[collider].shape().as_ball()?;
            let motion = Body {
                velocity: read(body.linvel()),
                spin: read(body.angvel()),
                mass: body.mass().to_f64(),
                radius: shape.radius.to_f64(),
            };
            Some((read(body.translation()), motion))
        };
        let balls = (
            ball(first, context.collider1),
            ball(second, context.collider2),
        );
        let (Some((from, first)), Some((to, second))) = balls else {
            return;
        };
        let normal = (to - from).normalize();
        let slip = physics::friction::slip_velocity(&first, &second, &normal).norm();
        if let Some(manifold) = context.rigid_mut() {
            *manifold.friction = lift(physics::friction::coefficient(law, slip));
        }
    }
}

/// What rapier makes of the materials of two colliders.
fn combined(ball: usize, partner: Partner, own: &Collider, other: &Collider) -> PairMaterial {
    let friction = CoefficientCombineRule::combine(
        own.friction(),
        other.friction(),
        own.friction_combine_rule(),
        other.friction_combine_rule(),
    );
    let restitution = CoefficientCombineRule::combine(
        own.restitution(),
        other.restitution(),
        own.restitution_combine_rule(),
        other.restitution_combine_rule(),
    );
    PairMaterial {
        ball,
        partner,
        friction: friction.to_f64(),
        restitution: restitution.to_f64(),
    }
}

fn lift(x: f64) -> Real {
    <Real as Scalar>::lift(x)
}

fn vector(v: &Vec3) -> Vector {
    Vector::new(lift(v.x), lift(v.y), lift(v.z))
}

fn read(v: Vector) -> Vec3 {
    Vec3::new(v.x.to_f64(), v.y.to_f64(), v.z.to_f64())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::rapier::settings::Preset;

    /// A rounded default would be a third preset; a default that a release of rapier changes must not slip in unseen.
    #[test]
    fn the_stock_preset_is_rapiers_own_parameters() {
        let own = IntegrationParameters::default();
        assert_eq!(parameters(&Settings::of(Preset::Stock)), own);
        let body = RigidBodyBuilder::dynamic().build();
        let stock = Settings::of(Preset::Stock);
        assert_eq!(body.is_ccd_enabled(), stock.ccd != Ccd::Fixed);
        assert_eq!(body.is_fast_rotation_allowed(), stock.allow_fast_rotation);
        assert_eq!(
            body.soft_ccd_prediction().to_f64(),
            stock.soft_ccd_prediction
        );
        assert_eq!(
            body.activation().normalized_linear_threshold >= 0.0,
            stock.can_sleep
        );
    }

    #[test]
    fn the_converging_preset_has_no_cap_and_no_recycling_in_either_precision() {
        let converging = parameters(&Settings::of(Preset::Converging));
        assert_eq!(converging.normalized_max_linear_velocity, Real::MAX);
        assert_eq!(converging.max_linear_velocity(), Real::MAX);
        assert!(!converging.contact_recycling);
    }
}
