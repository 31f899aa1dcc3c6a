//! Power series of the solution of a differential equation, to any order, in any scalar.
//!
//! A right-hand side is written once on a [`Tape`]: inputs, constants and operations, each a node with the Taylor coefficients of its value
//! about time 0. The coefficient of order k of every node follows from those of lower orders by the classical recurrences (Moore 1966,
//! Interval Analysis, ch. 11), and that of order k + 1 of an input from its derivative, which is a node. So a tape of n operations gives
//! k orders in n k^2 / 2 multiplications, and the series are the solution itself up to where they converge: dense, smooth, and as exact as
//! the scalar.

use super::Real;
use super::linear::Factors;
use std::ops::Range;

/// A value on a tape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Node(usize);

/// How a value comes about.
#[derive(Clone, Copy, Debug)]
enum Operation<T> {
    /// A number that does not change.
    Constant,
    /// What is given at order 0; its derivative is another node, if it changes at all.
    Input(Option<Node>),
    Sum(Node, Node),
    Difference(Node, Node),
    Product(Node, Node),
    Quotient(Node, Node),
    Multiple(Node, T),
    Root(Node),
    Exponential(Node),
    /// The unknown of a linear system with this place.
    Unknown(usize, usize),
}

/// A linear system between nodes.
#[derive(Clone, Debug)]
struct System<T> {
    /// What of each row is not nothing, by place.
    rows: Vec<Vec<(usize, Node)>>,
    right: Vec<Node>,
    /// Of the rows at time 0; `None` where they have no single solution.
    factors: Option<Factors<T>>,
    /// The first unknown; the others follow.
    first: usize,
}

impl<T: Real> System<T> {
    /// The unknowns for this right side.
    fn solved(&self, mut right: Vec<T>) -> Vec<T> {
        match &self.factors {
            Some(factors) => factors.solve(&mut right),
            None => right.fill(T::lift(f64::NAN)),
        }
        right
    }
}

/// A right-hand side and the series of everything in it.
#[derive(Clone, Debug, Default)]
pub struct Tape<T> {
    operations: Vec<Operation<T>>,
    /// Of each node, its value at time 0.
    values: Vec<T>,
    /// Coefficients of each node, by order, one node after the other, once they have been asked for.
    table: Vec<T>,
    /// Coefficients of a node in the table.
    orders: usize,
    /// Of each node, the highest order so far whose coefficient is not nothing.
    highest: Vec<usize>,
    systems: Vec<System<T>>,
}

impl<T: Real> Tape<T> {
    /// A tape without anything on it.
    pub fn new() -> Self {
        Tape {
            operations: Vec::new(),
            values: Vec::new(),
            table: Vec::new(),
            orders: 0,
            highest: Vec::new(),
            systems: Vec::new(),
        }
    }

    fn given(&mut self, operation: Operation<T>, value: T) -> Node {
        self.operations.push(operation);
        self.values.push(value);
        Node(self.operations.len() - 1)
    }

    fn add(&mut self, operation: Operation<T>) -> Node {
        let of = |node: Node| self.values[node.0];
        let value = match operation {
            Operation::Constant | Operation::Input(_) | Operation::Unknown(..) => T::zero(),
            Operation::Sum(a, b) => of(a) + of(b),
            Operation::Difference(a, b) => of(a) - of(b),
            // as the sum that every other order is
            Operation::Product(a, b) => T::zero() + of(a) * of(b),
            Operation::Quotient(a, b) => of(a) / of(b),
            Operation::Multiple(a, factor) => of(a) * factor,
            Operation::Root(a) => of(a).sqrt(),
            Operation::Exponential(a) => of(a).exp(),
        };
        self.given(operation, value)
    }

    /// A value at time 0; what it does later is said by [`Tape::derive`].
    pub fn input(&mut self, value: T) -> Node {
        self.given(Operation::Input(None), value)
    }

    /// A number that does not change. What is made of such numbers only does not change either, and what is nothing leaves no operation behind.
    pub fn constant(&mut self, value: T) -> Node {
        self.given(Operation::Constant, value)
    }

    /// The number, if a node is one that does not change.
    fn number(&self, node: Node) -> Option<T> {
        matches!(self.operations[node.0], Operation::Constant).then(|| self.value(node))
    }

    fn is_nothing(&self, node: Node) -> bool {
        self.number(node).is_some_and(T::is_nothing)
    }

    /// Says what the derivative of an input is.
    pub fn derive(&mut self, input: Node, rate: Node) {
        if let Operation::Input(known) = &mut self.operations[input.0] {
            *known = Some(rate);
        }
    }

