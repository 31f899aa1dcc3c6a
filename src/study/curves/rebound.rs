//! Rebound: angle and speed after a cushion against the angle of incidence, by Han 2005 and Mathavan 2010, for balls that roll and balls
//! without spin.
//!
//! Points: an independent program, pooltool 0.6.0, whose Mathavan rows were run with a fine step. Both laws scale with the speed, so one
//! speed stands for all.

use super::{Curve, DEGREES, Departure, Lab, line, velocity_after};
use crate::finding::{Axis, Figure, Series, Style};
use crate::math::Vec3;
use crate::math::angle::unit_vector;
use crate::physics::cloth::rotational::rolling_spin;
use crate::physics::{Body, Cushion, Side, cushion};
use crate::scene::{Scene, SceneError, catalogue};
use crate::trace::Trace;

/// Rebounds by the independent program.
const REBOUNDS: &str = include_str!("../../../validation/references/c_cushion.csv");
/// Speed of the shots, m/s.
const SPEED: f64 = 1.0;
/// Radius and mass of the balls, m and kg.
const RADIUS: f64 = 0.028575;
const MASS: f64 = 0.170097;
/// Incidence from the rail at which engines are asked, degrees.
const ASKED: [f64; 6] = [10.0, 20.0, 30.0, 45.0, 60.0, 75.0];

/// A law with the model's name in the file.
struct Law {
    name: &'static str,
    model: &'static str,
    law: Cushion,
}

const LAWS: [Law; 2] = [
    Law {
        name: "law of Han 2005",
        model: "han_2005",
        law: Cushion::Han2005 {
            e: 0.85,
            mu: 0.2,
            height: 1.28,
        },
    },
    Law {
        name: "law of Mathavan 2010",
        model: "mathavan_2010_ms20000_dp1e-6",
        law: Cushion::Mathavan2010 {
            e: 0.98,
            mu: 0.14,
            mu_cloth: 0.212,
            height: 1.28,
        },
    },
];

/// What a ball does before it meets the cushion: in words, and in the file.
const SPINS: [(&str, &str); 2] = [("rolling", "rolling"), ("without spin", "stun")];

/// What is drawn of a rebound: an angle or a speed.
#[derive(Clone, Copy)]
enum Shown {
    Angle,
    Speed,
}

impl Shown {
    /// The value of a velocity after the cushion x = 0, the ball coming from smaller x.
    fn of(self, velocity: &Vec3) -> f64 {
        match self {
            Shown::Angle => (-velocity.x).atan2(velocity.y).to_degrees(),
            Shown::Speed => velocity.x.hypot(velocity.y) / SPEED,
        }
    }

    fn unit(self) -> &'static str {
        match self {
            Shown::Angle => DEGREES,
            Shown::Speed => "v",
        }
    }
}

pub(super) fn curve(lab: &Lab<'_>) -> Result<Curve, SceneError> {
    let mut found = Curve::default();
    for shown in [Shown::Angle, Shown::Speed] {
        let mut series = Vec::new();
        let (mut data, mut dots): (_, Vec<Series>) = (Vec::new(), Vec::new());
        for Law { name, model, law } in &LAWS {
            let mut program = departure("pooltool", name, shown);
            let mut shots = Vec::new();
            for (spin, case) in SPINS {
                let angles = (2..=89).map(f64::from);
                let points = angles
                    .map(|a| [a, shown.of(&after(*law, a, spin))])
                    .collect();
                series.push(line(
                    format!("{}, {spin}", name.trim_start_matches("law of ")),
                    points,
                    Style::Line,
                ));
                for [a, angle, speed] in independent(model, case) {
                    let value = match shown {
                        Shown::Angle => angle,
                        Shown::Speed => speed,
                    };
                    program.note((value - shown.of(&after(*law, a, spin))).abs());
                    data.push([a, value]);
                }
                for a in ASKED {
                    shots.push((a, shot(*law, a, spin)?, shown.of(&after(*law, a, spin))));
                }
            }
            let read = |trace: &Trace, _: f64| Some(shown.of(&velocity_after(trace, 0)?));
            let (points, departures) = lab.points(&shots, name, shown.unit(), read);
            dots.extend(points);
            found.departures.extend(departures);
            found.departures.push(program);
        }
        series.push(line("pooltool", data, Style::Points));
        series.extend(dots);
        found.figures.push(figure(shown, series));
    }
    Ok(found)
}

