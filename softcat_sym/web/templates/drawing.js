"use strict";
// What the page draws with: numbers in words, sharp canvases, a filament, a midpoint.
function significant(value, digits = 4) {
  if (value === null || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e-3 && size < 1e5 ? String(Number(value.toPrecision(digits))) : value.toExponential(digits - 1);
  return text.replace("-", "−");
}

function timeUnit(seconds) {
  return seconds >= 300 ? [60, "min"] : seconds >= 1 || seconds === 0 ? [1, "s"] : seconds >= 1e-3 ? [1e-3, "ms"] : [1e-6, "µs"];
}
function lengthUnit(metres) {
  const size = Math.abs(metres);
  return size >= 1 ? [1, "m"] : size >= 1e-3 ? [1e-3, "mm"] : size >= 1e-7 || size === 0 ? [1e-6, "µm"] : [1e-9, "nm"];
}
function measured(value, [size, symbol]) { return `${significant(value / size, 3)} ${symbol}`; }
function timeText(seconds) { return Number.isFinite(seconds) ? measured(seconds, timeUnit(seconds)) : ""; }
function lengthText(metres) { return metres === 0 ? "0" : measured(metres, lengthUnit(metres)); }

function element(tag, text = "", className = "") {
  const made = document.createElement(tag);
  made.textContent = text;
  if (className) made.className = className;
  return made;
}

function styleOf(name) { return getComputedStyle(document.documentElement).getPropertyValue(name).trim(); }

// A canvas as sharp as the screen, cleared; drawing is in CSS pixels.
function fresh(canvas) {
  const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  const size = [Math.round(width * ratio), Math.round(height * ratio)];
  const pen = canvas.getContext("2d");
  if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  pen.setLineDash([]);
  pen.font = '11px "DejaVu Sans", Verdana, sans-serif';
  return { pen, width, height };
}

// The frames before and after a place among increasing ones, and the part of the way from one to the other.
function between(at, place) {
  let low = 0, high = Math.max(0, at.length - 2);
  while (low < high) { const k = (low + high + 1) >> 1; if (at[k] <= place) low = k; else high = k - 1; }
  const next = Math.min(low + 1, at.length - 1), gap = at[next] - at[low];
  return { here: low, next, part: gap > 0 ? Math.max(0, Math.min(1, (place - at[low]) / gap)) : 0 };
}

const PIECES = 4;
// Pieces between two nodes: cubics over the length of the chord, whose slopes are those of the parabola through
// three nodes. The nodes stand closer at the clamps, so a cubic over their number would overshoot.
function smoothed(x, y) {
  const count = x.length, length = [0];
  for (let k = 1; k < count; k++) length.push(length[k - 1] + (Math.hypot(x[k] - x[k - 1], y[k] - y[k - 1]) || 1e-300));
  return [x, y].map((values) => {
    const chord = (k) => (values[k + 1] - values[k]) / (length[k + 1] - length[k]);
    const slope = Array.from(values, (_, k) => {
      if (k === 0 || k === count - 1) return chord(k ? k - 1 : 0);
      const before = length[k] - length[k - 1], after = length[k + 1] - length[k];
      return (chord(k - 1) * after + chord(k) * before) / (before + after);
    });
    const fine = [values[0]];
    for (let k = 0; k + 1 < count; k++) {
      const h = length[k + 1] - length[k];
      for (let piece = 1; piece <= PIECES; piece++) {
        const u = piece / PIECES, v = 1 - u;
        fine.push(v * v * (1 + 2 * u) * values[k] + u * u * (1 + 2 * v) * values[k + 1] + u * v * h * (v * slope[k] - u * slope[k + 1]));
      }
    }
    return fine;
  });
}
// Straight between nodes: thickness has corners that a cubic would round.
function pieced(values) {
  return Array.from({ length: PIECES * (values.length - 1) + 1 }, (_, k) => {
    const node = Math.floor(k / PIECES), part = k / PIECES - node;
    return part ? values[node] + part * (values[node + 1] - values[node]) : values[node];
  });
}

// Where the numbers of a whole run lie, so that the picture stands still while it plays.
function boundsOf(count, xOf, yOf) {
  const bounds = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
  for (let k = 0; k < count; k++) {
    const x = xOf(k), y = yOf(k);
    if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
    bounds.left = Math.min(bounds.left, x); bounds.right = Math.max(bounds.right, x);
    bounds.low = Math.min(bounds.low, y); bounds.high = Math.max(bounds.high, y);
  }
  return bounds;
}
// One scale for both directions.
function viewOf(width, height, { left, right, low, high }, aside = 30, above = 16) {
  const scale = Math.min((width - aside) / (right - left), (height - above) / (high - low));
  return { scale, px: (x) => width / 2 + (x - (left + right) / 2) * scale, py: (y) => height / 2 - (y - (low + high) / 2) * scale };
}

const THINNEST = 1.5;
// A filament of so many pixels at each node, at least THINNEST, each piece in its colour.
function drawStrip({ px, py }, pen, x, y, pixels, colourOf) {
  const [fineX, fineY] = smoothed(x, y), wide = pieced(pixels).map((each) => Math.max(THINNEST, each)), last = fineX.length - 1;
  const edge = (side) => fineX.map((_, k) => {
    const before = Math.max(0, k - 1), after = Math.min(last, k + 1);
    const run = fineX[after] - fineX[before], rise = fineY[after] - fineY[before], length = Math.hypot(run, rise) || 1;
    const half = (side * wide[k]) / 2;
    return [px(fineX[k]) - (rise / length) * half, py(fineY[k]) - (run / length) * half];
  });
  const upper = edge(1), lower = edge(-1);
  // Pieces of one colour at once, and a piece beyond, over which the next ones are painted: no seams between them.
  for (let start = 0, end; start < last; start = end) {
    pen.fillStyle = colourOf(start);
    for (end = start + 1; end < last && colourOf(end) === colourOf(start); end++);
    pen.beginPath();
    for (let k = start; k <= Math.min(last, end + 1); k++) pen.lineTo(...upper[k]);
    for (let k = Math.min(last, end + 1); k >= start; k--) pen.lineTo(...lower[k]);
    pen.fill();
  }
  pen.strokeStyle = styleOf("--edge"); pen.lineWidth = 1;
  for (const side of [upper, lower]) { pen.beginPath(); side.forEach((point, k) => (k ? pen.lineTo(...point) : pen.moveTo(...point))); pen.stroke(); }
}

// One, two or five times a power of ten.
function rounded(size) {
  const power = 10 ** Math.floor(Math.log10(size)), lead = size / power;
  return (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10) * power;
}
function ticksOf(low, high, about) {
  const step = rounded((high - low) / about), ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) ticks.push(k * step);
  return ticks;
}

