// Whether the page is busy: with a timer, an answer of the program, or a frame. The document shows it in its attribute
// `data-busy`, with which it begins.
let count = 0;

/** Makes the page busy until the returned function is called. */
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
