//! An oracle for frictionless discs of equal mass on an unbounded plane: straight lines, quadratics, exchanged normals.
//!
//! Forty lines that share nothing with the crate, so that rapier is held against the exact answer and not against
//! another part of the workbench.

use carom::scene::Scene;

/// A frictionless disc.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    pub position: [f64; 2],
    pub velocity: [f64; 2],
}

/// The discs of a scene after `duration`, and how many hits they had.
pub fn exact(scene: &Scene, duration: f64) -> (Vec<Disc>, usize) {
    let radius = scene.balls[0].radius;
    let mut discs: Vec<Disc> = scene
        .balls
        .iter()
        .map(|ball| Disc {
            position: [ball.state.position.x, ball.state.position.y],
            velocity: [ball.state.velocity.x, ball.state.velocity.y],
        })
        .collect();
    let (mut now, mut hits) = (0.0, 0);
    loop {
        let mut next = (duration - now, None);
        for a in 0..discs.len() {
            for b in a + 1..discs.len() {
                if let Some(t) = time_to_contact(&discs[a], &discs[b], 2.0 * radius)
                    && t < next.0
                {
                    next = (t, Some((a, b)));
                }
            }
        }
        for disc in &mut discs {
            for axis in 0..2 {
                disc.position[axis] += disc.velocity[axis] * next.0;
            }
        }
        now += next.0;
        let Some((a, b)) = next.1 else {
            return (discs, hits);
        };
        hits += 1;
        let d = difference(&discs[b].position, &discs[a].position);
        let n = [d[0] / d[0].hypot(d[1]), d[1] / d[0].hypot(d[1])];
        let dv = difference(&discs[a].velocity, &discs[b].velocity);
        let approach = dv[0] * n[0] + dv[1] * n[1];
        for (axis, n) in n.iter().enumerate() {
            discs[a].velocity[axis] -= approach * n;
            discs[b].velocity[axis] += approach * n;
        }
    }
}

fn difference(a: &[f64; 2], b: &[f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// First root of |d + t v| = reach with d . v < 0, in the form that keeps its digits.
fn time_to_contact(a: &Disc, b: &Disc, reach: f64) -> Option<f64> {
    let d = difference(&b.position, &a.position);
    let v = difference(&b.velocity, &a.velocity);
    let closing = -(d[0] * v[0] + d[1] * v[1]);
    if closing <= 0.0 {
        return None;
    }
    let gap = d[0].hypot(d[1]) - reach;
    let c = gap * (d[0].hypot(d[1]) + reach);
    let discriminant = closing * closing - (v[0] * v[0] + v[1] * v[1]) * c;
    (discriminant >= 0.0).then(|| (c / (closing + discriminant.sqrt())).max(0.0))
}

#[test]
fn the_oracle_turns_a_half_ball_hit_by_the_ninety_degree_rule() {
    let scene = super::cut_shot(30.0, 1.0, 1.0).build();
    let (discs, hits) = exact(&scene, 2.0);
    assert_eq!(hits, 1);
    let (cue, object) = (discs[0].velocity, discs[1].velocity);
    let (c, s) = (0.75_f64.sqrt(), 0.5);
    let expected = ([s * s, -s * c], [c * c, c * s]);
    for axis in 0..2 {
        assert!((cue[axis] - expected.0[axis]).abs() < 1e-14, "{cue:?}");
        assert!(
            (object[axis] - expected.1[axis]).abs() < 1e-14,
            "{object:?}"
        );
    }
}
