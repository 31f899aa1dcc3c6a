use crate::support::*;
use carom::trace::Record;

#[test]
fn explore() {
    for engine in ["rapier-f64", "rapier-f32"] {
        let scene = scenario("slide")
            .shot("cue", [0.0, 0.0], 5.0, 37.0)
            .cloth(MU)
            .build();
        for s in [
            &["dt=1e-3"][..],
            &["dt=1e-4"],
            &["dt=1e-3", "substeps=1"],
            &["preset=stock"],
        ] {
            let t = run(engine, s, &scene, Record::Events);
            let f = t.final_states()[0].unwrap();
            let v = 5.0f64;
            let a = MU * G;
            println!(
                "{engine} {s:?} {:?} stop {:?} want {} dist {} want {} short {:e} hv/2 {:e} unexpl {:e} final v {:e} z {:e} {:?}",
                t.ending,
                t.stop_times[0],
                v / a,
                f.position.xy().norm(),
                v * v / 2. / a,
                v * v / 2. / a - f.position.xy().norm(),
                1e-3 / 4. * v / 2.,
                t.unexplained(),
                f.velocity.norm(),
                f.position.z - R,
                t.counters
            );
        }
        let scene = scenario("headon")
            .shot("cue", [0.0, 0.0], 5.0, 0.0)
            .resting("1", [1.0, 0.0])
            .duration(1.0)
            .build();
        let t = run(engine, &[], &scene, Record::Events);
        println!(
            "{engine} headon {:?} {:?} {:?} unexp {:e} vdt {:e} {:?}",
            t.events,
            t.final_states()[0].unwrap().velocity,
            t.final_states()[1].unwrap().velocity,
            t.unexplained(),
            5e-3,
            t.extrema
        );
        for k in &t.paths[1].knots {
            println!("   {k:?}");
        }
        let scene = scenario("obl")
            .shot("cue", [0.0, 0.0], 5.0, 0.0)
            .resting("1", [1.0, 0.2])
            .cloth(MU)
            .duration(10.0)
            .build();
        let t = run(engine, &[], &scene, Record::Events);
        println!(
            "{engine} oblique {:?} unexp {:e} vdt {:e} {:?} {:?}",
            t.events,
            t.unexplained(),
            5e-3,
            t.extrema,
            t.counters
        );
    }
}
