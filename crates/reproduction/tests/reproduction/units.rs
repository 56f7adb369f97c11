//! Tests that an oscillator has the same tables in other units, except for the units of their columns.

use grazing_input::Description;
use grazing_model::smooth::Stop;
use grazing_results::branches::OneParameter;
use grazing_results::{Cell, Table, Tables};
use grazing_unfold::progress::Silent;
use grazing_unfold::unfolded::Unfolded;

/// A hardening spring with a reset law in which all coefficients vary; `length` and `time` are the units
/// of the text. Two one-parameter diagrams, one in each direction, cross its resonances of p = 1 and 2.
pub(crate) fn written(length: f64, time: f64) -> Description {
    let (force, frequency) = (length / time / time, 1.0 / time);
    let text = format!(
        "name = \"Test\"\n[parameters]\nl = {length:e}\nw = {frequency:e}\nf = {force:e}\n\
         [primary]\nname = \"A\"\nrange = [{:e}, {:e}]\n[secondary]\nname = \"omega\"\nrange = [{:e}, {:e}]\n\
         [motion]\nforce = \"f*(-0.1*v/(l*w) - x/l - 0.1*(x/l)^3 - 1) + A*cos(1.25*omega*t)\"\nfrequency = \"1.25*omega\"\n\
         [impact]\nrestitution = \"0.9 + 0.05*sin(z) - 0.01*y/(l*w)\"\nduration = \"0.02/(l*w)\"\n\
         [analysis]\nloops = [1, 2]\n\
         [[diagrams]]\nfixed = \"omega\"\nat = {:e}\nrange = [{:e}, {:e}]\nportraits = [{:e}]\n\
         [[diagrams]]\nfixed = \"A\"\nat = {:e}\nrange = [{:e}, {:e}]\n",
        0.25 * force,
        1.25 * force,
        0.4375 * frequency,
        0.75 * frequency,
        0.625 * frequency,
        0.25 * force,
        0.75 * force,
        0.5 * force,
        0.5 * force,
        0.625 * frequency,
        0.6875 * frequency,
    );
    Description::parse(&text, "test.toml").unwrap_or_else(|error| panic!("{error}"))
}

fn tables(description: &Description) -> Vec<Table> {
    let unfolded = Unfolded::described(description, &Silent, &Stop::default(), &|_| ())
        .expect("there is grazing in the window");
    assert!([1, 2].iter().all(|p| unfolded.resonances.iter().any(|at| at.loops == *p)));
    let (names, diagram) = (&unfolded.axes.names, unfolded.plane_diagram());
    [
        unfolded.along_grazing().tables(names),
        diagram.tables(names),
        unfolded.at_resonances().tables(names),
        unfolded.magnifications(&diagram).tables(names),
        OneParameter::tables_of(&unfolded.diagrams, names),
    ]
    .concat()
}

/// The powers of length and time in a column's unit; the primary parameter is a force per mass and the
/// secondary one a frequency.
fn dimension(unit: &str) -> [i32; 2] {
    let (above, below) = unit.split_once('/').unwrap_or((unit, ""));
    let powers = |factors: &str| {
        let mut powers = [0, 0];
        for factor in factors.split([' ', '*']).filter(|factor| !factor.is_empty()) {
            let (base, power) =
                factor.split_once('^').map_or((factor, 1), |(base, power)| (base, power.parse().unwrap()));
            let [length, time] = match base {
                "length" => [1, 0],
                "time" => [0, 1],
                "{primary}" => [1, -2],
                "{secondary}" => [0, -1],
                "1" | "rad" => [0, 0],
                unknown => panic!("{unknown}"),
            };
            powers = [powers[0] + power * length, powers[1] + power * time];
        }
        powers
    };
    let (above, below) = (powers(above), powers(below));
    [above[0] - below[0], above[1] - below[1]]
}

/// The powers of length and time in the value of a hypothesis.
pub(crate) fn dimension_of_hypothesis(hypothesis: &Cell) -> [i32; 2] {
    let Cell::Text(hypothesis) = hypothesis else { panic!("{hypothesis:?}") };
    match hypothesis.split(' ').next().unwrap() {
        "omega" => [0, -1],
        "gamma" => [1, -2],
        "beta" => [0, 2],
        "a12'" => [1, 1],
        "kappa_p'" => [0, 1],
        "a12" => [1, 0],
        _ => [0, 0],
    }
}

#[test]
fn tables_in_other_units_are_the_same_to_the_last_bit_but_for_the_units() {
    // Powers of two do not change roundings; with a factor of one an expression would be simplified.
    let (first, second) = ([4.0, 4.0], [1024.0, 1.0 / 64.0]);
    let [plain, other] = [first, second].map(|[length, time]| tables(&written(length, time)));
    let [length, time] = [second[0] / first[0], second[1] / first[1]];
    let mut numbers = 0;
    for (plain, other) in plain.iter().zip(&other) {
        assert_eq!((plain.name, plain.rows.len()), (other.name, other.rows.len()));
        let hypotheses = plain.position("hypothesis");
        for (values, scaled) in plain.rows.iter().zip(&other.rows) {
            for (place, column) in plain.columns.iter().enumerate() {
                let [l, t] = match hypotheses {
                    Some(hypothesis) if column.name == "value" => {
                        dimension_of_hypothesis(&values[hypothesis])
                    }
                    _ => dimension(column.unit),
                };
                match (&values[place], &scaled[place]) {
                    (Cell::Number(value), Cell::Number(found)) => {
                        let wanted = value * libm::pow(length, f64::from(l)) * libm::pow(time, f64::from(t));
                        let same = *found == wanted || found.is_nan() && wanted.is_nan();
                        assert!(same, "{}.{}: {found} and not {wanted}", plain.name, column.name);
                        numbers += 1;
                    }
                    (Cell::Text(value), Cell::Text(found)) if column.name.ends_with("reason") => {
                        assert_eq!(value.is_empty(), found.is_empty());
                    }
                    (value, found) => assert_eq!(value, found, "{}.{}", plain.name, column.name),
                }
            }
        }
    }
    assert!(numbers > 10_000 && plain.iter().all(|table| !table.rows.is_empty()), "{numbers}");
}