    /// a + b.
    pub fn sum(&mut self, a: Node, b: Node) -> Node {
        match (self.number(a), self.number(b)) {
            (Some(a), Some(b)) => self.constant(a + b),
            _ if self.is_nothing(a) => b,
            _ if self.is_nothing(b) => a,
            _ => self.add(Operation::Sum(a, b)),
        }
    }

    /// a - b.
    pub fn difference(&mut self, a: Node, b: Node) -> Node {
        match (self.number(a), self.number(b)) {
            (Some(a), Some(b)) => self.constant(a - b),
            _ if self.is_nothing(a) => self.multiple(b, -T::one()),
            _ if self.is_nothing(b) => a,
            _ => self.add(Operation::Difference(a, b)),
        }
    }

    /// a b.
    pub fn product(&mut self, a: Node, b: Node) -> Node {
        match (self.number(a), self.number(b)) {
            (Some(a), _) => self.multiple(b, a),
            (_, Some(b)) => self.multiple(a, b),
            _ => self.add(Operation::Product(a, b)),
        }
    }

    /// a / b; b is not 0 at time 0.
    pub fn quotient(&mut self, a: Node, b: Node) -> Node {
        match (self.number(a), self.number(b)) {
            (Some(a), Some(b)) => self.constant(a / b),
            _ if self.is_nothing(a) => a,
            _ => self.add(Operation::Quotient(a, b)),
        }
    }

    /// a times a number.
    pub fn multiple(&mut self, a: Node, factor: T) -> Node {
        match self.number(a) {
            Some(a) => self.constant(a * factor),
            _ if factor.is_nothing() => self.constant(factor),
            _ => self.add(Operation::Multiple(a, factor)),
        }
    }

    /// Square root; a is positive at time 0.
    pub fn root(&mut self, a: Node) -> Node {
        match self.number(a) {
            Some(a) => self.constant(a.sqrt()),
            None => self.add(Operation::Root(a)),
        }
    }

    /// e to the power of a.
    pub fn exponential(&mut self, a: Node) -> Node {
        self.add(Operation::Exponential(a))
    }

    /// What solves a linear system, whose matrix is given by rows.
    pub fn solution(&mut self, rows: &[Vec<Node>], right: &[Node]) -> Vec<Node> {
        let values = rows
            .iter()
            .map(|row| row.iter().map(|node| self.value(*node)).collect());
        let factors = Factors::of(values.collect(), T::zero());
        let told = rows.iter().map(|row| {
            let told = row.iter().copied().enumerate();
            told.filter(|(_, node)| !self.is_nothing(*node)).collect()
        });
        let system = System {
            rows: told.collect(),
            right: right.to_vec(),
            factors,
            first: self.operations.len(),
        };
        let given = system.right.iter().map(|node| self.value(*node));
        let values = system.solved(given.collect());
        self.systems.push(system);
        let place = self.systems.len() - 1;
        let unknowns = values.into_iter().enumerate();
        unknowns
            .map(|(i, value)| self.given(Operation::Unknown(place, i), value))
            .collect()
    }

    /// The coefficients of order `k` of the unknowns of a system, all of whose lower ones are known.
    fn unknowns(&self, system: &System<T>, k: usize) -> Vec<T> {
        let left = system.rows.iter().zip(&system.right).map(|(row, right)| {
            let mut left = self.row(right.0)[k];
            for (i, node) in row {
                let (entries, unknown) = (self.row(node.0), self.row(system.first + i));
                for j in self.both(*node, Node(system.first + i), 1..k + 1, k) {
                    left -= entries[j] * unknown[k - j];
                }
            }
            left
        });
        system.solved(left.collect())
    }

    /// The value of a node at time 0.
    pub fn value(&self, node: Node) -> T {
        self.values[node.0]
    }

    /// The coefficients of a node, from order 0 on; none before they have been asked for.
    pub fn series(&self, node: Node) -> &[T] {
        self.row(node.0)
    }

    fn row(&self, node: usize) -> &[T] {
        &self.table[node * self.orders..][..self.orders]
    }

    /// Of these orders those for which neither the coefficient of `a` nor that of `b`, of what is left up to `k`, is known to be nothing.
    fn both(&self, a: Node, b: Node, orders: Range<usize>, k: usize) -> Range<usize> {
        let from = k.saturating_sub(self.highest[b.0]);
        orders.start.max(from)..orders.end.min(self.highest[a.0] + 1)
    }

