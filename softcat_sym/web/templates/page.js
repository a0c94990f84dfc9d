// The page: sliders ask for runs, a worker computes them, the newest is drawn; and the clock.
const byId = (id) => document.getElementById(id), main = document.querySelector("main");
const data = JSON.parse(byId("data").textContent);
const LONGEST = { preview: 5, resolution: 20 }; // seconds after which a run is stopped
const IDLE = 150; // ms without a move until the full resolution is asked for

let state, version = 0, shown = null;

// ---- Runs: one worker computes, another stands ready, so that a run can be dropped at once. ----
// While a slider moves, previews of where it was on the way end and are shown with their values; nothing else that is
// older than the sliders is ever shown.
const runs = { running: null, wanted: [], inFull: -1, moving: false, timer: 0, idle: 0 };
let compiled, address, worker, spare;

function spawn() {
  const made = new Worker(address);
  made.onmessage = ({ data: answer }) => { if (made === worker) answered(answer); };
  made.onerror = (event) => { event.preventDefault(); if (made === worker) answered({ error: event.message }); };
  made.postMessage({ module: compiled, data });
  return made;
}
function drop() {
  clearTimeout(runs.timer);
  runs.running = null;
  worker.terminate();
  [worker, spare] = [spare, spawn()];
}
function next() {
  if (runs.running || !runs.wanted.length) return;
  const job = (runs.running = { kind: runs.wanted.shift(), version, state: structuredClone(state) });
  runs.timer = setTimeout(overdue, 1000 * LONGEST[job.kind]);
  worker.postMessage({ state: job.state, resolution: data[job.kind] });
}
function answered({ run, error }) {
  const job = runs.running;
  if (!job) return;
  clearTimeout(runs.timer);
  runs.running = null;
  if (error) drop();
  if (job.version === version && error) {
    runs.wanted = [];
    show(null);
    tell(["The program failed with these values.", error, "Move a slider back, or reset."]);
  } else if (!error && (job.version === version || runs.moving)) show({ ...run, ...job });
  next();
}
function overdue() {
  const job = runs.running;
  drop();
  if (job.version === version) {
    [runs.wanted, runs.inFull] = [[], version];
    if (shown && shown.version !== version) show(null);
    writeResolution();
    tell([
      `The run was stopped after ${LONGEST[job.kind]} s without an end: move a slider back, or copy as scene.toml and let softcat run take its time.`,
      ...(shown ? ["What is shown is its preview."] : []),
    ]);
  }
  next();
}

function changed(moving) {
  version += 1;
  runs.moving = moving;
  runs.wanted = data.preview ? ["preview"] : [];
  if (runs.running && !(moving && runs.running.kind === "preview")) drop();
  sliders.forEach(writeSlider);
  clearTimeout(runs.idle);
  if (moving) runs.idle = setTimeout(settled, IDLE); else settled();
  mark();
  next();
}
// Let go, or left alone.
function settled() {
  clearTimeout(runs.idle);
  runs.moving = false;
  if (runs.running && runs.running.version !== version) drop();
  if (runs.inFull !== version) runs.wanted.push("resolution");
  runs.inFull = version;
  mark();
  next();
}
// Says of what is shown whether it is of the sliders as they stand.
function mark() {
  const old = shown !== null && shown.version !== version;
  main.dataset.shown = old || !shown ? "" : shown.kind;
  main.classList.toggle("behind", old && !runs.moving);
  const where = old ? sliders.filter(({ spec: { key } }) => shown.state.values[key] !== state.values[key]).map((slider) => `${slider.spec.name} ${slider.text(shown.state)}`) : [];
  byId("way").textContent = where.length ? `On the way, at ${where.join(", ")}` : "";
}

// ---- Parameters. ----
const SUPERSCRIPTS = { 2: "²", 3: "³", 4: "⁴" };
const written = (unit) => unit.replace(/\^([234])/g, (_, digit) => SUPERSCRIPTS[digit]).replace(/\*/g, "·");

