// Access to the program: compiled to WebAssembly it runs in workers of this page, one for each open request. Aborting a
// request ends its worker.

export const LOST = "The program cannot run in this browser, or its files could not be loaded.";

document.documentElement.toggleAttribute("data-alone", true);

const program = fetch("./grazing.wasm").then(async (answer) => {
  if (!answer.ok) throw new Error(LOST);
  return WebAssembly.compile(await answer.arrayBuffer());
});
// The error is reported to the requests.
program.catch(() => {});

/** Workers that have answered, and wait for the next request. */
const idle = [];

export async function reach(path, { body, signal }) {
  if (body === undefined) return fetch(`./${path}`, { signal });
  const compiled = await program;
  signal?.throwIfAborted();
  const worker = idle.pop() ?? new Worker("./worker.js");
  return new Promise((resolve, reject) => {
    let events;
    const end = () => worker.terminate();
    const stream = new ReadableStream({ start: (controller) => (events = controller), cancel: end });
    const fail = (error) => {
      end();
      events.error(error);
      reject(error);
    };
    const abort = () => fail(new DOMException("it was aborted", "AbortError"));
    signal?.addEventListener("abort", abort, { once: true });
    worker.onerror = () => fail(new Error(LOST));
    worker.onmessage = ({ data: { lost, event, status, kind, content } }) => {
      if (lost) return fail(new Error(LOST));
      if (event) {
        events.enqueue(event);
        return resolve(new Response(stream));
      }
      signal?.removeEventListener("abort", abort);
      idle.push(worker);
      events.close();
      resolve(new Response(content, { status, headers: { "Content-Type": kind } }));
    };
    worker.postMessage({ compiled, path, body });
  });
}