    /// Finds every series to order `most`, by powers of the time in `unit`s, s. With one near the
    /// time in which things change, coefficients of any order stay within the range of numbers.
    pub fn solve(&mut self, most: usize, unit: T) {
        let nodes = self.operations.len();
        self.orders = most + 1;
        self.table.clear();
        self.table.resize(nodes * self.orders, T::zero());
        for (node, value) in self.values.iter().enumerate() {
            self.table[node * self.orders] = *value;
        }
        self.highest.clear();
        self.highest.resize(nodes, 0);
        for order in 1..=most {
            // an input follows from its rate one order below, which is known for all nodes
            for node in 0..nodes {
                if let Operation::Input(Some(rate)) = self.operations[node] {
                    let rate = self.row(rate.0)[order - 1];
                    self.put(node, order, rate * unit / T::lift(order as f64));
                }
            }
            for node in 0..nodes {
                match self.operations[node] {
                    Operation::Constant | Operation::Input(_) => {}
                    Operation::Unknown(system, 0) => {
                        let found = self.unknowns(&self.systems[system], order);
                        for (i, next) in found.into_iter().enumerate() {
                            self.put(node + i, order, next);
                        }
                    }
                    // with the first of its system
                    Operation::Unknown(..) => {}
                    operation => {
                        let next = self.coefficient(node, operation, order);
                        self.put(node, order, next);
                    }
                }
            }
        }
    }

    fn put(&mut self, node: usize, order: usize, coefficient: T) {
        self.table[node * self.orders + order] = coefficient;
        if !coefficient.is_nothing() {
            self.highest[node] = order;
        }
    }

    /// The coefficient of order `k`, at least 1, of an operation, all of whose operands know theirs.
    fn coefficient(&self, node: usize, operation: Operation<T>, k: usize) -> T {
        let of = |node: Node| self.row(node.0);
        let own = self.row(node);
        let convolved = |a: Node, b: Node, orders: Range<usize>| {
            let (left, right) = (of(a), of(b));
            let mut sum = T::zero();
            for j in self.both(a, b, orders, k) {
                sum += left[j] * right[k - j];
            }
            sum
        };
        match operation {
            // inputs follow from their rates, unknowns all together
            Operation::Constant | Operation::Input(_) | Operation::Unknown(..) => T::zero(),
            Operation::Sum(a, b) => of(a)[k] + of(b)[k],
            Operation::Difference(a, b) => of(a)[k] - of(b)[k],
            Operation::Product(a, b) => convolved(a, b, 0..k + 1),
            Operation::Multiple(a, factor) => of(a)[k] * factor,
            Operation::Quotient(a, b) => (of(a)[k] - convolved(b, Node(node), 1..k + 1)) / of(b)[0],
            Operation::Root(a) => {
                (of(a)[k] - convolved(Node(node), Node(node), 1..k)) / (own[0] + own[0])
            }
            Operation::Exponential(a) => {
                let mut sum = T::zero();
                for j in self.both(a, Node(node), 1..k + 1, k) {
                    sum += T::lift(j as f64) * of(a)[j] * own[k - j];
                }
                sum / T::lift(k as f64)
            }
        }
    }
}

/// The value of a series at `t`.
pub fn at<T: Real>(series: &[T], t: T) -> T {
    let mut sum = T::zero();
    for coefficient in series.iter().rev() {
        sum = sum * t + *coefficient;
    }
    sum
}

/// The derivative of a series at `t`.
pub fn slope_at<T: Real>(series: &[T], t: T) -> T {
    let mut sum = T::zero();
    for (order, coefficient) in series.iter().enumerate().skip(1).rev() {
        sum = sum * t + *coefficient * T::lift(order as f64);
    }
    sum
}

/// Coefficients that tell how far a series may be followed.
const HIGHEST: usize = 4;

/// A series whose last coefficient is smaller than this does not end there: those beyond are too small for numbers.
const VANISHING: f64 = 1e-200;

