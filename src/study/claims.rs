//! The audit of the report's claims: each computed on the spot, none remembered.
//!
//! The claims are those of the student report that the stepper re-creates. Every line says what the report says, what
//! comes out when it is computed, and with which runs.

use super::matrix::{self, Configuration, Timing, Watch};
use crate::compare::largest_distance_at_end;
use crate::engine::{Roster, Setting};
use crate::math::Vec3;
use crate::physics::cloth::translational::{stop_distance, stop_time};
use crate::scene::{Scene, SceneError, Shot, catalogue};
use crate::trace::{Record, Trace};

/// Metres in a foot.
const FOOT: f64 = 0.3048;
/// The report scales feet by this.
const REPORT_SCALE: f64 = 2.5;
/// Mass of a pool ball, kg: 6 ounces.
const BALL_OF_SIX_OUNCES: f64 = 0.170097;
/// Rolling resistance of cloth (Alciatore: .005 to .015).
const MU_ROLL: f64 = 0.01;

/// One claim of the report, computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Claim {
    /// Kebab-case name.
    pub id: &'static str,
    /// What the report says or does.
    pub says: &'static str,
    /// What comes out, in one sentence with the computed numbers.
    pub found: String,
    /// The computed numbers: what, value, unit.
    pub numbers: Vec<(String, f64, String)>,
    /// How it was computed.
    pub how: String,
}

impl Claim {
    /// The number whose description is `what`.
    pub fn number(&self, what: &str) -> Option<f64> {
        self.numbers
            .iter()
            .find(|(name, _, _)| name == what)
            .map(|&(_, value, _)| value)
    }
}

/// Computes every claim, the most consequential first.
pub fn audit(roster: &Roster, watch: Watch<'_>) -> Result<Vec<Claim>, SceneError> {
    let shot = catalogue::scene("report-break")?;
    let lab = Lab { roster, watch };
    Ok(vec![
        lab.launch_depends_on_the_step(&shot),
        lab.units_are_mixed(&shot),
        lab.sliding_all_the_way(&shot),
        lab.plain_overlap_sticks(
            &catalogue::scene("report-break-tight")?,
            &catalogue::scene("report-break-tight-mirrored")?,
        ),
        lab.table_is_not_a_pool_table(&shot),
        lab.mass_drops_out(&shot),
        lab.first_order(&catalogue::scene("slide")?),
    ])
}

/// Where the claims are put to the test.
struct Lab<'a> {
    roster: &'a Roster,
    watch: Watch<'a>,
}

