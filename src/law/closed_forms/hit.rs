//! Two balls that meet, in components along the line of centres, across it and up.

use super::{Audit, Jump, Part, TOGETHER, left, plan};
use crate::math::Vec3;
use crate::physics::{Contact, Friction};
use crate::scene::Simultaneous;
use nalgebra::Vector2;

/// One ball of a meeting.
#[derive(Clone, Copy)]
struct Party<'a> {
    ball: usize,
    jump: &'a Jump,
    mass: f64,
    radius: f64,
    /// -1 for the ball that is pushed back along the normal, +1 for the one that is pushed on.
    sign: f64,
}

/// What the laws make of the tangential impulse, per reduced mass: along `t`, up, and what both are good to.
struct Rub {
    across: f64,
    up: f64,
    error: f64,
}

/// How two balls come to each other.
struct Meeting<'a> {
    parties: [Party<'a>; 2],
    /// Unit vectors in plan: from the first to the second, and across.
    n: Vector2<f64>,
    t: Vector2<f64>,
    /// Relative speed along the normal and across, length/s.
    closing: f64,
    sliding: f64,
    /// Relative error of a number, and that of a speed of both, length/s.
    grain: f64,
    error: f64,
    /// Restitution and the name of its law.
    e: f64,
    law: &'static str,
    together: bool,
}

