//! Impact oscillators as hybrid systems: flow, reset law, Poincaré maps and orbits with impacts.
