//! Names of parameters, and their symbols.

/// Greek letters by their names in LaTeX.
pub const GREEK: [(&str, char); 49] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ϵ'),
    ("varepsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("omicron", 'ο'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Alpha", 'Α'),
    ("Beta", 'Β'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Epsilon", 'Ε'),
    ("Zeta", 'Ζ'),
    ("Eta", 'Η'),
    ("Theta", 'Θ'),
    ("Iota", 'Ι'),
    ("Kappa", 'Κ'),
    ("Lambda", 'Λ'),
    ("Mu", 'Μ'),
    ("Nu", 'Ν'),
    ("Xi", 'Ξ'),
    ("Omicron", 'Ο'),
    ("Pi", 'Π'),
    ("Rho", 'Ρ'),
    ("Sigma", 'Σ'),
    ("Tau", 'Τ'),
    ("Upsilon", 'Υ'),
    ("Phi", 'Φ'),
    ("Chi", 'Χ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
];

/// The greatest number of constants that vary in a family.
pub const VARIED: usize = 3;

/// The names of the two parameters, and of further constants that vary.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Names {
    /// The name of the primary parameter μ.
    pub primary: String,
    /// The name of the secondary parameter η.
    pub secondary: String,
    /// The symbols of the primary parameter, of its value at grazing, and of the secondary parameter.
    symbols: [String; 3],
    units: UnitNames,
    /// Names and symbols of the constants that vary in a family, the last one last.
    varied: Vec<[String; 2]>,
    /// Whether motion takes place between two walls, so that tables say which is hit.
    two_walls: bool,
}

/// The names of units, as far as they are known.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct UnitNames {
    /// The unit of lengths.
    pub length: Option<String>,
    /// The unit of times.
    pub time: Option<String>,
    /// The unit of masses.
    pub mass: Option<String>,
    /// The unit of the primary parameter.
    pub primary: Option<String>,
    /// The unit of the secondary parameter.
    pub secondary: Option<String>,
}

/// A unit in label markup, with raised powers: `m/s^2` and `m/s²` become `m/s$^{2}$`.
pub fn raised(unit: &str) -> String {
    const RAISED: [(char, char); 4] = [('¹', '1'), ('²', '2'), ('³', '3'), ('⁻', '-')];
    let mut text = String::new();
    let mut characters = unit.chars().peekable();
    while let Some(character) = characters.next() {
        let power = |next: &char| RAISED.iter().find(|(raised, _)| raised == next).map(|(_, plain)| *plain);
        let mut exponent: String = power(&character).into_iter().collect();
        if character == '^' {
            while let Some(next) = characters.next_if(|next| next.is_ascii_digit() || *next == '-') {
                exponent.push(next);
            }
        } else if !exponent.is_empty() {
            while let Some(next) = characters.next_if(|next| power(next).is_some()) {
                exponent.extend(power(&next));
            }
        }
        match exponent.as_str() {
            "" => text.push(character),
            exponent => text.push_str(&format!("$^{{{exponent}}}$")),
        }
    }
    text
}

/// A title with its unit, if that has a name.
pub fn with_unit(title: &str, unit: Option<&str>) -> String {
    unit.map_or(title.to_owned(), |unit| format!("{title} ({unit})"))
}

impl Names {
    /// Names as they are in a file.
    pub fn new(primary: &str, secondary: &str) -> Self {
        let at_grazing = Symbol::read(primary).map(|symbol| symbol.lowered(&["graz"]).latex());
        let symbols = [symbol(primary), at_grazing, symbol(secondary)].map(Option::unwrap_or_default);
        Self {
            primary: primary.to_owned(),
            secondary: secondary.to_owned(),
            symbols,
            units: UnitNames::default(),
            varied: Vec::new(),
            two_walls: false,
        }
    }

    /// Says whether motion takes place between two walls; then tables have a column for the one that is hit.
    #[must_use]
    pub fn between_walls(self, two_walls: bool) -> Self {
        Self { two_walls, ..self }
    }

    /// Adds the names of the units.
    #[must_use]
    pub fn with_units(self, units: UnitNames) -> Self {
        Self { units, ..self }
    }

    /// Adds the names of the constants that vary in a family, at most [`VARIED`].
    #[must_use]
    pub fn with_varied(self, names: &[String]) -> Self {
        let varied = names.iter().map(|name| [name.clone(), symbol(name).unwrap_or_default()]).collect();
        Self { varied, ..self }
    }

    /// The names with the two parameters exchanged; the symbol at grazing still belongs to the same
    /// parameter.
    #[must_use]
    pub fn swapped(self) -> Self {
        let Self { primary, secondary, symbols: [first, at_grazing, second], units, varied, two_walls } =
            self;
        let units = UnitNames { primary: units.secondary, secondary: units.primary, ..units };
        let symbols = [second, at_grazing, first];
        Self { primary: secondary, secondary: primary, symbols, units, varied, two_walls }
    }

