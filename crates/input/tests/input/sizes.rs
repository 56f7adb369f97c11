//! The cost of reading grows no faster than the text.

use grazing_input::Description;

/// A description whose wall position is a chain of these parts.
fn described(part: fn(u32) -> String, operator: &str, count: u32) -> Description {
    let chain = (1..=count).map(part).collect::<Vec<_>>().join(operator);
    let text = format!(
        "name = \"Test\"\n[parameters]\n[primary]\nname = \"A\"\nrange = [0.1, 1.5]\n[secondary]\nname = \"omega\"\n\
         range = [0.4, 1.1]\n[motion]\nforce = \"A*cos(omega*t) - x - 1\"\nfrequency = \"omega\"\n[wall]\n\
         position = \"1e-3*({chain})\"\n[impact]\nrestitution = \"0.9\"\nduration = \"0\"\n[analysis]\nloops = [1]\n"
    );
    Description::parse(&text, "test.toml").unwrap_or_else(|error| panic!("{operator} {count}: {error}"))
}

#[test]
fn the_acceleration_of_a_wall_has_instructions_in_proportion_to_its_position() {
    let parts: [fn(u32) -> String; 5] = [
        |k| format!("cos({k}*omega*t)"),
        |k| format!("(2 + sin({k}*omega*t))"),
        |k| format!("sqrt(3 + cos({k}*omega*t))"),
        |k| format!("exp(sin({k}*omega*t)/{k})"),
        |k| format!("tanh(atan(cos({k}*omega*t)))^3"),
    ];
    for (number, part) in parts.into_iter().enumerate() {
        for operator in ["+", "*", "/"] {
            // Zeros of the parts are poles of their quotients.
            if operator == "/" && [0, 4].contains(&number) {
                continue;
            }
            let [small, large] = [40, 80].map(|count| {
                let described = described(part, operator, count);
                let [force, ..] = described.formulas();
                force.instructions()
            });
            // All but the first few operations are like the ones before.
            assert!(large <= 2 * small + 20, "{number} {operator}: {small} {large}");
            // Each operation adds a few instructions for either derivative.
            assert!(large <= 80 * 5 * 12, "{number} {operator}: {large}");
        }
    }
}
