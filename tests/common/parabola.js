"use strict";
// Stands in for model.js: a parabola that sags, hangs beyond a span of 15 mm (14 mm in full) and diverges beyond a gravity of 30 m/s^2.
async function instantiate(source) {
  const made = await WebAssembly.instantiate(source, {});
  return made.instance || made;
}
function solve(data, module, state, resolution) {
  const begun = performance.now(), { span, gravity, duration } = {
    span: state.values["filament.span"], gravity: state.values["load.gravity"], duration: state.values["run.duration"],
  };
  if (span > 0.018) throw new Error("memory access out of bounds");
  if (span > 0.015 || (span > 0.014 && resolution.cells > 20)) for (;;);
  const diverged = gravity > 30, frames = diverged ? 20 : resolution.frames, cells = 2 * resolution.cells, nodes = cells + 1;
  const deep = 2000 * gravity * span ** 3, fields = {};
  for (const name of ["x", "y"]) fields[name] = new Float64Array(frames * nodes);
  for (const name of ["thickness", "stretch", "yielded_fraction"]) fields[name] = new Float64Array(frames * cells);
  const time = new Float64Array(frames), midpoint = new Float64Array(frames), X = Float64Array.from({ length: nodes }, (_, k) => k / cells - 0.5);
  for (let frame = 0; frame < frames; frame++) {
    time[frame] = (duration * frame) / (resolution.frames - 1);
    midpoint[frame] = -deep * (1 - Math.exp((-5 * frame) / resolution.frames)) * (1 + 0.2 * Math.sin(frame / 9) * Math.exp(-frame / 40));
    X.forEach((at, k) => { fields.x[frame * nodes + k] = span * at; fields.y[frame * nodes + k] = midpoint[frame] * (1 - 4 * at * at); });
    for (let k = 0; k < cells; k++) {
      const away = Math.abs(X[k] + 0.5 / cells);
      fields.thickness[frame * cells + k] = 0.0004 * (1 - 0.3 * away * (frame / resolution.frames));
      fields.stretch[frame * cells + k] = 1;
      fields.yielded_fraction[frame * cells + k] = Math.max(0, Math.min(1, (20 * (away - 0.4) * frame) / resolution.frames));
    }
  }
  const verdict = diverged
    ? { outcome: "non_finite", is_success: false, advice: data.words.outcomes.non_finite, message: `why: ${data.title}` }
    : { outcome: "computed", is_success: true, advice: "", message: "" };
  return {
    code: 0, reached: time[frames - 1], steps: frames, time, midpoint, nodes, cells, X_node: X, fields, verdict, sag: deep,
    milliseconds: performance.now() - begun,
  };
}
function tomlOf(data, state) { return `title = ${JSON.stringify(data.title)}\n[filament]\nspan = "${state.values["filament.span"]} m"\n`; }
function csvOf(run) { return `t,midpoint\n${Array.from(run.time, (t, k) => `${t},${run.midpoint[k]}`).join("\n")}\n`; }
function linkOf(data, state) { return new URLSearchParams(Object.entries(state.values)).toString(); }
const ownState = ({ keys }) => ({ values: { ...keys } });
function stateOf(data, hash) {
  const asked = new URLSearchParams(hash.slice(1)), { values } = ownState(data);
  for (const { key } of data.sliders) if (Number(asked.get(key))) values[key] = Number(asked.get(key));
  return { values };
}
