//! The parameter-equivalence sheet: what each engine was told, beside what it corresponds to in the others.

/// What a parameter is for; the same role in two engines makes one row of the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// How time is divided.
    TimeStep,
    /// Arithmetic.
    Precision,
    /// Initial motion of the shot's ball.
    Launch,
    /// Gravity.
    Gravity,
    /// Mass of the balls.
    Mass,
    /// Radius of the balls.
    Radius,
    /// Rotation of the balls.
    Rotation,
    /// Friction between ball and cloth.
    ClothFriction,
    /// How two balls are found to touch.
    ContactDetection,
    /// What a ball-ball impact does.
    BallRestitution,
    /// Friction between two balls.
    BallFriction,
    /// What a ball-cushion impact does.
    CushionRestitution,
    /// Friction between ball and cushion.
    CushionFriction,
    /// Position correction.
    PositionCorrection,
    /// When something counts as at rest.
    Rest,
    /// Everything else that changes physics.
    Other,
}

impl Role {
    /// Every role, in the order of the sheet.
    pub const ALL: [Role; 16] = [
        Role::TimeStep,
        Role::Precision,
        Role::Launch,
        Role::Gravity,
        Role::Mass,
        Role::Radius,
        Role::Rotation,
        Role::ClothFriction,
        Role::ContactDetection,
        Role::BallRestitution,
        Role::BallFriction,
        Role::CushionRestitution,
        Role::CushionFriction,
        Role::PositionCorrection,
        Role::Rest,
        Role::Other,
    ];

    /// Title of the row.
    pub fn title(self) -> &'static str {
        match self {
            Role::TimeStep => "time step",
            Role::Precision => "arithmetic",
            Role::Launch => "launch",
            Role::Gravity => "gravity",
            Role::Mass => "mass of a ball",
            Role::Radius => "radius of a ball",
            Role::Rotation => "rotation",
            Role::ClothFriction => "friction with the cloth",
            Role::ContactDetection => "how contact is found",
            Role::BallRestitution => "ball-ball impact",
            Role::BallFriction => "ball-ball friction",
            Role::CushionRestitution => "ball-cushion impact",
            Role::CushionFriction => "ball-cushion friction",
            Role::PositionCorrection => "position correction",
            Role::Rest => "rest",
            Role::Other => "other",
        }
    }
}

/// One parameter that changes physics.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// What it is for: the row of the sheet.
    pub role: Role,
    /// The engine's own name of it, such as `contact_recycling`.
    pub name: String,
    /// Effective value, as text.
    pub value: String,
    /// Unit; empty for a pure number or a word.
    pub unit: String,
}

impl Parameter {
    /// A parameter with a unit (empty for none).
    pub fn new(role: Role, name: &str, value: impl ToString, unit: &str) -> Self {
        Parameter {
            role,
            name: name.to_owned(),
            value: value.to_string(),
            unit: unit.to_owned(),
        }
    }
}