fn departure(who: &str, law: &'static str, shown: Shown) -> Departure {
    Departure {
        who: who.to_owned(),
        from: law,
        points: 0,
        largest: None,
        unit: shown.unit(),
        missing: Vec::new(),
    }
}

fn figure(shown: Shown, series: Vec<Series>) -> Figure {
    let (id, title, axis) = match shown {
        Shown::Angle => (
            "rebound-angle",
            "Angle of rebound",
            Axis::linear("rebound from the rail", DEGREES),
        ),
        Shown::Speed => (
            "rebound-speed",
            "Speed of rebound",
            Axis::linear("speed after / before", ""),
        ),
    };
    Figure {
        id: id.to_owned(),
        title: title.to_owned(),
        caption: "Just after the impact, before the cloth turns the path. Lines: the laws, with the constants of the independent \
                  program's rows."
            .to_owned(),
        x: Axis::linear("incidence from the rail", DEGREES),
        y: axis,
        equal_scale: false,
        outline: None,
        series,
        marks: Vec::new(),
    }
}

/// Velocity and spin of a ball that meets the cushion x = 0 at `incidence` degrees from the rail.
fn before(incidence: f64, spin: &str) -> (Vec3, Vec3) {
    let (cos, sin) = unit_vector(incidence);
    let velocity = Vec3::new(SPEED * sin, SPEED * cos, 0.0);
    let spin = match spin {
        "rolling" => rolling_spin(&velocity, RADIUS),
        _ => Vec3::zeros(),
    };
    (velocity, spin)
}

/// Velocity after the impact by the law itself.
fn after(law: Cushion, incidence: f64, spin: &str) -> Vec3 {
    let (velocity, spin) = before(incidence, spin);
    let ball = Body {
        velocity,
        spin,
        mass: MASS,
        radius: RADIUS,
    };
    cushion::impact(law, &ball, Side::X1).motion.velocity
}

/// A ball a moment before it meets the cushion x1.
fn shot(law: Cushion, incidence: f64, spin: &str) -> Result<Scene, SceneError> {
    let mut scene = catalogue::scene("bank")?;
    scene.effects.cushion = Some(law);
    let (velocity, spin) = before(incidence, spin);
    let reach = scene.reach(Side::X1, RADIUS).unwrap_or_default();
    let state = &mut scene.balls[0].state;
    state.position.x = reach - super::GAP;
    (state.velocity, state.spin) = (velocity, spin);
    scene.duration = 0.01;
    Ok(scene)
}

/// Incidence, rebound angle in degrees, and speed after over before, of the independent program's rows.
fn independent(model: &str, spin: &str) -> Vec<[f64; 3]> {
    let mut lines = REBOUNDS.lines();
    let heading: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let place = |name: &str| heading.iter().position(|known| *known == name);
    let places = ["V", "inc_angle_deg_from_rail", "vx", "vy"].map(place);
    let read = |row: &str| -> Option<[f64; 3]> {
        let cells: Vec<&str> = row.split(',').collect();
        if cells.first() != Some(&model) || cells.get(place("spin_case")?) != Some(&spin) {
            return None;
        }
        let number = |k: usize| cells.get(places[k]?)?.parse::<f64>().ok();
        let (v, incidence, vx, vy) = (number(0)?, number(1)?, number(2)?, number(3)?);
        Some([incidence, (-vx).atan2(vy).to_degrees(), vx.hypot(vy) / v])
    };
    lines.filter_map(read).collect()
}
