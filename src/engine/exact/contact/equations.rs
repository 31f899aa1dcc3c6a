//! The equations of a group, written on a tape.

use super::group::{Change, Group, Member, Mode, Touch, Twist, loudest};
use crate::engine::exact::flight::Ground;
use crate::engine::exact::spin::Moving;
use crate::engine::exact::world::World;
use crate::math::Real;
use crate::math::series::{Node, Tape};
use crate::physics::Friction;

/// A quantity that is positive until something changes.
#[derive(Clone, Copy, Debug)]
pub struct Monitor {
    /// What happens when it reaches zero.
    pub change: Change,
    /// The quantity.
    pub node: Node,
}

/// The equations of a group on a tape.
#[derive(Debug)]
pub struct Equations<T> {
    /// The tape.
    pub tape: Tape<T>,
    /// Centre of each member.
    pub position: Vec<[Node; 2]>,
    /// Velocity of each member.
    pub velocity: Vec<[Node; 2]>,
    /// Spin of each member.
    pub spin: Vec<[Node; 3]>,
    /// Acceleration of the gap of each contact without force.
    pub opening: Vec<Option<Node>>,
    /// The part of the contacts' push per mass that counts for rolling, of each member.
    pub pushed: Vec<[Node; 2]>,
    /// What the cloth must give beyond the loss of rolling, per mass, for a rolling member to roll on.
    pub gripping: Vec<[Node; 2]>,
    /// Rate of each member's spin about the vertical by its contacts.
    pub couple: Vec<Node>,
    /// What is watched.
    pub monitors: Vec<Monitor>,
}

/// What one unit of a contact's force does to one member.
#[derive(Clone, Copy)]
struct Response {
    /// Acceleration of its centre.
    acceleration: [Node; 2],
    /// What that would be if it did not rest.
    loose: [Node; 2],
    /// The part of the force per mass that counts for rolling.
    rolling: [Node; 2],
    /// Force per mass.
    push: [Node; 2],
    /// Rate of its spin.
    turning: [Node; 3],
}

/// What a contact does for each unit of its force.
struct Contact {
    /// From the first to the second, or outward.
    normal: [Node; 2],
    /// On its members, in the order of [`Touch::members`].
    responses: Vec<(usize, f64, Response)>,
    /// Relative velocity squared, tangential, over the distance: what curvature adds to the opening of the gap.
    curvature: Option<Node>,
}

/// Writes equations.
struct Writer<'a, T: Real> {
    world: &'a World<T>,
    group: &'a Group<T>,
    tape: Tape<T>,
    zero: Node,
    position: Vec<[Node; 2]>,
    velocity: Vec<[Node; 2]>,
    spin: Vec<[Node; 3]>,
    /// What the cloth alone makes of each member's centre.
    cloth: Vec<[Node; 2]>,
    /// And of its spin.
    cloth_turn: Vec<[Node; 3]>,
    monitors: Vec<Monitor>,
}

impl<T: Real> Group<T> {
    /// The equations of motion.
    pub fn equations(&self, world: &World<T>) -> Equations<T> {
        let mut writer = Writer::new(world, self);
        let contacts = writer.contacts();
        let force = writer.forces(&contacts);
        writer.finish(&contacts, force)
    }

    /// The linear system of all contacts at the start.
    pub fn system(&self, world: &World<T>) -> System<T> {
        let mut writer = Writer::new(world, self);
        let contacts = writer.contacts();
        let n = contacts.len();
        let mut matrix = |of: Part| -> Vec<Vec<T>> {
            let row = |k: usize| {
                let entries = (0..n).map(|l| {
                    let node = writer.coupling(&contacts, k, l, of);
                    writer.tape.value(node)
                });
                entries.collect()
            };
            (0..n).map(row).collect()
        };
        let moving = matrix(|response| response.acceleration);
        let loose = matrix(|response| response.loose);
        let free = (0..n).map(|k| {
            let node = writer.free_opening(&contacts[k], self.holds[k].touch);
            writer.tape.value(node)
        });
        System {
            moving,
            free: free.collect(),
            loose,
        }
    }

