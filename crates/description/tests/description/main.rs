//! Descriptions of oscillators: accepted texts, messages about mistakes, and the examples.

mod evaluation;
mod examples;
mod literature;
mod messages;
mod random_texts;
mod sizes;
mod third_order;
mod walls;
