//! Numerical continuation of maximal periodic solutions and of their bifurcations.