    /// Whether all members of a contact rest: its force moves nobody, and holds them against what pushes them.
    pub fn rests(&self, touch: Touch) -> bool {
        let mut members = touch.members();
        members.all(|(member, _)| self.members[member].mode == Mode::Rests)
    }
}

/// What one unit of force does to a member, one part of it.
type Part = fn(&Response) -> [Node; 2];

/// What the forces of contacts do to the accelerations of their gaps.
#[derive(Debug)]
pub struct System<T> {
    /// What each force does to the acceleration of each gap.
    pub moving: Vec<Vec<T>>,
    /// The accelerations without forces.
    pub free: Vec<T>,
    /// What each force would do if nobody rested.
    pub loose: Vec<Vec<T>>,
}

impl<'a, T: Real> Writer<'a, T> {
    fn new(world: &'a World<T>, group: &'a Group<T>) -> Self {
        let mut tape = Tape::new();
        let zero = tape.constant(T::zero());
        let mut writer = Writer {
            world,
            group,
            tape,
            zero,
            position: Vec::new(),
            velocity: Vec::new(),
            spin: Vec::new(),
            cloth: Vec::new(),
            cloth_turn: Vec::new(),
            monitors: Vec::new(),
        };
        for i in 0..group.members.len() {
            writer.member(i);
        }
        writer
    }

    fn dot(&mut self, a: &[Node], b: &[Node]) -> Node {
        let mut sum = self.tape.product(a[0], b[0]);
        for (x, y) in a.iter().zip(b).skip(1) {
            let product = self.tape.product(*x, *y);
            sum = self.tape.sum(sum, product);
        }
        sum
    }

    fn norm(&mut self, a: &[Node]) -> Node {
        let square = self.dot(a, a);
        self.tape.root(square)
    }

    /// A bound squared less the square of a vector.
    fn room(&mut self, bound: T, a: &[Node]) -> Node {
        let most = self.tape.constant(bound * bound);
        let square = self.dot(a, a);
        self.tape.difference(most, square)
    }

    /// The inputs of a member, and what the cloth alone does to it.
    fn member(&mut self, i: usize) {
        let member = self.group.members[i];
        let radius = self.world.radius[member.ball];
        let Moving {
            position,
            velocity,
            spin,
        } = member.moving;
        let position = match member.mode {
            Mode::Rests => position.map(|x| self.tape.constant(x)),
            _ => position.map(|x| self.tape.input(x)),
        };
        let velocity = match member.mode {
            Mode::Rests => [self.zero; 2],
            _ => velocity.map(|x| self.tape.input(x)),
        };
        let vertical = match member.twist {
            Twist::Held => self.zero,
            Twist::Falls(_) | Twist::Free => self.tape.input(spin[2]),
        };
        let spin = match member.mode {
            Mode::Rolls => [
                self.tape.multiple(velocity[1], -(T::one() / radius)),
                self.tape.multiple(velocity[0], T::one() / radius),
                vertical,
            ],
            Mode::Slides | Mode::Floats => {
                [self.tape.input(spin[0]), self.tape.input(spin[1]), vertical]
            }
            Mode::Rests | Mode::Drags => [self.zero, self.zero, vertical],
        };
        let (cloth, turn) = self.cloth(i, member, velocity, spin, radius);
        self.position.push(position);
        self.velocity.push(velocity);
        self.spin.push(spin);
        self.cloth.push(cloth);
        self.cloth_turn.push(turn);
    }

