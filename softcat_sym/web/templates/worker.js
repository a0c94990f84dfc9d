// In the worker, behind model.js: one run at a time.
let data, ready;
onmessage = async ({ data: asked }) => {
  try {
    if (asked.module) {
      data = asked.data;
      ready = instantiate(asked.module);
      await ready;
      return;
    }
    const run = solve(data, await ready, asked.state, asked.resolution), moved = [];
    // Whole buffers go over without a copy.
    (function collect(value) {
      if (ArrayBuffer.isView(value)) { if (value.byteLength === value.buffer.byteLength) moved.push(value.buffer); }
      else if (value && typeof value === "object") Object.values(value).forEach(collect);
    })(run);
    postMessage({ run }, [...new Set(moved)]);
  } catch (error) {
    postMessage({ error: String(error.message || error) });
  }
};