    /// The constants that vary, in label markup.
    pub fn varied_titles(&self) -> Vec<String> {
        let title = |[name, symbol]: &[String; 2]| match symbol.as_str() {
            "" => name.replace('$', ""),
            symbol => format!("${symbol}$"),
        };
        self.varied.iter().map(title).collect()
    }

    /// The names for the paper's oscillator: amplitude and frequency.
    pub fn of_the_paper() -> Self {
        let symbols = [r"\mathcal{A}", r"\mathcal{A}_{\mathrm{graz}}", r"\omega"].map(str::to_owned);
        Self { symbols, ..Self::new("amplitude", "omega") }
    }

    /// The columns of the two parameters, unless the figures of the paper have them, whose axes say which they are.
    pub fn columns(&self) -> Option<[String; 2]> {
        (*self != Self::of_the_paper()).then(|| [self.primary.clone(), self.secondary.clone()])
    }

    /// The two parameters in label markup: their symbols, or their names where there are none.
    pub fn shown(&self) -> [String; 2] {
        let [primary, _, secondary] = &self.symbols;
        [(primary, &self.primary), (secondary, &self.secondary)].map(|(symbol, name)| match symbol.as_str() {
            "" => name.replace('$', ""),
            symbol => format!("${symbol}$"),
        })
    }

    /// The two parameters as titles of axes in label markup, with their units.
    pub fn titles(&self) -> [String; 2] {
        let [primary, secondary] = self.shown();
        [self.titled(&primary, "{primary}"), self.titled(&secondary, "{secondary}")]
    }

    /// Whether the name of any unit is known.
    pub fn have_units(&self) -> bool {
        self.units != UnitNames::default()
    }

    /// The units of the two parameters in label markup, as far as they are known.
    pub fn parameter_units(&self) -> [Option<String>; 2] {
        [&self.units.primary, &self.units.secondary].map(|unit| unit.as_deref().map(raised))
    }

    /// The unit that a column declares, with the names of units inserted as far as they are known; an
    /// unknown unit of a parameter is replaced by the parameter's name.
    pub fn unit(&self, declared: &str) -> String {
        let UnitNames { length, time, mass, primary, secondary } = &self.units;
        let known = |unit: &Option<String>, otherwise: &str| match unit {
            // A product or quotient in a denominator is one unit.
            Some(unit) if unit.contains(['/', '*', '·', ' ']) => format!("({unit})"),
            Some(unit) => unit.clone(),
            None => otherwise.to_owned(),
        };
        let whole = [("length", length), ("time", time), ("{primary}", primary), ("{secondary}", secondary)];
        if let Some((_, Some(unit))) = whole.iter().find(|(word, _)| *word == declared) {
            return unit.clone();
        }
        let text = declared.replace("length", &known(length, "length")).replace("time", &known(time, "time"));
        text.replace("mass", &known(mass, "mass"))
            .replace("{primary}", &known(primary, &self.primary))
            .replace("{secondary}", &known(secondary, &self.secondary))
    }

    /// The unit that a column declares, if all its parts have names.
    pub fn named_unit(&self, declared: &str) -> Option<String> {
        let UnitNames { length, time, mass, primary, secondary } = &self.units;
        let of_motion = [("length", length), ("time", time), ("mass", mass)];
        let mut parts = of_motion.into_iter().chain([("{primary}", primary), ("{secondary}", secondary)]);
        let named = parts.all(|(part, name)| name.is_some() || !declared.contains(part));
        named.then(|| self.unit(declared))
    }

    /// A title in label markup with the unit that a column declares, if all its parts have names.
    pub fn titled(&self, title: &str, declared: &str) -> String {
        with_unit(title, self.named_unit(declared).map(|unit| raised(&unit)).as_deref())
    }

    /// The name of the grazing curve in label markup: the symbol of the primary parameter at grazing,
    /// unless that symbol consists of words.
    pub fn grazing_title(&self) -> String {
        let [primary, at_grazing, _] = &self.symbols;
        let in_words = primary.is_empty() || primary.starts_with(r"\mathrm");
        if in_words { "grazing".to_owned() } else { format!("${at_grazing}$") }
    }

    /// Replaces `{primary}`, `{secondary}`, `{varied1}` and so on by the names; if fewer constants vary,
    /// the last places are filled and the others are empty.
    pub fn put_into(&self, text: &str) -> String {
        let text = text.replace("{primary}", &self.primary).replace("{secondary}", &self.secondary);
        // A column that says which of two walls is hit is left out where there is one.
        if text.contains("{wall}") && !self.two_walls {
            return String::new();
        }
        let text = text.replace("{wall}", "wall");
        self.varied_put_into(text, 0)
    }