impl Audit<'_> {
    /// Two balls met: `balls`, first and second, with both sides of each. `together`: see [`Audit::together`].
    pub(super) fn hit(&mut self, balls: [usize; 2], jumps: [&Jump; 2], together: bool) {
        let party = |i: usize, sign: f64| Party {
            ball: balls[i],
            jump: jumps[i],
            mass: self.scene.balls[balls[i]].mass,
            radius: self.scene.balls[balls[i]].radius,
            sign,
        };
        let parties = [party(0, -1.0), party(1, 1.0)];
        let Some(contact) = self.scene.effects.contact else {
            let words = self.at("no law of contact", &parties);
            return self.fault("hit-told", words);
        };
        let line = plan(&jumps[1].near.position) - plan(&jumps[0].near.position);
        let apart = line.norm();
        self.places(&parties, apart, together);
        if apart == 0.0 {
            return self.leave_out("centres in one place");
        }
        let meeting = self.meeting(parties, contact, line / apart, apart, together);
        if together {
            self.leave_out(TOGETHER);
        } else {
            self.found.impacts += 1;
            self.parts_before(&meeting);
        }
        let Meeting {
            closing,
            sliding,
            e,
            grain,
            ..
        } = meeting;
        let rub = self.rub(&meeting.parties, [sliding, closing, e], grain);
        let (mut sum, mut sum_error) = (Vector2::zeros(), 0.0);
        for party in meeting.parties {
            let (change, allowed) = self.pushed(&meeting, party, &rub);
            sum += change * party.mass;
            sum_error += allowed * party.mass;
        }
        if let Some(off) = self.off(Part::Impact, sum.norm(), sum_error) {
            let words = format!("{}, {off}", self.at("momentum", &meeting.parties));
            self.fault("hit-momentum", words);
        }
    }

    /// `n`: from the first ball to the second; `apart`: distance of their centres, length.
    fn meeting<'b>(
        &self,
        parties: [Party<'b>; 2],
        contact: Contact,
        n: Vector2<f64>,
        apart: f64,
        together: bool,
    ) -> Meeting<'b> {
        let (e, law) = match contact {
            Contact::Elastic {} => (1.0, "contact.elastic"),
            Contact::Inelastic { e } => (e, "contact.inelastic"),
        };
        let near = parties.map(|party| &party.jump.near);
        let [v1, v2] = near.map(|near| plan(&near.velocity));
        let difference = v1 - v2;
        // places that are told with fewer digits than they have turn the normal
        let turned = if self.rounded {
            f64::EPSILON * (near[0].position.norm() + near[1].position.norm()) / apart
        } else {
            0.0
        };
        let grain = self.grain + turned;
        let t = left(n);
        let told = grain * (v1.norm() + v2.norm()) + super::NONE;
        let error = match self.scene.simultaneous {
            // reflects all that touch together, in velocities times the roots of the masses: what rounds that of a heavy ball is more of a light one
            Simultaneous::GeneralizedReflections => told + self.chain(),
            Simultaneous::Refuse | Simultaneous::Ensemble => told,
        };
        Meeting {
            parties,
            closing: difference.dot(&n),
            sliding: difference.dot(&t),
            n,
            t,
            grain,
            error,
            e,
            law,
            together,
        }
    }

    /// Two balls that part do not meet.
    fn parts_before(&mut self, meeting: &Meeting<'_>) {
        let parting = (-meeting.closing).max(0.0);
        if let Some(off) = self.off(Part::Impact, parting, meeting.error) {
            let words = self.at(meeting.law, &meeting.parties);
            self.fault(
                "hit-parting",
                format!("{words}: they part before they meet: {off}"),
            );
        }
    }

    /// What the impulse does to one ball: the change of its velocity and what that is good to, length/s.
    fn pushed(
        &mut self,
        meeting: &Meeting<'_>,
        party: Party<'_>,
        rub: &Rub,
    ) -> (Vector2<f64>, f64) {
        let Meeting {
            parties,
            n,
            t,
            closing,
            grain,
            error,
            e,
            law,
            together,
            ..
        } = meeting;
        let other = parties[usize::from(party.sign < 0.0)];
        // its share of what two masses exchange
        let share = other.mass / (party.mass + other.mass);
        let [near, far] = [&party.jump.near, &party.jump.far].map(|side| plan(&side.velocity));
        let change = far - near;
        // each side is told to its own last digits: much friction leaves a ball that spins faster than it came
        let told = grain * (near.norm() + far.norm());
        let mut allowed = told + (1.0 + e) * share * error;
        let mut across = allowed + share * rub.error;
        if *together {
            // all impulses of an instant between two balls are one: what it leaves may be faster than any ball will be
            let loudest = self.loudest_at(party.ball, party.jump.time);
            allowed = told.max(grain * loudest) + self.chain();
            across = allowed;
        } else {
            let want = party.sign * (1.0 + e) * share * closing;
            let got = change.dot(n);
            if let Some(off) = self.off(Part::Impact, (got - want).abs(), allowed) {
                let words = format!(
                    "{}: the speed along the normal changes by {got:e} instead of {want:e}, {off}",
                    self.at(law, parties)
                );
                self.fault("hit-restitution", words);
            }
        }
        if *together && self.scene.effects.friction.is_some() {
            self.turns_as_pushed(meeting, party, change);
            return (change, allowed);
        }
        let want = party.sign * share * -rub.across;
        let got = change.dot(t);
        if let Some(off) = self.off(Part::Impact, (got - want).abs(), across) {
            let words = format!(
                "{}: the speed across changes by {got:e} instead of {want:e}, {off}",
                self.at(self.friction(), parties)
            );
            self.fault("hit-friction", words);
        }
        let turned = [share * rub.across, share * rub.up];
        self.turns(parties, &party, turned, *t, across);
        (change, allowed + across)
    }

    /// Neither moves while it is hit, and they touch: two spheres on a table whose centres are at different heights.
    fn places(&mut self, parties: &[Party<'_>; 2], apart: f64, together: bool) {
        let touch = 2.0 * parties[0].radius.sqrt() * parties[1].radius.sqrt();
        let gap = apart - touch;
        let mut allowed = self.place;
        if together {
            // a convention closes gaps of a millionth of the smallest radius
            allowed += 1e-6 * self.scene.smallest_radius();
        }
        // how far a step lets balls overlap has its own bound
        let off = if self.step > 0.0 {
            gap.max(0.0)
        } else {
            gap.abs()
        };
        if let Some(off) = self.off(Part::Impact, off, allowed) {
            let words = self.at("place", parties);
            let words = format!("{words}: {apart:e} apart, and they touch at {touch:e}, {off}");
            self.fault("hit-distance", words);
        }
        if parties
            .iter()
            .any(|party| party.jump.far.position != party.jump.near.position)
        {
            let words = self.at("place", parties);
            self.fault(
                "hit-distance",
                format!("{words}: one moves while it is hit"),
            );
        }
    }

    /// Coulomb's impulse against the slip of one surface over the other, no more than ends it: at the contact each of two spheres
    /// yields as 2/7 of its mass would. `[across, closing, e]`: relative speed along `t` and along the normal, restitution.
    fn rub(&self, parties: &[Party<'_>; 2], [across, closing, e]: [f64; 3], grain: f64) -> Rub {
        let none = Rub {
            across: 0.0,
            up: 0.0,
            error: 0.0,
        };
        let Some(friction) = self.scene.effects.friction else {
            return none;
        };
        let [one, two] = parties.map(|party| party.jump.near);
        let n = plan(&two.position) - plan(&one.position);
        let n = n / n.norm();
        let (mut along, mut up, mut turning) = (across, 0.0, 0.0);
        for party in parties {
            let spin = party.jump.near.spin * party.radius;
            along += spin.z;
            up += spin.x * n.y - spin.y * n.x;
            turning += spin.norm();
        }
        let slip = along.hypot(up);
        let speeds = one.velocity.norm() + two.velocity.norm();
        let (mu, steepness) = match friction {
            Friction::Constant { mu } => (mu, 0.0),
            Friction::Alciatore {
                a,
                b,
                c,
                length_in_metres,
            } => {
                let x = c * (slip * length_in_metres);
                (a + b * f64::exp(-x), x)
            }
        };
        let sticks = slip * (2.0 / 7.0);
        let slides = mu * (1.0 + e) * closing.max(0.0);
        let size = sticks.min(slides);
        let error = (2.0 / 7.0) * grain * (speeds + turning) * (1.0 + steepness)
            + sticks.min(mu * (1.0 + e) * grain * speeds);
        if slip == 0.0 {
            return Rub { error, ..none };
        }
        Rub {
            across: -size * (along / slip),
            up: -size * (up / slip),
            error,
        }
    }

    /// The impulse across and up, at the end of the radius, turns both balls the same way.
    fn turns(
        &mut self,
        parties: &[Party<'_>; 2],
        party: &Party<'_>,
        [across, up]: [f64; 2],
        t: Vector2<f64>,
        allowed: f64,
    ) {
        let (near, far) = (&party.jump.near.spin, &party.jump.far.spin);
        let change = (far - near) * party.radius;
        let want = Vec3::new(-2.5 * up * t.x, -2.5 * up * t.y, 2.5 * across);
        let turning = party.radius * (near.norm() + far.norm());
        let allowed = 2.5 * allowed + self.grain * turning;
        if let Some(off) = self.off(Part::Impact, (change - want).norm(), allowed) {
            let words = format!(
                "{}: R times the spin of {} changes by {change:?} instead of {want:?}, {off}",
                self.at(self.friction(), parties),
                self.name(party.ball)
            );
            self.fault("hit-spin", words);
        }
    }

    /// Among several contacts the size of the tangential impulse is that of a convention. Whatever it is, it acts at the end of the radius:
    /// what it changes across turns the ball about the vertical, and what it lifts turns it about the line across, not about the normal.
    fn turns_as_pushed(&mut self, meeting: &Meeting<'_>, party: Party<'_>, change: Vector2<f64>) {
        let Meeting { parties, n, t, .. } = meeting;
        let (near, far) = (&party.jump.near.spin, &party.jump.far.spin);
        let turned = (far - near) * party.radius;
        let want = -2.5 * party.sign * change.dot(t);
        let about = plan(&turned).dot(n);
        let off = (turned.z - want).abs() + about.abs();
        let spinning = party.radius * (near.norm() + far.norm());
        let allowed = 3.5 * self.chain() + self.grain * spinning;
        if let Some(off) = self.off(Part::Impact, off, allowed) {
            let words = format!(
                "{}: R times the spin of {} changes by {turned:?} under {change:?}, {off}",
                self.at(self.friction(), parties),
                self.name(party.ball)
            );
            self.fault("hit-spin", words);
        }
    }

    fn friction(&self) -> &'static str {
        match self.scene.effects.friction {
            None => "no friction between balls",
            Some(Friction::Constant { .. }) => "friction.constant",
            Some(Friction::Alciatore { .. }) => "friction.alciatore",
        }
    }

    /// Law, balls and time.
    fn at(&self, law: &str, parties: &[Party<'_>; 2]) -> String {
        let [a, b] = parties.map(|party| self.name(party.ball));
        format!("{law}: {a} and {b} at {:e} s", parties[0].jump.time)
    }
}
