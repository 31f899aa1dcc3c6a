use carom::engine::Limits;
use carom::engine::exact::{final_positions, solve, certify};
use carom::engine::exact::sensitivity::{Input, influences, growth};
use carom::math::{DoubleDouble, Real};
use carom::scene::{Scene, parse};
use std::time::Instant;

fn changed(scene: &Scene, input: Input, by: f64) -> Option<Scene> {
    let mut scene = scene.clone();
    let cue = scene.cue_ball();
    let state = &mut scene.balls[cue].state;
    let (v, w) = (state.velocity, state.spin);
    match input {
        Input::Aim => {
            (state.velocity.x, state.velocity.y) = (v.x - by * v.y, v.y + by * v.x);
            (state.spin.x, state.spin.y) = (w.x - by * w.y, w.y + by * w.x);
        }
        Input::Speed => { state.velocity *= 1.0 + by; state.spin *= 1.0 + by; }
        Input::Effect(key) => {
            let change = |of, value| if of == key { value * (1.0 + by) } else { value };
            scene.effects = scene.effects.map(change);
        }
        _ => return None,
    }
    Some(scene)
}
fn by() -> f64 { std::env::var("BY").ok().and_then(|x| x.parse().ok()).unwrap_or(1e-8) }
fn main() {
    if let Ok(times) = std::env::var("TIMES") { let t: Vec<f64> = times.split(",").map(|x| x.parse().unwrap()).collect(); stages(&std::env::args().nth(1).unwrap(), &t); return; }
    let names: Vec<String> = std::env::args().skip(1).collect();
    for name in &names {
        let t0 = Instant::now();
        let text = std::fs::read_to_string(format!("validation/references/contact/{name}.toml")).unwrap();
        let scene = parse("x.toml", &text).unwrap();
        let run = solve::<f64>(&scene, &Limits::NONE);
        let t1 = Instant::now();
        let found = influences(&scene, &run.trace, f64::INFINITY, &Limits::NONE);
        let t2 = Instant::now();
        println!("{name} events {} solve {:?} influences {:?} found {}", run.trace.events.len(), t1-t0, t2-t1, found.len());
        for i in &found {
            let ends = [by(), -by()].map(|by| Some(final_positions::<DoubleDouble>(&changed(&scene, i.input, by)?)));
            let [Some(a), Some(b)] = ends else { println!("  {} {:?}", i.input.name(), i.derivative); continue };
            let largest = i.derivative.iter().flatten().fold(0.0_f64, |m, d| m.max(d.abs()));
            let mut worst = 0.0_f64;
            for (ball, d) in i.derivative.iter().enumerate() { for axis in 0..2 {
                let q = (a[ball][axis] - b[ball][axis]).to_f64() / (2.0*by());
                let e = (q - d[axis]).abs() / largest;
                if !(e <= 1e-5) { println!("    {} ball {ball} axis {axis}: {:e} fd {q:e}", i.input.name(), d[axis]); }
                worst = worst.max(e);
            }}
            println!("  {} largest {largest:e} worst {worst:e} lost {:?}", i.input.name(), i.lost);
        }
        if std::env::var("MORE").is_ok() {
            let t = Instant::now();
            let c = certify(&scene, &run.trace, f64::EPSILON, &Limits::NONE);
            let nones: Vec<usize> = c.iter().enumerate().filter(|(_, c)| c.time_error.is_none()).map(|(i, _)| i).collect(); println!("  nones {nones:?}"); let none = c.iter().filter(|c| c.time_error.is_none()).count();
            println!("  certify {:?} none {none} last {:?}", t.elapsed(), c.last());
            let t = Instant::now();
            let g = growth(&scene, &run.trace, true, &Limits::NONE).unwrap();
            println!("  growth {:?} n {} last {} rough {:?} lost {:?}", t.elapsed(), g.factors.len(), g.last(), g.rough, g.lost);
        }
    }
}
#[allow(dead_code)]
pub fn stages(name: &str, times: &[f64]) {
    let text = std::fs::read_to_string(format!("validation/references/contact/{name}.toml")).unwrap();
    let scene = parse("x.toml", &text).unwrap();
    let run = solve::<f64>(&scene, &Limits::NONE);
    for t in times {
        let found = influences(&scene, &run.trace, *t, &Limits::NONE);
        let i = &found[0];
        let mut cut = scene.clone(); cut.duration = *t;
        let ends = [by(), -by()].map(|by| final_positions::<DoubleDouble>(&changed(&cut, i.input, by).unwrap()));
        for b in 0..scene.balls.len() {
            let q = (ends[0][b][1] - ends[1][b][1]).to_f64() / (2.0 * by());
            println!("t {t} ball {b}: {:e} fd {q:e} diff {:e}", i.derivative[b][1], q - i.derivative[b][1]);
        }
    }
}