    fn varied_put_into(&self, mut text: String, which: usize) -> String {
        let first = VARIED - self.varied.len().min(VARIED);
        for slot in 0..VARIED {
            let word = slot.checked_sub(first).map_or("", |place| &self.varied[place][which]);
            text = text.replace(&format!("{{varied{}}}", slot + 1), word);
        }
        text
    }

    /// Replaces `{primary}`, `{secondary}`, `{varied1}` and so on by the LaTeX symbols, and
    /// `{primary_graz}` by the symbol of the primary parameter at grazing.
    pub fn symbols_put_into(&self, text: &str) -> String {
        let [primary, at_grazing, secondary] = &self.symbols;
        let text = text.replace("{primary}", primary);
        let text = text.replace("{primary_graz}", at_grazing).replace("{secondary}", secondary);
        self.varied_put_into(text, 1)
    }
}

/// The symbol of a parameter in LaTeX, without dollars; none for a name that is not an identifier of
/// ASCII letters, digits and underscores.
///
/// Names of Greek letters become these letters, single letters are italic, longer words upright. The text
/// after an underscore, and digits at the end of a part, become a subscript: `F_0` and `F0`, `omega_max`.
/// Words joined by underscores remain words: `forcing_amplitude`.
pub fn symbol(name: &str) -> Option<String> {
    Some(Symbol::read(name)?.latex())
}

/// The words of a text, of ASCII letters, digits and characters that `join` these, and each character between them.
pub fn words<'t>(text: &'t str, joins: &'t [char]) -> impl Iterator<Item = &'t str> {
    let between = |character: char| !character.is_ascii_alphanumeric() && !joins.contains(&character);
    text.split_inclusive(between).flat_map(move |piece| {
        let (word, character) = piece.split_at(piece.find(between).unwrap_or(piece.len()));
        [word, character].into_iter().filter(|piece| !piece.is_empty())
    })
}

/// Whether a character changes the direction in which the text after it, or around it, is written; in a
/// name from a file, such a character could make one text look like another.
pub fn directs(character: char) -> bool {
    matches!(character, '\u{200e}' | '\u{200f}' | '\u{61c}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// A name split into its base and its subscripts.
struct Symbol<'a> {
    /// The letter or the words of the base.
    base: Vec<&'a str>,
    lowered: Vec<&'a str>,
}

impl<'a> Symbol<'a> {
    fn read(name: &'a str) -> Option<Self> {
        if !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
            return None;
        }
        let mut parts = name.split('_').filter(|part| !part.is_empty());
        let (letters, digits) = without_digits(parts.next().filter(|head| !starts_with_digit(head))?);
        let mut symbol = Symbol { base: vec![letters], lowered: Vec::new() };
        symbol.lowered.extend(digits);
        for part in parts {
            let (letters, digits) = without_digits(part);
            if symbol.is_word() && symbol.lowered.is_empty() && is_word(letters) && !starts_with_digit(part) {
                symbol.base.push(letters);
                symbol.lowered.extend(digits);
            } else {
                symbol.lowered.push(part);
            }
        }
        Some(symbol)
    }

    /// Appends further subscripts.
    fn lowered(mut self, further: &[&'a str]) -> Self {
        self.lowered.extend(further);
        self
    }

    fn is_word(&self) -> bool {
        self.base.iter().all(|part| is_word(part))
    }

    fn latex(&self) -> String {
        let base = if self.is_word() {
            format!(r"\mathrm{{{}}}", self.base.join(" "))
        } else {
            self.base.iter().map(|part| letters(part)).collect()
        };
        if self.lowered.is_empty() {
            return base;
        }
        let lowered: Vec<String> = self
            .lowered
            .iter()
            .map(|part| {
                let (head, digits) = without_digits(part);
                format!("{}{}", letters(head), digits.unwrap_or_default())
            })
            .collect();
        format!("{base}_{{{}}}", lowered.join(","))
    }
}

/// The part without its trailing digits, and these digits if there are any; a part that consists of
/// digits is returned unchanged as digits.
fn without_digits(part: &str) -> (&str, Option<&str>) {
    let letters = part.trim_end_matches(|c: char| c.is_ascii_digit());
    let digits = &part[letters.len()..];
    (letters, (!digits.is_empty()).then_some(digits))
}

fn starts_with_digit(part: &str) -> bool {
    part.starts_with(|c: char| c.is_ascii_digit())
}

fn is_greek(part: &str) -> bool {
    GREEK.iter().any(|(name, _)| *name == part)
}

/// Whether the part is neither a single letter nor the name of a Greek letter.
fn is_word(part: &str) -> bool {
    part.len() > 1 && !is_greek(part)
}

/// The LaTeX of a part without trailing digits.
fn letters(part: &str) -> String {
    match part {
        greek if is_greek(greek) => format!(r"\{greek}"),
        word if is_word(word) => format!(r"\mathrm{{{word}}}"),
        letter => letter.to_owned(),
    }
}