const sliders = data.sliders.map((spec, k) => {
  const measure = spec.scale === "log" ? Math.log : (u) => u, back = spec.scale === "log" ? Math.exp : (u) => u;
  const low = measure(spec.low), high = measure(spec.high), unit = written(spec.unit);
  const range = `from ${significant(spec.low)} to ${significant(spec.high)} ${unit}`.trim();
  const row = element("div", "", "slider"), head = element("div"), body = element("div");
  const name = element("label", spec.name), output = element("b"); // an output would be read out at every move
  const handle = Object.assign(element("input"), { type: "range", min: 0, max: 1, step: 0.005, id: `slider-${k}` });
  const field = Object.assign(element("input"), { type: "text", inputMode: "decimal", autocomplete: "off", id: `field-${k}` });
  const wrong = Object.assign(element("p", "", "wrong"), { id: `wrong-${k}` });
  wrong.setAttribute("role", "alert");
  name.htmlFor = handle.id;
  handle.dataset.key = field.dataset.key = spec.key;
  row.title = `${spec.key}, ${range}`;
  field.setAttribute("aria-label", `${spec.name}${unit && ` in ${unit}`}, ${range}`);
  field.setAttribute("aria-describedby", wrong.id);
  head.append(name, output);
  body.append(handle, field, element("span", unit, "unit"));
  row.append(head, body, wrong);
  byId("sliders").append(row);
  const text = ({ values }) => `${significant(values[spec.key] / spec.si)} ${unit}`.trim();
  const slider = { spec, unit, handle, field, output, wrong, text, share: (u) => (measure(u) - low) / (high - low) };
  const accept = (u, moving) => {
    state.values[spec.key] = Number((u * spec.si).toPrecision(12));
    refuse(slider, "");
    changed(moving);
  };
  handle.addEventListener("input", () => {
    const u = back(low + Number(handle.value) * (high - low));
    slider.held = true; // the handle stays where the hand has it, beside the rounded value
    accept(Math.max(spec.low, Math.min(spec.high, Number(u.toPrecision(3)))), true);
    slider.held = false;
  });
  handle.addEventListener("pointerup", settled);
  field.addEventListener("change", () => {
    const given = field.value.trim(), u = Number(given.replace("−", "-"));
    const why = given === "" || !Number.isFinite(u) ? `“${given}” is no number` : u < spec.low || u > spec.high ? `${given} ${unit} is beyond the slider` : "";
    if (why) refuse(slider, `${why}: ${spec.name} goes ${range}, and stays at ${output.textContent}.`);
    else accept(u, false);
  });
  return slider;
});
function refuse({ field, wrong }, why) {
  field.setAttribute("aria-invalid", String(Boolean(why)));
  wrong.textContent = why;
}
function writeSlider({ spec, handle, field, output, text, share, held }) {
  const u = state.values[spec.key] / spec.si;
  if (!held) handle.value = share(u);
  output.textContent = text(state);
  handle.setAttribute("aria-valuetext", output.textContent);
  if (field.getAttribute("aria-invalid") !== "true") field.value = String(Number(u.toPrecision(6)));
}
// Every slider has a value: what a link leaves out is the scene's own.
function take(next) {
  state = next;
  sliders.forEach((slider) => refuse(slider, ""));
  changed(false);
}

byId("reset").addEventListener("click", () => take(ownState(data)));
window.addEventListener("hashchange", () => take(stateOf(data, location.hash)));

// ---- Results. ----
function tell(sentences) {
  if (byId("problem").textContent === sentences.join("")) return;
  byId("problem").replaceChildren(...sentences.map((sentence) => element("p", sentence)));
}
function rows(list, pairs) {
  list.replaceChildren(...pairs.map(([name, text]) => {
    const row = element("div");
    row.append(element("dt", name), element("dd", text));
    return row;
  }));
}

function show(run) {
  shown = run && { ...run, end: run.time.length ? run.time[run.time.length - 1] : 0 };
  mark();
  byId("csv").disabled = !shown;
  if (shown && !clock.begun && !matchMedia("(prefers-reduced-motion: reduce)").matches) { clock.share = 0; setPlaying(true); }
  clock.begun ||= shown !== null;
  if (shown) writeResults(); else { rows(byId("numbers"), []); byId("warnings").replaceChildren(); writeResolution(); }
  draw();
}

