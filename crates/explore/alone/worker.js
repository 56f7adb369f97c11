// Answers requests with the program, one after the other, and passes its output to the page at once.
const text = new TextEncoder();
/** The kinds of output of the program: an event, and the media type and the content of an answer. */
const TOLD = ["event", "kind", "content"];

let running = null;

async function start(compiled) {
  let memory;
  const answer = {};
  const own = {
    now: () => performance.now() / 1000,
    tell: (what, at, length) => {
      const bytes = new Uint8Array(memory.buffer, at, length).slice();
      if (TOLD[what] === "event") postMessage({ event: bytes });
      else answer[TOLD[what]] = bytes;
    },
  };
  const { exports } = await WebAssembly.instantiate(compiled, { page: own });
  memory = exports.memory;
  return ({ path, body }) => {
    const [name, asked] = [path, body].map((one) => text.encode(one));
    const at = exports.room(name.length + asked.length);
    const room = new Uint8Array(memory.buffer, at, name.length + asked.length);
    room.set(name);
    room.set(asked, name.length);
    const status = exports.answer(name.length);
    return { status, kind: new TextDecoder().decode(answer.kind), content: answer.content };
  };
}

globalThis.onmessage = async ({ data }) => {
  try {
    running ??= start(data.compiled);
    const answered = await running;
    postMessage(answered(data));
  } catch {
    // The page would never notice an error in a promise.
    postMessage({ lost: true });
  }
};
