//! Descriptions of oscillators: accepted texts, messages about mistakes and the words in them, the examples,
//! and the part of a plane in which a description is valid.

mod evaluation;
mod examples;
mod flows;
mod harmonics;
mod literature;
mod messages;
mod part;
mod random_texts;
mod schema;
mod sizes;
mod third_order;
mod walls;
mod words;
