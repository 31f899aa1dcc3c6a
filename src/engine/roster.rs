//! The engines that a command may name: a value that is made once and passed down, so that others can join the built-in ones.

use super::{Engine, exact, rapier, stepper};
use crate::scene::printable;
use std::fmt;
use std::sync::Arc;

/// Engines, each with an id of its own, in the order in which reports list them.
#[derive(Clone)]
pub struct Roster {
    engines: Vec<Arc<dyn Engine>>,
}

impl Roster {
    /// The engines of this crate.
    pub fn built_in() -> Self {
        Roster {
            engines: vec![
                Arc::new(stepper::Stepper),
                Arc::new(exact::Exact),
                Arc::new(rapier::RAPIER_F64),
                Arc::new(rapier::RAPIER_F32),
            ],
        }
    }

    /// The same with one engine more, listed last. Errors: one of its id is there already.
    pub fn with(mut self, engine: impl Engine + 'static) -> Result<Self, Twice> {
        if let Some(known) = self.find(engine.id()) {
            return Err(Twice(known.id().to_owned()));
        }
        self.engines.push(Arc::new(engine));
        Ok(self)
    }

    /// The engine called `id`.
    pub fn find(&self, id: &str) -> Option<&Arc<dyn Engine>> {
        self.engines.iter().find(|engine| engine.id() == id)
    }

    /// The engine called `id`. Errors: there is none, and which there are.
    pub fn named(&self, id: &str) -> Result<&Arc<dyn Engine>, UnknownEngine> {
        self.find(id).ok_or_else(|| UnknownEngine {
            id: id.to_owned(),
            known: self.ids(),
        })
    }

    /// Every engine, in order.
    pub fn iter(&self) -> std::slice::Iter<'_, Arc<dyn Engine>> {
        self.engines.iter()
    }

    /// Ids of every engine, in order, parted by commas.
    pub fn ids(&self) -> String {
        let ids: Vec<&str> = self.engines.iter().map(|engine| engine.id()).collect();
        ids.join(", ")
    }
}

impl<'a> IntoIterator for &'a Roster {
    type Item = &'a Arc<dyn Engine>;
    type IntoIter = std::slice::Iter<'a, Arc<dyn Engine>>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl fmt::Debug for Roster {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.ids())
    }
}

/// Two rosters are the same if they list the same engines.
impl PartialEq for Roster {
    fn eq(&self, other: &Self) -> bool {
        let ids = |roster: &Roster| -> Vec<String> {
            let ids = roster.iter().map(|engine| engine.id().to_owned());
            ids.collect()
        };
        ids(self) == ids(other)
    }
}

impl Eq for Roster {}

/// Two engines have one id.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is an engine called `{0}` already")]
pub struct Twice(pub String);

/// No engine of the roster has the id.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no engine is called `{}`; there are {known}", printable(.id))]
pub struct UnknownEngine {
    /// The id.
    pub id: String,
    /// Ids of those that there are, parted by commas.
    pub known: String,
}