/// How far a series may be followed until what it leaves out is `part` of `size`: by the highest of its coefficients, as if those beyond went
/// on like them; several, because some may vanish. Infinite where it ends.
pub fn reach<T: Real>(series: &[T], size: f64, part: f64) -> f64 {
    let mut least = f64::INFINITY;
    let sizes = || series.iter().map(|c| c.to_f64().abs()).enumerate().rev();
    let last = sizes().find(|(_, size)| *size > 0.0);
    let beyond = match last {
        Some((order, size)) if size < VANISHING => series.len() - 1 - order,
        _ => 0,
    };
    for (order, coefficient) in sizes().skip(beyond).take(HIGHEST) {
        if order > 0 && coefficient > 0.0 {
            // in logarithms: the coefficient may be beyond the range of what it is divided by
            let ratio = (part.ln() + size.ln() - coefficient.ln()) / order as f64;
            least = least.min(ratio.exp());
        }
    }
    least
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{DoubleDouble, Octuple};

    #[test]
    fn a_pendulum_of_small_amplitude_is_a_sine() {
        // x'' = -x
        let mut tape = Tape::<DoubleDouble>::new();
        let x = tape.input(DoubleDouble::lift(0.0));
        let v = tape.input(DoubleDouble::lift(1.0));
        let back = tape.multiple(x, DoubleDouble::lift(-1.0));
        tape.derive(x, v);
        tape.derive(v, back);
        tape.solve(30, DoubleDouble::lift(1.0));
        let t = DoubleDouble::lift(0.5);
        let (sine, cosine) = (at(tape.series(x), t), at(tape.series(v), t));
        let one = sine * sine + cosine * cosine;
        assert!((one - DoubleDouble::lift(1.0)).to_f64().abs() < 1e-30);
        assert!((sine.to_f64() - 0.5_f64.sin()).abs() < 1e-16);
        let slope = slope_at(tape.series(x), t) - cosine;
        assert!(slope.to_f64().abs() < 1e-30);
    }

    #[test]
    fn roots_quotients_and_powers_of_e_hold_their_defining_equations() {
        // y' = y / (1 + t) has y = 1 + t; r = sqrt(y), q = t / y, z = exp(q)
        let mut tape = Tape::<Octuple>::new();
        let one = tape.constant(Octuple::lift(1.0));
        let t = tape.input(Octuple::lift(0.0));
        tape.derive(t, one);
        let y = tape.sum(one, t);
        let (r, q) = (tape.root(y), tape.quotient(t, y));
        let z = tape.exponential(q);
        tape.solve(60, Octuple::lift(1.0));
        let h = Octuple::lift(0.03125);
        let (y, r, q, z) = (
            at(tape.series(y), h),
            at(tape.series(r), h),
            at(tape.series(q), h),
            at(tape.series(z), h),
        );
        for (got, want) in [(r * r, y), (q * y, h), (z, (h / y).exp())] {
            let error = (got - want).to_f64().abs();
            assert!(error < 1e-68, "{error:e}");
        }
    }

    #[test]
    fn unknowns_of_a_linear_system_solve_it_at_all_times() {
        // (1 + t) a + t b = 1, 2 a - b = exp t, rows that need exchanging at time 0 for none
        let mut tape = Tape::<DoubleDouble>::new();
        let number = |x: f64| DoubleDouble::lift(x);
        let (one, two) = (tape.constant(number(1.0)), tape.constant(number(2.0)));
        let t = tape.input(number(0.0));
        tape.derive(t, one);
        let (up, minus) = (tape.sum(one, t), tape.constant(number(-1.0)));
        let power = tape.exponential(t);
        let found = tape.solution(&[vec![up, t], vec![two, minus]], &[one, power]);
        tape.solve(40, number(1.0));
        let h = number(0.015625);
        let [a, b] = [0, 1].map(|i| at(tape.series(found[i]), h));
        let first = (number(1.0) + h) * a + h * b - number(1.0);
        let second = number(2.0) * a - b - at(tape.series(power), h);
        for error in [first, second] {
            assert!(error.to_f64().abs() < 1e-30, "{:e}", error.to_f64());
        }
    }

    #[test]
    fn a_series_too_small_for_numbers_does_not_end() {
        // sine by powers of 1e-57 s: its coefficients leave the range of numbers after the fifth order
        let mut tape = Tape::<f64>::new();
        let (x, v) = (tape.input(0.0), tape.input(1.0));
        let back = tape.multiple(x, -1.0);
        tape.derive(x, v);
        tape.derive(v, back);
        tape.solve(14, 1e-57);
        let sine = tape.series(x);
        let far = reach(sine, 1.0, 1e-12);
        assert!(far > 1e-4 / 1e-57, "{far:e}");
        let error = (at(sine, far) - (far * 1e-57).sin()).abs();
        assert!(error < 1e-12, "{error:e} at {far:e}");
    }

    #[test]
    fn another_unit_of_time_gives_the_same_values() {
        // x' = x^2 from 1: 1 / (1 - t)
        let value = |unit: f64| {
            let mut tape = Tape::<f64>::new();
            let x = tape.input(1.0);
            let square = tape.product(x, x);
            tape.derive(x, square);
            tape.solve(40, unit);
            at(tape.series(x), 0.25 / unit)
        };
        for unit in [1.0, 0.125, 8.0] {
            let error = (value(unit) - 1.0 / 0.75).abs();
            assert!(error < 1e-15, "{unit}: {error:e}");
        }
    }

    #[test]
    fn what_a_series_leaves_out_is_what_its_reach_says() {
        // 1 / (1 - t)
        let series = vec![1.0; 21];
        for part in [1e-6, 1e-12] {
            let h = reach(&series, 1.0, part);
            let error = (at(&series, h) - 1.0 / (1.0 - h)).abs();
            assert!(error < 2.0 * part && error > 1e-4 * part, "{h}: {error:e}");
        }
        assert_eq!(
            reach(&[1.0, 2.0, 0.0, 0.0, 0.0, 0.0], 1.0, 1e-16),
            f64::INFINITY
        );
    }
}
