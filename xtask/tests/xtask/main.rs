//! What holds of the workspace: features of its libraries, and the workflows that check and release it.

mod features;
mod workflows;
