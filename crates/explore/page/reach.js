// Access to the program: the server that this page came from.

export const LOST = "The program does not respond. Is `grazing explore` still running?";

export const reach = (path, options) => fetch(`./${path}`, options);
