//! A run that is held, and what its trace says of the scheme that made it. The only place of this room where work counters are read.

use crate::math::worse;
use crate::scene::{Scene, Simultaneous};
use crate::trace::{Contacts, Counter, Trace, UNEXPLAINED_IN_CONTACT};

/// A run that is held.
#[derive(Clone, Copy, Debug)]
pub struct Run<'a> {
    /// What was simulated.
    pub scene: &'a Scene,
    /// What came of it.
    pub trace: &'a Trace,
    /// Spacing of the engine's numbers just above 1.
    pub ulp: f64,
    /// True where the knots of events were kept, false where the trace has only both ends.
    pub events: bool,
}

impl<'a> Run<'a> {
    /// A run in f64 with its events.
    pub fn of(scene: &'a Scene, trace: &'a Trace) -> Self {
        Run {
            scene,
            trace,
            ulp: f64::EPSILON,
            events: true,
        }
    }

    /// Length of a step, s; 0 for an engine that solves for its events.
    pub fn step(&self) -> f64 {
        self.trace.provenance.resolution
    }

    /// How often an impact may have rounded: exchanges where they are counted, else events, and one more for the motion between them.
    pub fn impacts(&self) -> f64 {
        let exchanges = self.trace.count(Counter::Exchanges).unwrap_or(0);
        exchanges.max(self.trace.events.len() as u64) as f64 + 1.0
    }

    /// In how many parts of a step a contact is solved; 1 for an engine that does not divide its steps.
    pub fn substeps(&self) -> f64 {
        let substeps = match (
            self.trace.count(Counter::Substeps),
            self.trace.count(Counter::Steps),
        ) {
            (Some(substeps), Some(steps)) if steps > 0 => (substeps / steps).max(1),
            _ => 1,
        };
        substeps as f64
    }

    /// Most steps for which a pair stayed in contact; 1 where nobody counted.
    pub fn contact_steps(&self) -> f64 {
        let counted = self.trace.count(Counter::LongestOverlap);
        counted.map_or(1.0, |steps| steps.max(1) as f64)
    }

    /// The largest speed that was seen, length/s; the largest possible one where only the ends were.
    pub fn fastest(&self) -> f64 {
        if !self.events {
            return self.scene.fastest();
        }
        self.trace.fastest()
    }

    /// The same of one ball.
    fn fastest_of(&self, ball: usize) -> f64 {
        if !self.events {
            return self.scene.fastest();
        }
        self.trace.paths[ball].fastest()
    }

    /// What the position of a ball is good to up to `time`, s; length.
    ///
    /// [`Scene::position_uncertainty_within`] with the spacing of the engine's numbers, and the largest coordinate of scene and trace, heights
    /// included; and what is closed where contacts begin.
    pub fn rounding(&self, time: f64) -> f64 {
        let knots = self.trace.paths.iter().flat_map(|path| &path.knots);
        let extent = knots.fold(self.scene.largest_coordinate(), |largest, knot| {
            worse(largest, knot.state.position.amax())
        });
        let coarser = 8.0 * (self.ulp - f64::EPSILON) * (extent + self.scene.fastest() * time);
        self.scene.position_uncertainty_within(extent, time) + coarser + self.closed()
    }

    /// How far balls are moved where a contact begins, length: a gap that counts as none is closed, and in a row of balls those add up. What an approach that
    /// is nothing leaves of a gap is no more than a few times what counts as touching, or what rounding leaves open of the places that balls can get to.
    pub fn closed(&self) -> f64 {
        const LEFT: f64 = 4.0;
        if self.trace.follows_contacts() {
            // four roundings of a coordinate
            let blur = 4.0 * f64::EPSILON * self.scene.farthest_coordinate();
            LEFT * self.scene.touching().max(blur) * self.scene.balls.len() as f64
        } else {
            0.0
        }
    }

    /// How far rounding and a step carry balls: computed once for the bounds that are made of it.
    pub fn reach(&self) -> Reach {
        let step = (0..self.trace.paths.len()).map(|ball| self.fastest_of(ball) * self.step());
        let contacts = Contacts::of(self.trace);
        let balls = self.scene.balls.iter().enumerate();
        let contact = balls.map(|(ball, b)| {
            let ever = contacts.during(ball, [0.0, f64::INFINITY]);
            if ever {
                UNEXPLAINED_IN_CONTACT * b.radius
            } else {
                0.0
            }
        });
        Reach {
            rounding: self.rounding(self.trace.end_time),
            step: step.collect(),
            contact: contact.collect(),
        }
    }
}

/// By how much a convention of simultaneous impacts amplifies rounding: it reflects velocities times the roots of the masses, so that what rounds the speed of
/// the heaviest ball is that much more of the lightest.
pub fn amplified(scene: &Scene) -> f64 {
    match scene.simultaneous {
        Simultaneous::GeneralizedReflections => scene.mass_ratio().sqrt(),
        Simultaneous::Refuse | Simultaneous::Ensemble => 1.0,
    }
}

/// How far rounding and a step carry balls.
#[derive(Clone, Debug, PartialEq)]
pub struct Reach {
    /// What the position of a ball is good to at the end of the run, length.
    pub rounding: f64,
    /// Largest speed of each ball times the step, length.
    pub step: Vec<f64>,
    /// How far each ball may drift while it is held in contact, length; 0 for one that never is.
    pub contact: Vec<f64>,
}

impl Reach {
    /// Part by which a bound may be missed because it is itself rounded.
    const ROUNDED: f64 = 1e-9;

    /// Rounding and so much more, length.
    pub fn and(&self, more: f64) -> f64 {
        (self.rounding + more) * (1.0 + Reach::ROUNDED)
    }
}