function writeResults() {
  const { verdict, midpoint, kind, fields: { x, y } } = shown, full = kind === "resolution", last = midpoint.length ? midpoint[midpoint.length - 1] : NaN;
  const { values } = shown.state, duration = values["run.duration"] ?? data.duration, end = x.length / midpoint.length - 1;
  const span = Math.hypot(x[end] - x[0], y[end] - y[0]), sags = last <= 0 && !data.ends.includes("free");
  const name = sags ? "sag" : "midpoint", place = lengthText(Math.abs(last)) + (sags ? "" : last > 0 ? " up" : " down");
  const pairs = [["outcome", verdict.outcome]];
  if (Number.isFinite(last)) pairs.push(verdict.is_success ? [`${name} at the end`, `${place}, ${significant((100 * Math.abs(last)) / span, 2)} % of the span`] : ["reached", `midpoint ${place} when the run ended: no answer`]);
  if (verdict.is_success) pairs.push([`largest ${name}`, lengthText(shown.sag)]);
  if (shown.reached < 0.999 * duration) pairs.push(["computed until", `${timeText(shown.reached)} of ${timeText(duration)}`]);
  rows(byId("numbers"), pairs);
  const notes = sliders.flatMap(({ spec: { key, name }, text }) => {
    const value = values[key], beyond = ({ above, below }) => (above !== null && value >= above) || (below !== null && value <= below);
    const words = data.notes.filter((note) => note.key === key && beyond(note)).map((note) => note.words);
    return words.length ? [`${name} ${text(shown.state)}: ${words.join("; ")}`] : [];
  });
  byId("warnings").replaceChildren(...notes.map((words) => element("li", words)));
  writeResolution(full ? "" : `; the full resolution follows, or is stopped after ${LONGEST.resolution} s`);
  // Whoever hears the page is told of what is let go, not of every move on the way.
  if (!full) { tell([]); return; }
  byId("said").textContent = pairs.map(([name, text]) => `${name} ${text}`).join("; ");
  tell(verdict.is_success ? [] : [`NOT TO BE TRUSTED (${verdict.outcome})`, `because: ${verdict.message}`, `advice: ${verdict.advice || "none"}`]);
  history.replaceState(null, "", hash());
}
function writeResolution(then = "") {
  if (!shown) { byId("resolution").textContent = ""; return; }
  const { cells, frames } = data[shown.kind], what = shown.kind === "preview" ? "a preview" : "the full resolution";
  byId("resolution").textContent = `Shown: ${what}, ${cells} cells${data.half ? " a half span" : ""}, ${frames} frames; computed in ${timeText(shown.milliseconds / 1000)}${then}.`;
}
function hash() { return `#${linkOf(data, state)}`; }

// ---- The clock: seconds of the filament, in real time where that can be watched. ----
const clock = { share: 1, playing: false, begun: false, last: 0 };
function slower() { return shown.end >= 1 && shown.end <= 20 ? 1 : rounded((shown.end < 1 ? 6 : 10) / shown.end); }
function tick(now) {
  if (!clock.playing) return;
  if (shown && shown.end) clock.share = Math.min(1, clock.share + Math.min(100, now - clock.last) / (1000 * shown.end * slower()));
  clock.last = now;
  draw();
  if (clock.share < 1) requestAnimationFrame(tick); else setPlaying(false);
}
function setPlaying(on) {
  byId("play").textContent = on ? "pause" : "play";
  if (on && clock.share >= 1) clock.share = 0;
  if (on && !clock.playing) { clock.last = performance.now(); requestAnimationFrame(tick); }
  clock.playing = on;
  draw();
}
function setShare(share) {
  clock.share = Math.max(0, Math.min(1, share));
  setPlaying(false);
}
byId("play").addEventListener("click", () => setPlaying(!clock.playing));
byId("time").addEventListener("input", () => setShare(Number(byId("time").value)));
document.addEventListener("keydown", (event) => {
  const { target, key } = event, range = target.type === "range";
  if (event.altKey || event.ctrlKey || event.metaKey || (!range && target.closest("input, select, textarea, button, summary"))) return;
  const move = { ArrowLeft: clock.share - 0.01, ArrowRight: clock.share + 0.01, Home: 0, End: 1 }[key];
  if (key === " ") setPlaying(!clock.playing); else if (!range && move !== undefined) setShare(move); else return;
  event.preventDefault();
});

