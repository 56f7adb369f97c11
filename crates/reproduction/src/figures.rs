//! The figures of the paper, a module each. The list of all figures, with those beyond the paper, is
//! `all_figures!` in `grazing_beyond`.

pub mod fig01;
pub mod fig02;
pub mod fig03;
pub mod fig04;
pub mod fig05;
pub mod fig06;
pub mod fig07;
pub mod fig08;
pub mod fig09;
pub mod fig10;