    /// Acceleration of a member's centre and rate of its spin by the cloth.
    fn cloth(
        &mut self,
        i: usize,
        member: Member<T>,
        velocity: [Node; 2],
        spin: [Node; 3],
        radius: T,
    ) -> ([Node; 2], [Node; 3]) {
        let mut turn = [self.zero; 3];
        let rotation = self.world.rotation;
        let turning = T::lift(2.5) / radius;
        if let (Twist::Falls(positive), Some(rotation)) = (member.twist, rotation) {
            let rate = turning * rotation.spin;
            turn[2] = self.tape.constant(if positive { -rate } else { rate });
            let sign = if positive { T::one() } else { -T::one() };
            let node = self.tape.multiple(spin[2], sign);
            self.watch(Change::Unspun(i), node);
        }
        let along = |writer: &mut Self, way: [Node; 2], size: Node, deceleration: T| {
            way.map(|part| {
                let unit = writer.tape.quotient(part, size);
                writer.tape.multiple(unit, -deceleration)
            })
        };
        let cloth = match (member.mode, rotation) {
            (Mode::Slides, Some(rotation)) => {
                // u = v + R z x w
                let (back, forth) = (
                    self.tape.multiple(spin[1], radius),
                    self.tape.multiple(spin[0], radius),
                );
                let slip = [
                    self.tape.difference(velocity[0], back),
                    self.tape.sum(velocity[1], forth),
                ];
                let size = self.norm(&slip);
                self.watch(Change::Rolls(i), size);
                let push = along(self, slip, size, rotation.slide);
                turn[0] = self.tape.multiple(push[1], turning);
                turn[1] = self.tape.multiple(push[0], -turning);
                push
            }
            (Mode::Rolls, Some(rotation)) => {
                let size = self.norm(&velocity);
                self.watch(Change::Stops(i), size);
                along(self, velocity, size, rotation.roll)
            }
            (Mode::Drags, _) => match self.world.ground {
                Ground::Coulomb(deceleration) => {
                    let size = self.norm(&velocity);
                    self.watch(Change::Stops(i), size);
                    along(self, velocity, size, deceleration)
                }
                Ground::Frictionless => [self.zero; 2],
            },
            _ => [self.zero; 2],
        };
        (cloth, turn)
    }

    fn watch(&mut self, change: Change, node: Node) {
        self.monitors.push(Monitor { change, node });
    }

    /// What every contact of the group does for each unit of its force.
    fn contacts(&mut self) -> Vec<Contact> {
        let holds = self.group.holds.iter();
        holds.map(|hold| self.contact(hold.touch)).collect()
    }

    /// What a contact does for each unit of its force.
    fn contact(&mut self, touch: Touch) -> Contact {
        match touch {
            Touch::Pair(a, b) => self.pair(touch, a, b),
            Touch::Cushion(_, side) => {
                let mut outward = [self.zero; 2];
                let sign = T::lift(f64::from(side.sign()));
                outward[side.axis()] = self.tape.constant(sign);
                let responses = self.responses(touch, outward, None);
                Contact {
                    normal: outward,
                    responses,
                    curvature: None,
                }
            }
        }
    }

    fn pair(&mut self, touch: Touch, a: usize, b: usize) -> Contact {
        let between = |writer: &mut Self, of: fn(&Self) -> &Vec<[Node; 2]>| {
            let (first, second) = (of(writer)[a], of(writer)[b]);
            [0, 1].map(|axis| writer.tape.difference(second[axis], first[axis]))
        };
        let apart = between(self, |writer| &writer.position);
        let motion = between(self, |writer| &writer.velocity);
        let distance = self.norm(&apart);
        let normal = apart.map(|part| self.tape.quotient(part, distance));
        let closing = self.dot(&motion, &normal);
        let across = [0, 1].map(|axis| {
            let along = self.tape.product(closing, normal[axis]);
            self.tape.difference(motion[axis], along)
        });
        let square = self.dot(&across, &across);
        let curvature = self.tape.quotient(square, distance);
        let rub = self.rub(a, b, normal, across);
        let responses = self.responses(touch, normal, rub);
        Contact {
            normal,
            responses,
            curvature: Some(curvature),
        }
    }

