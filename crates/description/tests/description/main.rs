//! Descriptions of oscillators: what a text may say, what is said of its mistakes, and what the
//! examples come to.

mod evaluation;
mod examples;
mod literature;
mod messages;
mod random_texts;
mod sizes;
mod third_order;
mod walls;