impl Lab<'_> {
    /// One run, or nothing if the engine refuses; a claim without its number is then visibly empty.
    fn run(&self, scene: &Scene, engine: &str, setting: Setting) -> Option<Trace> {
        let silent = Watch {
            progress: &|_, _, _| {},
            cancelled: self.watch.cancelled,
        };
        let column = Configuration::with(self.roster.find(engine)?, setting);
        let cells = matrix::run_row(scene, &[column], Record::Events, Timing::None, silent);
        cells.into_iter().next()?.ok().map(|ran| ran.trace)
    }

    fn launch_depends_on_the_step(&self, shot: &Scene) -> Claim {
        let alone = cue_ball_alone(shot, None);
        let mut numbers = Vec::new();
        let mut travelled = |dt: f64, name: &str| {
            let setting = Setting::default()
                .with("dt", dt)
                .with("launch", "as-written");
            let trace = self.run(&alone, "stepper", setting);
            let path = trace.as_ref().map(|t| &t.paths[0]);
            let speed = path.map_or(f64::NAN, |p| p.knots[0].state.speed());
            let distance =
                path.and_then(|p| Some((p.last()?.position - p.knots[0].state.position).norm()));
            let distance = distance.unwrap_or(f64::NAN);
            numbers.push((format!("speed at dt {name}"), speed, alone.units.speed()));
            numbers.push((
                format!("stopping distance at dt {name}"),
                distance,
                alone.units.length.clone(),
            ));
            (speed, distance)
        };
        let (coarse, _) = travelled(1.0 / 30.0, "1/30 s");
        let (middle, far) = travelled(0.01, "1/100 s");
        let (_, near) = travelled(0.005, "1/200 s");
        let (fine, _) = travelled(1.0 / 240.0, "1/240 s");
        numbers.push((
            "stopping distance, dt halved from 1/100 s".to_owned(),
            far / near,
            "times".to_owned(),
        ));
        Claim {
            id: "launch",
            says: "The shot: v = F dt / m",
            found: format!(
                "The same shot starts at {coarse:.1}, {middle:.2} or {fine:.2} {}, with dt 1/30, 1/100 or 1/240 s: the \
                 time step sets the shot. Halving dt divides the stopping distance by {:.2}.",
                alone.units.speed(),
                far / near
            ),
            numbers,
            how: "stepper with launch=as-written on the shot's ball alone on an unbounded cloth"
                .to_owned(),
        }
    }

    fn units_are_mixed(&self, shot: &Scene) -> Claim {
        let per_metre = REPORT_SCALE / FOOT;
        let right_gravity = shot.gravity * per_metre;
        let mu = mu_of(shot);
        let effective = mu * shot.gravity / right_gravity;
        Claim {
            id: "units",
            says: "Gravity is 9.81 N on a table measured in scaled feet",
            found: format!(
                "One metre is {per_metre:.4} of the report's length units, so gravity is {right_gravity:.2} of them, not \
                 {}. Leaving it there makes mu = {mu} act as {effective:.4}, between rolling and sliding. And N is a \
                 force: the unit is m/s^2.",
                shot.gravity
            ),
            numbers: vec![
                (
                    "length units in a metre".to_owned(),
                    per_metre,
                    shot.units.length.clone(),
                ),
                (
                    "gravity in the report's units".to_owned(),
                    right_gravity,
                    shot.units.acceleration(),
                ),
                (
                    "friction that the report simulates".to_owned(),
                    effective,
                    String::new(),
                ),
                (
                    "radius".to_owned(),
                    2.25 / 2.0 / 12.0 * REPORT_SCALE,
                    shot.units.length.clone(),
                ),
            ],
            how: "arithmetic: 2.25 in / 2 in feet, times 2.5, is the report's radius".to_owned(),
        }
    }

    fn sliding_all_the_way(&self, shot: &Scene) -> Claim {
        let unit_in_metres = FOOT / REPORT_SCALE;
        let speed = 2.0;
        let (mu, g) = (mu_of(shot), 9.81);
        let scene = cue_ball_alone(shot, Some(speed / unit_in_metres));
        let trace = self.run(&scene, "exact", Setting::default());
        let distance = trace.and_then(|t| {
            Some((t.paths[0].last()?.position - t.paths[0].knots[0].state.position).norm())
        });
        let as_reported = distance.unwrap_or(f64::NAN) * unit_in_metres;
        let consistent = stop_distance(speed, mu, g);
        // a centre hit slides until 5/7 of the speed is left, over 12 v^2 / (49 mu g), and then rolls (Coriolis 1835)
        let slide = 12.0 * speed * speed / (49.0 * mu * g);
        let real = slide + stop_distance(5.0 / 7.0 * speed, MU_ROLL, g);
        let slides_for = 2.0 / 7.0 * stop_time(speed, mu, g);
        Claim {
            id: "sliding",
            says: "mu = 0.2 slows the ball from start to stop",
            found: format!(
                "A ball at {speed} m/s stops after {as_reported:.2} m in the report's units, after {consistent:.2} m with \
                 gravity in the right units, and after {real:.1} m on a real table, where it slides for {slides_for:.2} s \
                 only and then rolls."
            ),
            numbers: vec![
                (
                    "as the report simulates it".to_owned(),
                    as_reported,
                    "m".to_owned(),
                ),
                (
                    "sliding all the way, consistent gravity".to_owned(),
                    consistent,
                    "m".to_owned(),
                ),
                ("sliding, then rolling".to_owned(), real, "m".to_owned()),
            ],
            how: format!(
                "exact on a lone ball; closed forms with mu {mu} and rolling resistance {MU_ROLL}"
            ),
        }
    }

    // long: one claim, whose ten figures are read beside the runs that they are measured on
    fn plain_overlap_sticks(&self, tight: &Scene, mirrored: &Scene) -> Claim {
        let setting = |dt: f64| Setting::default().with("dt", dt);
        let written = self.run(tight, "stepper", setting(1e-3));
        let reflected = self.run(mirrored, "stepper", setting(1e-3));
        let approaching = self.run(
            tight,
            "stepper",
            setting(1e-3).with("contact", "approaching-only"),
        );
        let gap = (tight.balls[2].state.position - tight.balls[1].state.position).norm()
            - tight.contact_distance(1, 2);
        let safe = gap / tight.largest_speed() / 3.0;
        let fine = self.run(tight, "stepper", setting(safe));
        let exact = self.run(tight, "exact", Setting::default());
        let count = |trace: &Option<Trace>, name: &str| {
            trace
                .as_ref()
                .and_then(|t| t.counters.get(name))
                .map_or(f64::NAN, |&n| n as f64)
        };
        let apart = |a: &Option<Trace>| {
            let pair = a.as_ref().zip(exact.as_ref());
            pair.and_then(|(a, b)| largest_distance_at_end(tight, a, b))
                .unwrap_or(f64::NAN)
                * tight.smallest_radius()
        };
        let right = count(&exact, "ball_ball");
        let hits = count(&written, "exchanges");
        let asymmetry = mirror_distance(tight, &written, &reflected);
        let unit = &tight.units.length;
        let none = String::new;
        Claim {
            id: "sticking",
            says: "Two balls that overlap exchange velocities",
            found: format!(
                "In every step in which they still overlap. At gap 1e-3 R, aim 90.2 degrees, dt 1 ms, the break makes \
                 {hits:.0} exchanges where {right:.0} are right, a pair stays overlapped for {:.0} steps, {:.0} pairs \
                 overlap at rest, and final positions are off by {:.1}. Checking that the balls approach leaves {:.0}.",
                count(&written, "longest_overlap_steps"),
                count(&written, "pairs_overlapping_at_end"),
                apart(&written),
                count(&approaching, "exchanges")
            ),
            numbers: vec![
                ("exchanges as written, aim 90.2".to_owned(), hits, none()),
                (
                    "exchanges as written, aim 89.8".to_owned(),
                    count(&reflected, "exchanges"),
                    none(),
                ),
                (
                    "exchanges of approaching balls only".to_owned(),
                    count(&approaching, "exchanges"),
                    none(),
                ),
                (
                    "ball-ball hits of the exact solution".to_owned(),
                    right,
                    none(),
                ),
                (
                    "longest overlap of a pair".to_owned(),
                    count(&written, "longest_overlap_steps"),
                    "steps".to_owned(),
                ),
                (
                    "pairs overlapping at rest".to_owned(),
                    count(&written, "pairs_overlapping_at_end"),
                    none(),
                ),
                (
                    "worst final position, as written".to_owned(),
                    apart(&written),
                    unit.clone(),
                ),
                (
                    "worst final position, approaching only".to_owned(),
                    apart(&approaching),
                    unit.clone(),
                ),
                (
                    "aim 90.2 against 89.8 mirrored".to_owned(),
                    asymmetry,
                    unit.clone(),
                ),
                (
                    format!("exchanges as written at dt {safe:.1e} s (a third of gap / v)"),
                    count(&fine, "exchanges"),
                    none(),
                ),
            ],
            how: format!(
                "stepper at speed {:.3} {}; an exchange counts when it changes a velocity, an overlap when the centres are \
                 closer than 2 R at a step; scenes report-break-tight and report-break-tight-mirrored",
                tight.largest_speed(),
                tight.units.speed()
            ),
        }
    }

    fn table_is_not_a_pool_table(&self, shot: &Scene) -> Claim {
        let (long, wide) = (9.32 * FOOT, 4.65 * FOOT);
        let size = |axis: usize| shot.table.map_or(f64::NAN, |t| t.max[axis] - t.min[axis]);
        Claim {
            id: "table",
            says: "9.32 by 4.65 feet is a standard pool table; times 2.5, plus 1 for the siding",
            found: format!(
                "{long:.2} m x {wide:.2} m is a carom table with pool balls on it, and adding 1 after scaling makes its \
                 ratio {:.3} instead of {:.3}.",
                size(1) / size(0),
                long / wide
            ),
            numbers: vec![
                ("length".to_owned(), long, "m".to_owned()),
                ("width".to_owned(), wide, "m".to_owned()),
                (
                    "ratio as simulated".to_owned(),
                    size(1) / size(0),
                    String::new(),
                ),
            ],
            how: "arithmetic on the scene's table".to_owned(),
        }
    }

    fn mass_drops_out(&self, shot: &Scene) -> Claim {
        let mut heavier = shot.clone();
        for ball in &mut heavier.balls {
            ball.mass = BALL_OF_SIX_OUNCES;
        }
        let ends = |scene: &Scene| self.run(scene, "exact", Setting::default());
        let pair = ends(shot).zip(ends(&heavier));
        let moved = pair
            .and_then(|(a, b)| largest_distance_at_end(shot, &a, &b))
            .unwrap_or(f64::NAN);
        let mass = shot.balls[0].mass;
        Claim {
            id: "mass",
            says: "The mass of a ball is 0.107",
            found: format!(
                "A pool ball has {BALL_OF_SIX_OUNCES:.3} kg. Mass enters the launch only: at the same speed, balls of \
                 {BALL_OF_SIX_OUNCES:.3} end within {moved:.1e} R of those of {mass}."
            ),
            numbers: vec![
                (
                    "mass of a 6 oz ball".to_owned(),
                    BALL_OF_SIX_OUNCES,
                    "kg".to_owned(),
                ),
                (
                    "shift of the final positions".to_owned(),
                    moved,
                    "R".to_owned(),
                ),
            ],
            how: "exact on report-break with both masses, the same initial velocity".to_owned(),
        }
    }

    fn first_order(&self, slide: &Scene) -> Claim {
        let (mu, g) = (mu_of(slide), slide.gravity);
        let stop = stop_time(slide.largest_speed(), mu, g);
        let (dt, t) = (1e-3, stop / 2.0);
        let at = |engine: &str, setting: Setting| -> Option<Vec3> {
            // the stepper's state at t is a step end, up to rounding, when the run ends there
            let mut short = slide.clone();
            short.duration = (t / dt).round() * dt;
            Some(self.run(&short, engine, setting)?.paths[0].last()?.position)
        };
        let pair =
            at("stepper", Setting::default().with("dt", dt)).zip(at("exact", Setting::default()));
        let error = pair.map_or(f64::NAN, |(a, b)| (a - b).norm());
        let predicted = 0.5 * mu * g * t * dt;
        Claim {
            id: "order",
            says: "Every step: friction first, then positions",
            found: format!(
                "First order: after sliding for {t:.2} s at dt {dt} s the ball is {error:.3e} short; a t dt / 2 is \
                 {predicted:.3e}."
            ),
            numbers: vec![
                (
                    "error of the position".to_owned(),
                    error,
                    slide.units.length.clone(),
                ),
                (
                    "a t dt / 2".to_owned(),
                    predicted,
                    slide.units.length.clone(),
                ),
            ],
            how: "stepper against exact on the scene slide, at half the time to its stop"
                .to_owned(),
        }
    }
}

