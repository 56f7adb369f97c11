//! The same oscillator in other units: all tables are the same but for the units of their columns.

use grazing_description::Description;
use grazing_reproduction::Table;
use grazing_reproduction::unfolded::Unfolded;
use grazing_unfold::progress::Silent;
use polars::prelude::{AnyValue, DataFrame};

/// A hardening spring, a reset law in which everything varies; length and time are units that the text counts in.
fn written(length: f64, time: f64) -> Description {
    let (force, frequency) = (length / time / time, 1.0 / time);
    let text = format!(
        "name = \"Test\"\n[parameters]\nl = {length:e}\nw = {frequency:e}\nf = {force:e}\n\
         [primary]\nname = \"A\"\nrange = [{:e}, {:e}]\n[secondary]\nname = \"omega\"\nrange = [{:e}, {:e}]\n\
         [motion]\nforce = \"f*(-0.1*v/(l*w) - x/l - 0.1*(x/l)^3 - 1) + A*cos(omega*t)\"\nfrequency = \"omega\"\n\
         [impact]\nrestitution = \"0.9 + 0.05*sin(z) - 0.01*y/(l*w)\"\nduration = \"0.02/(l*w)\"\n\
         [analysis]\nloops = [1, 2]\n",
        0.25 * force,
        1.25 * force,
        0.55 * frequency,
        0.75 * frequency,
    );
    Description::parse(&text, "test.toml").unwrap_or_else(|error| panic!("{error}"))
}

fn tables(description: &Description) -> Vec<Table> {
    let unfolded = Unfolded::described(description, &Silent).expect("there is grazing in the window");
    assert!(unfolded.resonances.len() == 1, "{}", unfolded.resonances.len());
    unfolded.tables().expect("the tables can be made")
}

/// The powers of length and time in the unit of a column, or of a hypothesis's value.
fn dimension(table: &str, column: &str, frame: &DataFrame, row: usize) -> [i32; 2] {
    // A is a force per mass, omega a frequency.
    match column {
        "A" | "A_graz" | "gamma" => [1, -2],
        "omega" | "omega_star" | "frequency" => [0, -1],
        "impact_velocity" => [1, -1],
        "max_interior_x" | "a12" | "xi" => [1, 0],
        "a21" => [-1, 0],
        "b1" | "beta" => [0, 2],
        "b2" => [-1, 2],
        "psi" => [-1, 1],
        "a12_prime" => [1, 1],
        "kappa_prime" => [0, 1],
        _ if column.starts_with("c_") => [1, 0],
        "value" if table == "hypotheses" => match frame.column("hypothesis").unwrap().get(row).unwrap() {
            AnyValue::String(hypothesis) => match hypothesis.split([' ']).next().unwrap() {
                "omega" => [0, -1],
                "gamma" => [1, -2],
                "beta" => [0, 2],
                "a12'" => [1, 1],
                "kappa_p'" => [0, 1],
                "a12" => [1, 0],
                _ => [0, 0],
            },
            other => panic!("{other}"),
        },
        _ => [0, 0],
    }
}

#[test]
fn tables_in_other_units_are_the_same_to_the_last_bit_but_for_the_units() {
    // Powers of two leave every rounding where it was; with ones an expression would be simplified.
    let (first, second) = ([4.0, 4.0], [1024.0, 1.0 / 64.0]);
    let [plain, other] = [first, second].map(|[length, time]| tables(&written(length, time)));
    let [length, time] = [second[0] / first[0], second[1] / first[1]];
    let mut numbers = 0;
    for (plain, other) in plain.iter().zip(&other) {
        assert_eq!((plain.name, plain.frame.shape()), (other.name, other.frame.shape()));
        for column in plain.frame.get_column_names() {
            let column = column.as_str();
            let [values, scaled] = [plain, other].map(|table| table.frame.column(column).unwrap());
            for row in 0..plain.frame.height() {
                match (values.get(row).unwrap(), scaled.get(row).unwrap()) {
                    (AnyValue::Float64(value), AnyValue::Float64(found)) => {
                        let [l, t] = dimension(plain.name, column, &plain.frame, row);
                        let wanted = value * libm::pow(length, f64::from(l)) * libm::pow(time, f64::from(t));
                        let same = found == wanted || found.is_nan() && wanted.is_nan();
                        assert!(same, "{}.{column}, row {row}: {found} and not {wanted}", plain.name);
                        numbers += 1;
                    }
                    (value, found) if column.ends_with("reason") => {
                        assert_eq!(value.to_string().is_empty(), found.to_string().is_empty());
                    }
                    (value, found) => assert_eq!(value, found, "{}.{column}, row {row}", plain.name),
                }
            }
        }
    }
    assert!(numbers > 1000);
}
