//! Tests of the words in messages.

mod words;