// ---- Pictures. ----
const mixed = (share) => {
  const [from, to] = ["--strand", "--yielded"].map((name) => styleOf(name).split(",").map(Number));
  return `rgb(${from.map((start, c) => Math.round(start + share * (to[c] - start))).join(",")})`;
};
// At the nodes, what is known of the cells between them.
function atNodes(values, nodes) {
  if (values.length === nodes) return values;
  return Float64Array.from({ length: nodes }, (_, k) => (values[Math.max(0, k - 1)] + values[Math.min(values.length - 1, k)]) / 2);
}
function support(kind, pen, x, y, outwards, tall) {
  pen.strokeStyle = pen.fillStyle = styleOf("--quiet"); pen.lineWidth = 1.5;
  pen.beginPath();
  if (kind === "clamped") {
    const half = Math.max(14, 0.8 * tall);
    pen.moveTo(x, y - half); pen.lineTo(x, y + half);
    for (let at = -half; at < half; at += 6) { pen.moveTo(x, y + at); pen.lineTo(x + 6 * outwards, y + at + 6); }
  } else if (kind === "free") {
    pen.setLineDash([2, 2]); pen.arc(x, y, Math.max(6, 0.8 * tall), 0, 2 * Math.PI);
  } else {
    const under = y + tall / 2;
    pen.moveTo(x, under); pen.lineTo(x - 7, under + 12); pen.lineTo(x + 7, under + 12); pen.closePath();
  }
  pen.stroke(); pen.setLineDash([]);
}

function drawFilament(time) {
  const canvas = byId("filament"), { pen, width, height } = fresh(canvas), { fields } = shown;
  const frames = shown.time.length, nodes = fields.x.length / frames, { here, next, part } = between(shown.time, time);
  const bounds = (shown.bounds ??= boundsOf(fields.x.length, (k) => fields.x[k], (k) => fields.y[k]));
  if (!(bounds.right > bounds.left)) { byId("drawn").textContent = "no shape of this run"; return; }
  const at = (values) => {
    const count = values.length / frames;
    return Float64Array.from({ length: count }, (_, k) => values[here * count + k] + part * (values[next * count + k] - values[here * count + k]));
  };
  const x = at(fields.x), y = at(fields.y), thickness = atNodes(at(fields.thickness), nodes), thick = thickness.reduce((a, b) => Math.max(a, b));
  const view = viewOf(width, height - 24, { ...bounds, low: bounds.low - 0.6 * thick, high: bounds.high + 0.6 * thick }, 44, 44);
  const { px, py, scale } = view, last = nodes - 1;
  pen.setLineDash([2, 4]); pen.strokeStyle = styleOf("--quiet"); pen.lineWidth = 1;
  pen.beginPath();
  for (let k = 0; k < nodes; k++) pen[k ? "lineTo" : "moveTo"](px(fields.x[k]), py(fields.y[k]));
  pen.stroke();
  pen.setLineDash([]);
  const { ends } = data, yielded = fields.yielded_fraction && at(fields.yielded_fraction);
  const cell = yielded && yielded.length === nodes ? (k) => Math.round(k / PIECES) : (k) => Math.floor(k / PIECES);
  const shades = yielded && Array.from(yielded, (share) => mixed(Math.round(32 * Math.max(0, Math.min(1, share))) / 32)), plain = mixed(0);
  drawStrip(view, pen, x, y, thickness.map((each) => each * scale), (k) => (shades ? shades[cell(k)] : plain));
  if (ends[0]) support(ends[0], pen, px(x[0]), py(y[0]), -1, scale * thickness[0]);
  if (ends[1]) support(ends[1], pen, px(x[last]), py(y[last]), 1, scale * thickness[last]);
  byId("legend").hidden = !yielded;
  const bar = rounded((0.2 * width) / scale), long = bar * scale;
  pen.strokeStyle = pen.fillStyle = styleOf("--ink"); pen.lineWidth = 2;
  pen.beginPath(); pen.moveTo(10, height - 8); pen.lineTo(10 + long, height - 8); pen.stroke();
  pen.textAlign = "left"; pen.fillText(lengthText(bar), 16 + long, height - 4);
  byId("drawn").textContent = [
    scale * thick < THINNEST ? `true shape; drawn ${THINNEST} px thick, at this scale it has ${significant(scale * thick, 2)}` : "true shape and thickness",
    data.axes === 3 ? "seen along the horizontal across the span: what moves towards you or away is not seen" : "",
  ].filter(Boolean).join("; ");
  canvas.setAttribute("aria-label", `the filament at ${timeText(time) || "0 s"}: its midpoint is at ${lengthText(midpointAt(time))}`);
}
function midpointAt(time) {
  const { here, next, part } = between(shown.time, time), { midpoint } = shown;
  return midpoint[here] + part * (midpoint[next] - midpoint[here]);
}