    /// `mu s/|s|`, s the slip of the first ball's surface over the second's; `None` where they do not rub. Where nothing slips there is no
    /// direction to rub in: that friction could hold the two together is not built.
    fn rub(
        &mut self,
        a: usize,
        b: usize,
        normal: [Node; 2],
        across: [Node; 2],
    ) -> Option<[Node; 3]> {
        let law = self.world.friction?;
        self.world.rotation?;
        // R1 w1 + R2 w2
        let turning = [0, 1, 2].map(|axis| {
            let of = |member: usize| self.world.radius[self.group.members[member].ball];
            let (first, second) = (of(a), of(b));
            let one = self.tape.multiple(self.spin[a][axis], first);
            let other = self.tape.multiple(self.spin[b][axis], second);
            self.tape.sum(one, other)
        });
        let sideways = [
            self.tape.product(turning[2], normal[1]),
            self.tape.product(turning[2], normal[0]),
        ];
        let (up, down) = (
            self.tape.product(turning[0], normal[1]),
            self.tape.product(turning[1], normal[0]),
        );
        // second minus first, turned round: the slip is that of the first over the second
        let slip = [
            {
                let sum = self.tape.sum(across[0], sideways[0]);
                self.tape.multiple(sum, -T::one())
            },
            self.tape.difference(sideways[1], across[1]),
            self.tape.difference(up, down),
        ];
        let square = self.dot(&slip, &slip);
        let still = self.world.over(loudest(self.world, &self.group.members));
        if self.tape.value(square) <= still * still {
            return None;
        }
        let size = self.tape.root(square);
        let coefficient = match law {
            Friction::Constant { mu } => self.tape.constant(mu),
            Friction::Alciatore {
                a,
                b,
                c,
                length_in_metres,
            } => {
                let fall = self.tape.multiple(size, -(c * T::lift(length_in_metres)));
                let power = self.tape.exponential(fall);
                let above = self.tape.multiple(power, b);
                let least = self.tape.constant(a);
                self.tape.sum(least, above)
            }
        };
        let part = self.tape.quotient(coefficient, size);
        Some(slip.map(|x| self.tape.product(x, part)))
    }

    /// What one unit of force does to each member of a contact.
    fn responses(
        &mut self,
        touch: Touch,
        normal: [Node; 2],
        rub: Option<[Node; 3]>,
    ) -> Vec<(usize, f64, Response)> {
        let seven = T::lift(5.0) / T::lift(7.0);
        // n x F of the friction, the same for both balls, per radius
        let couple = rub.map(|rub| {
            let up = self.tape.product(normal[1], rub[2]);
            let side = self.tape.product(normal[0], rub[2]);
            let (one, other) = (
                self.tape.product(normal[0], rub[1]),
                self.tape.product(normal[1], rub[0]),
            );
            [
                self.tape.multiple(up, -T::one()),
                side,
                self.tape.difference(other, one),
            ]
        });
        let mut found = Vec::new();
        for (member, sign) in touch.members() {
            let Member { ball, mode, .. } = self.group.members[member];
            let (mass, radius) = (self.world.mass[ball], self.world.radius[ball]);
            let each = T::one() / mass;
            let push = [0, 1].map(|axis| {
                let along = match rub {
                    None => normal[axis],
                    Some(rub) => self.tape.sum(normal[axis], rub[axis]),
                };
                self.tape.multiple(along, T::lift(sign) * each)
            });
            let rolling = match couple {
                None => push,
                Some(couple) => {
                    let (x, y) = (
                        self.tape.multiple(couple[1], each),
                        self.tape.multiple(couple[0], -each),
                    );
                    [self.tape.sum(push[0], x), self.tape.sum(push[1], y)]
                }
            };
            let rolls = self.world.rotation.is_some() && mode == Mode::Rests;
            let loose = if mode == Mode::Rolls || rolls {
                rolling.map(|x| self.tape.multiple(x, seven))
            } else {
                push
            };
            let acceleration = match mode {
                Mode::Rests => [self.zero; 2],
                _ => loose,
            };
            let turn = T::lift(2.5) * each / radius;
            let turning = match couple {
                None => [self.zero; 3],
                Some(couple) => couple.map(|x| self.tape.multiple(x, turn)),
            };
            let response = Response {
                acceleration,
                loose,
                rolling,
                push,
                turning,
            };
            found.push((member, sign, response));
        }
        found
    }