// The height of the midpoint against time [s], with a mark at the time shown.
function drawMidpoint(canvas, { time, heights: all, colour }, { end, now }) {
  const { pen, width, height } = fresh(canvas), finite = Array.from(all).filter(Number.isFinite);
  let low = finite.reduce((a, b) => Math.min(a, b), 0), high = finite.reduce((a, b) => Math.max(a, b), 0);
  if (!(high > low)) { high = 1e-6; low = -1e-6; }
  const tall = lengthUnit(Math.max(high, -low)), long = timeUnit(end);
  const heights = ticksOf(low, high, 5), labels = heights.map((h) => significant(h / tall[0], 3));
  const left = 14 + Math.max(...labels.map((label) => pen.measureText(label).width)), right = width - 14, top = 24, bottom = height - 32;
  const px = (t) => left + (t / end) * (right - left), py = (h) => bottom - ((h - low) / (high - low)) * (bottom - top);
  pen.lineWidth = 1; pen.strokeStyle = pen.fillStyle = styleOf("--quiet"); pen.setLineDash([1, 4]);
  heights.forEach((h, k) => {
    pen.beginPath(); pen.moveTo(left, py(h)); pen.lineTo(right, py(h)); pen.stroke();
    pen.textAlign = "right"; pen.fillText(labels[k], left - 7, py(h) + 4);
  });
  pen.setLineDash([]);
  ticksOf(0, end, Math.max(2, Math.min(6, (right - left) / 60))).forEach((t) => {
    pen.beginPath(); pen.moveTo(px(t), bottom); pen.lineTo(px(t), bottom + 4); pen.stroke();
    pen.textAlign = "center"; pen.fillText(significant(t / long[0], 3), px(t), bottom + 15);
  });
  pen.textAlign = "left"; pen.fillText(`height [${tall[1]}]`, 2, 11);
  pen.textAlign = "right"; pen.fillText(`time [${long[1]}]`, right, height - 3);
  pen.save(); pen.beginPath(); pen.rect(left, top - 4, right - left + 4, bottom - top + 8); pen.clip();
  pen.strokeStyle = colour; pen.lineWidth = 2.2; pen.beginPath();
  let begun = false;
  all.forEach((h, k) => {
    if (Number.isFinite(h)) pen[begun ? "lineTo" : "moveTo"](px(time[k]), py(h));
    begun = Number.isFinite(h);
  });
  pen.stroke();
  pen.restore();
  pen.strokeStyle = styleOf("--quiet"); pen.lineWidth = 1;
  pen.beginPath(); pen.moveTo(left, top); pen.lineTo(left, bottom); pen.lineTo(right, bottom); pen.stroke();
  if (!finite.length) { pen.textAlign = "left"; pen.fillText("no midpoint", left + 12, (top + bottom) / 2); return { left, right }; }
  const { here, next, part } = between(time, now), h = all[here] + part * (all[next] - all[here]);
  if (Number.isFinite(h)) {
    pen.fillStyle = colour; pen.strokeStyle = styleOf("--paper");
    pen.beginPath(); pen.arc(px(Math.min(now, time[time.length - 1])), py(h), 5, 0, 2 * Math.PI); pen.fill(); pen.stroke();
  }
  return { left, right };
}
