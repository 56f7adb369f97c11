// Whether anything is still to come: a timer that runs, an answer of the program, a frame. The document says so in
// its attribute `data-busy`, with which it begins.
let count = 0;

/** Something is to come, until the function that is returned is called. */
export function begin() {
  let ended = false;
  const counted = (by) => {
    count += by;
    document.documentElement.toggleAttribute("data-busy", count > 0);
  };
  counted(1);
  return () => {
    if (!ended) counted(-1);
    ended = true;
  };
}