/// The cue ball of a scene alone on an unbounded cloth, at its own speed or the given one.
fn cue_ball_alone(scene: &Scene, speed: Option<f64>) -> Scene {
    let cue = scene.cue_ball();
    let mut alone = scene.clone();
    alone.balls = vec![scene.balls[cue].clone()];
    alone.table = None;
    alone.effects.cushion = None;
    // longer than any ball of these tests takes to stop
    alone.duration = 100.0;
    if let Some(Shot::Force {
        angle_deg,
        force,
        contact_time,
        ..
    }) = scene.shot
    {
        alone.shot = Some(Shot::Force {
            ball: 0,
            angle_deg,
            force,
            contact_time,
        });
    }
    if let Some(speed) = speed {
        let velocity = &mut alone.balls[0].state.velocity;
        *velocity *= speed / velocity.norm();
        alone.shot = None;
    }
    alone
}

fn mu_of(scene: &Scene) -> f64 {
    let mut mu = f64::NAN;
    scene.effects.map(|key, value| {
        if key == "cloth.translational.mu" {
            mu = value;
        }
    });
    mu
}

/// Largest distance between the end of a break and the mirror image of the end of the mirrored break, length.
fn mirror_distance(scene: &Scene, run: &Option<Trace>, mirrored: &Option<Trace>) -> f64 {
    let (Some(a), Some(b), Some(table)) = (run, mirrored, scene.table) else {
        return f64::NAN;
    };
    let reflect = |p: Vec3| Vec3::new(table.min[0] + table.max[0] - p.x, p.y, p.z);
    let image = |i: usize| {
        let wanted = reflect(scene.balls[i].state.position);
        let distance = |j: &usize| (scene.balls[*j].state.position - wanted).norm();
        (0..scene.balls.len()).min_by(|j, k| distance(j).total_cmp(&distance(k)))
    };
    let apart = |i: usize| {
        Some((a.paths[i].last()?.position - reflect(b.paths[image(i)?].last()?.position)).norm())
    };
    (0..scene.balls.len())
        .filter_map(apart)
        .fold(0.0, crate::math::worse)
}