let axis = null;
function draw() {
  if (!main.clientWidth) return; // no window yet, or none any more
  const drawable = shown && shown.end > 0;
  byId("time").value = String(clock.share);
  if (!drawable) {
    for (const id of ["filament", "midpoint"]) fresh(byId(id));
    byId("drawn").textContent = byId("now").textContent = byId("pace").textContent = "";
    if (version) byId("drawn").textContent = runs.running ? "computing …" : "no answer with these values";
    return;
  }
  const time = clock.share * shown.end, factor = slower();
  const unit = timeUnit(shown.end);
  byId("now").textContent = `${significant(time / unit[0], 3)} of ${measured(shown.end, unit)}`;
  byId("time").setAttribute("aria-valuetext", byId("now").textContent);
  byId("pace").textContent = factor === 1 ? "in real time" : factor > 1 ? `played ${significant(factor)} times slower than it moves` : `played ${significant(1 / factor)} times faster than it moves`;
  drawFilament(time);
  const curve = { time: shown.time, heights: shown.midpoint, colour: `rgb(${styleOf("--strand")})` };
  axis = drawMidpoint(byId("midpoint"), curve, { end: shown.end, now: time });
  byId("midpoint").setAttribute("aria-label", `height of the midpoint against time: from ${lengthText(shown.midpoint[0])} to ${lengthText(shown.midpoint[shown.midpoint.length - 1])} in ${timeText(shown.end)}`);
}
for (const kind of ["pointerdown", "pointermove"]) {
  byId("midpoint").addEventListener(kind, (event) => { if (event.buttons && axis && shown) setShare((event.offsetX - axis.left) / (axis.right - axis.left)); });
}

// ---- To take away. ----
async function copy(text, what) {
  byId("by-hand").hidden = true;
  try {
    await navigator.clipboard.writeText(text);
    byId("copied").textContent = `Copied ${what}.`;
  } catch {
    // Some browsers let no page copy that was opened from a file.
    byId("copied").textContent = "This browser does not let the page copy: the text is below, selected.";
    byId("by-hand").hidden = false;
    byId("text").value = text;
    byId("text").select();
  }
}
byId("toml").addEventListener("click", () => copy(tomlOf(data, state), "the scene"));
byId("link").addEventListener("click", () => copy(location.href.split("#")[0] + hash(), "the link"));
byId("csv").addEventListener("click", () => {
  const link = Object.assign(element("a"), { href: URL.createObjectURL(new Blob([csvOf(shown)], { type: "text/csv" })), download: `${data.name}.csv` });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
});

// ---- Beginning. ----
async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}
async function open() {
  const out = Object.entries(data.left_out || {}).map(([name, why]) => [`left out: ${name}`, why]);
  rows(byId("effects"), [...Object.entries(data.effects), ...out]);
  byId("accuracy").textContent = data.accuracy;
  byId("csv").disabled = true;
  try {
    compiled = await WebAssembly.compile(await unpacked(byId("module").textContent));
    address = URL.createObjectURL(new Blob([byId("model").textContent, byId("worker").textContent], { type: "text/javascript" }));
    [worker, spare] = [spawn(), spawn()];
  } catch (error) {
    tell(["This browser cannot compute the filament: it needs WebAssembly with SIMD and DecompressionStream, as Chrome 91, Firefox 113, Safari 16.4 and later have.", String(error.message || error)]);
    return;
  }
  take(stateOf(data, location.hash));
  const watch = new ResizeObserver(draw);
  document.querySelectorAll(".stage").forEach((stage) => watch.observe(stage));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
}
open();
