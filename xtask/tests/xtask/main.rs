//! What holds of the workspace: features of its libraries, the structure of its sources, and the workflows that check and release it.

mod features;
mod sources;
mod structure;
mod workflows;
