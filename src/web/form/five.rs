//! The five inputs of the report's own window, with what the report recommends.

/// One of the five.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// Name in the form.
    pub name: &'static str,
    /// What a person calls it.
    pub label: &'static str,
    /// Its unit, in the words of the report's scene; other scenes have units of their own.
    pub unit: &'static str,
    /// What the report recommends.
    pub recommended: f64,
    /// Range and meaning, in a few words.
    pub range: &'static str,
    /// The keys of the scene that it is, one a law.
    pub paths: &'static [&'static str],
}

/// The five, in the order of the report.
pub const FIVE: [Input; 5] = [
    Input {
        name: "mass",
        label: "Ball mass",
        unit: "",
        recommended: 0.107,
        range: "greater than 0",
        paths: &["ball.mass"],
    },
    Input {
        name: "force",
        label: "Cue force",
        unit: "mass · length/s²",
        recommended: 108.0,
        range: "0 or greater",
        paths: &["shot.force.force"],
    },
    Input {
        name: "gravity",
        label: "Gravity",
        unit: "length/s²",
        recommended: 9.81,
        range: "0 or greater",
        paths: &["gravity"],
    },
    Input {
        name: "friction",
        label: "Cloth friction",
        unit: "",
        recommended: 0.2,
        range: "realistic 0.15 to 0.4",
        paths: &[
            "effects.cloth.translational.mu",
            "effects.cloth.rotational.mu_slide",
        ],
    },
    Input {
        name: "angle",
        label: "Shot angle",
        unit: "degrees",
        recommended: 90.0,
        range: "straight at the rack; 270 is away from it, -360 to 360",
        paths: &[
            "shot.force.angle_deg",
            "shot.velocity.angle_deg",
            "shot.strike.angle_deg",
        ],
    },
];

/// The name of the input that a key of the scene is.
pub fn name_of(path: &str) -> Option<&'static str> {
    let input = FIVE.iter().find(|input| input.paths.contains(&path));
    input.map(|input| input.name)
}
