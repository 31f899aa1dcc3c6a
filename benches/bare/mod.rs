//! The report's scenes in rapier and nothing else, set up by hand: what the workbench's own part is measured against.

#![allow(missing_docs, dead_code, clippy::expect_used)]

use carom::math::Vec3;
use carom::physics::{Cloth, Side};
use carom::scene::Scene;
use rapier3d_f64::dynamics::{
    CoefficientCombineRule, IntegrationParameters, LockedAxes, RigidBodyBuilder, RigidBodyHandle,
};
use rapier3d_f64::geometry::{
    ColliderBuilder, Group, InteractionGroups, InteractionTestMode, SharedShape,
};
use rapier3d_f64::math::Vector;
use rapier3d_f64::parry::shape::HalfSpace;
use rapier3d_f64::pipeline::PhysicsWorld;

/// Step of the engine's converging preset, s.
pub const DT: f64 = 1e-3;

/// A scene in rapier and nothing else.
pub struct Bare {
    world: PhysicsWorld,
    balls: Vec<RigidBodyHandle>,
}

impl Bare {
    /// Smooth elastic balls that do not rotate, on the report's cloth, between elastic cushions.
    pub fn new(scene: &Scene) -> Self {
        let mut world = PhysicsWorld::new();
        world.integration_parameters = IntegrationParameters {
            dt: DT,
            contact_recycling: false,
            normalized_max_linear_velocity: f64::MAX,
            max_ccd_substeps: 0,
            ..IntegrationParameters::default()
        };
        world.gravity = Vector::new(0.0, 0.0, -scene.gravity);
        let groups = |of, with| InteractionGroups::new(of, with, InteractionTestMode::And);
        let (balls, table) = (Group::GROUP_1, Group::GROUP_2);
        let mut wall = |normal: Vector, foot: Vector, friction, restitution, rule| {
            let collider = ColliderBuilder::new(SharedShape::new(HalfSpace::new(normal)))
                .translation(foot)
                .collision_groups(groups(table, balls))
                .friction(friction)
                .friction_combine_rule(rule)
                .restitution(restitution);
            let combine = if restitution < 1.0 {
                CoefficientCombineRule::Min
            } else {
                CoefficientCombineRule::Max
            };
            world.insert_collider(collider.restitution_combine_rule(combine), None);
        };
        let Some(Cloth::Translational { mu }) = scene.effects.cloth else {
            unreachable!("the report's cloth")
        };
        wall(
            Vector::Z,
            Vector::ZERO,
            mu,
            0.0,
            CoefficientCombineRule::Max,
        );
        let edges = scene.table.expect("a table");
        for side in Side::ALL {
            let at = if side.sign() < 0 {
                edges.min
            } else {
                edges.max
            };
            let (mut inward, mut foot) = ([0.0; 3], [0.0; 3]);
            inward[side.axis()] = -f64::from(side.sign());
            foot[side.axis()] = at[side.axis()];
            let rule = CoefficientCombineRule::Min;
            wall(inward.into(), foot.into(), 0.0, 1.0, rule);
        }
        let vector = |v: &Vec3| Vector::new(v.x, v.y, v.z);
        let mut bodies = Vec::new();
        for ball in &scene.balls {
            let body = RigidBodyBuilder::dynamic()
                .translation(vector(&ball.state.position))
                .linvel(vector(&ball.state.velocity))
                .locked_axes(LockedAxes::ROTATION_LOCKED)
                .can_sleep(false)
                .allow_fast_rotation(true);
            let collider = ColliderBuilder::ball(ball.radius)
                .mass(ball.mass)
                .collision_groups(groups(balls, balls | table))
                .friction(0.0)
                .friction_combine_rule(CoefficientCombineRule::Average)
                .restitution(1.0)
                .restitution_combine_rule(CoefficientCombineRule::Min);
            let (body, _) = world.insert(body, collider);
            world.bodies[body].recompute_mass_properties_from_colliders(&world.colliders);
            bodies.push(body);
        }
        Bare {
            world,
            balls: bodies,
        }
    }

    /// Positions after so many steps. Takes itself apart, as a run of an engine does.
    pub fn run(mut self, steps: u64) -> Vec<[f64; 3]> {
        for _ in 0..steps {
            self.world.step();
        }
        let at = |ball: &RigidBodyHandle| self.world.bodies[*ball].translation().into();
        self.balls.iter().map(at).collect()
    }
}