    /// What one unit of the force of contact `l` adds to the acceleration of the gap of contact `k`, by one part of its responses.
    fn coupling(&mut self, contacts: &[Contact], k: usize, l: usize, of: Part) -> Node {
        let mut sum = self.zero;
        let normal = contacts[k].normal;
        let own: Vec<(usize, f64)> = contacts[k].responses.iter().map(|r| (r.0, r.1)).collect();
        for (member, sign) in own {
            let theirs = contacts[l].responses.iter().find(|r| r.0 == member);
            if let Some((_, _, response)) = theirs {
                let part = self.dot(&normal, &of(response));
                let signed = self.tape.multiple(part, T::lift(sign));
                sum = self.tape.sum(sum, signed);
            }
        }
        sum
    }

    /// Acceleration of a gap without the forces of contacts.
    fn free_opening(&mut self, contact: &Contact, touch: Touch) -> Node {
        let mut sum = contact.curvature.unwrap_or(self.zero);
        for (member, sign) in touch.members() {
            let cloth = self.cloth[member];
            let part = self.dot(&contact.normal, &cloth);
            let signed = self.tape.multiple(part, T::lift(sign));
            sum = self.tape.sum(sum, signed);
        }
        sum
    }

    /// The forces of the pressed contacts: those that move somebody, then those that hold who rests against them.
    fn forces(&mut self, contacts: &[Contact]) -> Vec<Option<Node>> {
        let mut force = vec![None; contacts.len()];
        for rest in [false, true] {
            let pressed = self.group.pressed().into_iter();
            let pressed = pressed.filter(|k| self.group.rests(self.group.holds[*k].touch) == rest);
            let pressed: Vec<usize> = pressed.collect();
            let of: Part = if rest {
                |response| response.loose
            } else {
                |response| response.acceleration
            };
            let mut rows: Vec<Vec<Node>> = Vec::new();
            let mut closing = Vec::new();
            for k in &pressed {
                let row = pressed.iter();
                let row = row.map(|l| self.coupling(contacts, *k, *l, of));
                rows.push(row.collect());
                let free = self.opening(contacts, &force, *k);
                closing.push(self.tape.multiple(free, -T::one()));
            }
            for (k, node) in pressed.iter().zip(self.tape.solution(&rows, &closing)) {
                force[*k] = Some(node);
            }
        }
        force
    }

