//! An argument that is one of a list.

use clap::builder::{PossibleValuesParser, TypedValueParser};

/// One of the words of a list, as the value that it names. A word that passes the list names one of them: the first is never taken.
pub fn choice<T: Clone + Send + Sync + 'static>(
    all: &'static [T],
    id: fn(&T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    let find = move |word: String| all.iter().find(|one| id(one) == word).unwrap_or(&all[0]);
    PossibleValuesParser::new(all.iter().map(id)).map(move |word| find(word).clone())
}
