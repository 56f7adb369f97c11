//! From the parts of an expression to the instructions on its tape.

use super::graph::Node;
use super::{Code, Instruction, Operation, Slot, Tape};

/// The computation for one node, from other nodes by number, or from slots.
enum Plan {
    /// Nothing: a variable, or a part of a sum that is computed with it.
    Nothing,
    Plain(Operation<usize>),
    Sum(Vec<(f64, usize)>, f64),
}

impl Plan {
    fn operands(&self) -> Vec<usize> {
        match self {
            Plan::Nothing => Vec::new(),
            Plan::Plain(operation) => operation.operands(),
            Plan::Sum(terms, _) => terms.iter().map(|(_, operand)| *operand).collect(),
        }
    }
}

/// The tape of a list of nodes, each of which comes after its operands; the results are those of some.
pub(super) fn tape(variables: &[&str], moving: usize, nodes: &[Node], results: &[usize]) -> Tape {
    let variables: Vec<String> = variables.iter().map(|&name| name.to_owned()).collect();
    let plans = plans(nodes, results);
    let mut moves = vec![false; nodes.len()];
    for (index, (node, plan)) in nodes.iter().zip(&plans).enumerate() {
        moves[index] = match node {
            Node::Variable(number) => *number < moving,
            Node::Operation(_) => plan.operands().iter().any(|&operand| moves[operand]),
        };
    }
    // Nodes without a computation have no slot.
    let mut slots: Vec<Slot> = vec![Slot::MAX; nodes.len()];
    let (mut whole, mut held) = (Code::default(), 0);
    for pass in [false, true] {
        for (index, (node, plan)) in nodes.iter().zip(&plans).enumerate() {
            if let Node::Variable(number) = node {
                slots[index] = *number;
            } else if moves[index] == pass && whole.add(plan, |operand| slots[operand]) {
                slots[index] = variables.len() + whole.instructions.len() - 1;
            }
        }
        if !pass {
            held = whole.instructions.len();
        }
    }
    whole.results = results.iter().map(|&result| slots[result]).collect();
    Tape::new(variables, moving, whole, held)
}

impl Tape {
    /// The tape of a code, whose first `held` instructions do not depend on the moving variables.
    pub(super) fn new(variables: Vec<String>, moving: usize, whole: Code, held: usize) -> Self {
        let plans: Vec<Plan> = whole.instructions[held..].iter().map(|made| whole.plan(made)).collect();
        let results = variables.len() + held;
        let mut needed: Vec<Slot> = plans.iter().flat_map(Plan::operands).collect();
        needed.extend(&whole.results);
        needed.retain(|slot| (moving..results).contains(slot));
        needed.sort_unstable();
        needed.dedup();
        let place = |slot: Slot| match needed.binary_search(&slot) {
            Ok(place) => moving + place,
            Err(_) if slot < moving => slot,
            Err(_) => slot - results + moving + needed.len(),
        };
        let results = whole.results.iter().map(|&slot| place(slot)).collect();
        let mut rest = Code { results, ..Code::default() };
        for plan in &plans {
            rest.add(plan, place);
        }
        Self { variables, whole, held, moving, needed, rest }
    }
}

impl Code {
    /// The computation of an instruction, from slots.
    fn plan(&self, instruction: &Instruction) -> Plan {
        match *instruction {
            Instruction::Plain(operation) => Plan::Plain(operation),
            Instruction::Sum { start, end, constant } => Plan::Sum(self.terms[start..end].to_vec(), constant),
        }
    }

    /// Adds the instruction of a plan; returns false if there is none.
    fn add(&mut self, plan: &Plan, slot: impl Fn(usize) -> Slot) -> bool {
        self.instructions.push(match plan {
            Plan::Nothing => return false,
            Plan::Plain(operation) => Instruction::Plain(operation.on(slot)),
            Plan::Sum(terms, constant) => {
                let start = self.terms.len();
                self.terms.extend(terms.iter().map(|&(factor, operand)| (factor, slot(operand))));
                Instruction::Sum { start, end: self.terms.len(), constant: *constant }
            }
        });
        true
    }
}

/// The computation for each node; a sum includes all its parts that are not needed elsewhere, or results.
fn plans(nodes: &[Node], results: &[usize]) -> Vec<Plan> {
    let mut uses = vec![0_u32; nodes.len()];
    results.iter().for_each(|&result| uses[result] += 1);
    for node in nodes {
        if let Node::Operation(operation) = node {
            operation.operands().into_iter().for_each(|operand| uses[operand] += 1);
        }
    }
    let parts = Parts { nodes, uses };
    let mut absorbed = vec![false; nodes.len()];
    let mut plans: Vec<Plan> = Vec::with_capacity(nodes.len());
    // Wholes before their parts.
    for (index, node) in nodes.iter().enumerate().rev() {
        plans.push(match node {
            Node::Operation(operation) if !absorbed[index] => match parts.sum(index, &mut absorbed) {
                Some((terms, constant)) => Plan::Sum(terms, constant),
                None => Plan::Plain(*operation),
            },
            _ => Plan::Nothing,
        });
    }
    plans.reverse();
    plans
}

struct Parts<'a> {
    nodes: &'a [Node],
    uses: Vec<u32>,
}

impl Parts<'_> {
    fn operation(&self, index: usize) -> Option<Operation<usize>> {
        match self.nodes[index] {
            Node::Operation(operation) => Some(operation),
            Node::Variable(_) => None,
        }
    }

    /// The terms of a sum that absorbs at least one part, and its constant.
    fn sum(&self, whole: usize, absorbed: &mut [bool]) -> Option<(Vec<(f64, usize)>, f64)> {
        let mut terms = Vec::new();
        let mut constant = 0.0;
        let mut taken = Vec::new();
        let mut rest = whole;
        // From the last term to the first.
        while rest == whole || self.uses[rest] == 1 {
            let (left, right) = match self.operation(rest) {
                Some(Operation::Add(a, b)) => (a, Some((1.0, b))),
                Some(Operation::Subtract(a, b)) => (a, Some((-1.0, b))),
                Some(Operation::Shift(a, value)) => {
                    constant += value;
                    (a, None)
                }
                _ => break,
            };
            if rest != whole {
                taken.push(rest);
            }
            if let Some((sign, right)) = right {
                terms.push(self.term(sign, right, &mut taken));
            }
            rest = left;
        }
        if rest == whole {
            return None;
        }
        match self.operation(rest) {
            Some(Operation::Constant(value)) if self.uses[rest] == 1 => {
                constant += value;
                taken.push(rest);
            }
            _ => terms.push(self.term(1.0, rest, &mut taken)),
        }
        if taken.is_empty() || terms.is_empty() {
            return None;
        }
        for part in taken {
            absorbed[part] = true;
        }
        terms.reverse();
        Some((terms, constant))
    }

    /// A number times a node; the node's own factor is included if the product is not needed
    /// elsewhere.
    fn term(&self, sign: f64, index: usize, taken: &mut Vec<usize>) -> (f64, usize) {
        let (factor, operand) = match self.operation(index) {
            Some(Operation::Scale(a, factor)) if self.uses[index] == 1 => (factor, a),
            Some(Operation::Negate(a)) if self.uses[index] == 1 => (-1.0, a),
            _ => return (sign, index),
        };
        taken.push(index);
        (sign * factor, operand)
    }
}
