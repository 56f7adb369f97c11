//! Tests of measurements: how files of them are read, and what is identified from synthetic ones.

mod programs;
mod read;
mod several;
mod synthetic;
mod walls;