    /// The rates of everything, and what is watched.
    fn finish(mut self, contacts: &[Contact], force: Vec<Option<Node>>) -> Equations<T> {
        let members = self.group.members.len();
        let mut acceleration = self.cloth.clone();
        let mut turn = self.cloth_turn.clone();
        let mut push = vec![[self.zero; 2]; members];
        let mut rolling = push.clone();
        let mut couple = vec![self.zero; members];
        let mut gripping = push.clone();
        for (contact, force) in contacts.iter().zip(&force) {
            let Some(force) = *force else { continue };
            for (member, _, response) in &contact.responses {
                let mut add = |to: &mut Node, unit: Node| {
                    let part = self.tape.product(force, unit);
                    *to = self.tape.sum(*to, part);
                };
                for axis in 0..2 {
                    add(
                        &mut acceleration[*member][axis],
                        response.acceleration[axis],
                    );
                    add(&mut push[*member][axis], response.push[axis]);
                    add(&mut rolling[*member][axis], response.rolling[axis]);
                    add(&mut turn[*member][axis], response.turning[axis]);
                }
                add(&mut turn[*member][2], response.turning[2]);
                add(&mut couple[*member], response.turning[2]);
            }
        }
        for i in 0..members {
            let Member {
                ball, mode, twist, ..
            } = self.group.members[i];
            for axis in 0..2 {
                if mode != Mode::Rests {
                    self.tape
                        .derive(self.position[i][axis], self.velocity[i][axis]);
                    self.tape
                        .derive(self.velocity[i][axis], acceleration[i][axis]);
                }
                if matches!(mode, Mode::Slides | Mode::Floats) {
                    self.tape.derive(self.spin[i][axis], turn[i][axis]);
                }
            }
            if twist != Twist::Held {
                self.tape.derive(self.spin[i][2], turn[i][2]);
            }
            gripping[i] = self.limits(i, acceleration[i], push[i], rolling[i], couple[i], ball);
        }
        let mut opening = vec![None; contacts.len()];
        for k in 0..contacts.len() {
            match force[k] {
                Some(node) => self.watch(Change::Released(k), node),
                None => {
                    let node = self.opening(contacts, &force, k);
                    // far above what is rounding of an opening that stays zero
                    let room = self
                        .tape
                        .constant(T::lift(T::ULP.sqrt()) * self.group.at_work(self.world));
                    let presses = self.tape.sum(room, node);
                    let opens = self.tape.difference(room, node);
                    self.watch(Change::Presses(k), presses);
                    // who rests stays, whichever way the gap would go
                    if !self.group.rests(self.group.holds[k].touch) {
                        self.watch(Change::Opens(k), opens);
                        opening[k] = Some(node);
                    }
                }
            }
        }
        Equations {
            tape: self.tape,
            position: self.position,
            velocity: self.velocity,
            spin: self.spin,
            opening,
            pushed: rolling,
            gripping,
            couple,
            monitors: self.monitors,
        }
    }

    /// Acceleration of the gap of a contact by the forces that are known; where all rest, what it would be.
    fn opening(&mut self, contacts: &[Contact], force: &[Option<Node>], k: usize) -> Node {
        let touch = self.group.holds[k].touch;
        let of: Part = if self.group.rests(touch) {
            |response| response.loose
        } else {
            |response| response.acceleration
        };
        let mut sum = self.free_opening(&contacts[k], touch);
        for (l, force) in force.iter().enumerate() {
            if let Some(force) = *force {
                let coupling = self.coupling(contacts, k, l, of);
                let part = self.tape.product(coupling, force);
                sum = self.tape.sum(sum, part);
            }
        }
        sum
    }

    /// Watches the thresholds of a member: grip of a rolling ball, one at rest, spin that is held. Answers what grip a rolling one needs.
    fn limits(
        &mut self,
        i: usize,
        acceleration: [Node; 2],
        push: [Node; 2],
        rolling: [Node; 2],
        couple: Node,
        ball: usize,
    ) -> [Node; 2] {
        let none = [self.zero; 2];
        let Member { mode, twist, .. } = self.group.members[i];
        let Some(rotation) = self.world.rotation else {
            if let (Mode::Rests, Ground::Coulomb(deceleration)) = (mode, self.world.ground) {
                let room = self.room(deceleration, &push);
                self.watch(Change::Breaks(i), room);
            }
            return none;
        };
        let mut gripping = none;
        if mode == Mode::Rolls {
            // what the cloth gives is the acceleration less the loss of rolling and the push of the contacts
            let cloth = self.cloth[i];
            gripping = [0, 1].map(|axis| {
                let own = self.tape.difference(acceleration[axis], cloth[axis]);
                self.tape.difference(own, push[axis])
            });
            let room = self.room(rotation.slide, &gripping);
            self.watch(Change::Slips(i), room);
        }
        if mode == Mode::Rests && rotation.slide > T::zero() {
            let most = rotation.roll * T::lift(7.0) / T::lift(5.0);
            let room = self.room(most, &rolling);
            self.watch(Change::Breaks(i), room);
        }
        if twist == Twist::Held {
            let most = T::lift(2.5) * rotation.spin / self.world.radius[ball];
            let room = self.room(most, &[couple]);
            self.watch(Change::Twists(i), room);
        }
        gripping
    }
}
