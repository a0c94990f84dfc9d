// The chosen filament with its thickness, coloured by stretch, and its midpoint against time.
function timeText(seconds) {
  if (!Number.isFinite(seconds)) return "";
  const [size, symbol] = seconds >= 300 ? [60, "min"] : seconds >= 1 || seconds === 0 ? [1, "s"] : seconds >= 1e-3 ? [1e-3, "ms"] : [1e-6, "µs"];
  return `${significant(seconds / size, 3)} ${symbol}`;
}
function lengthText(metres) {
  const size = Math.abs(metres);
  if (size === 0) return "0";
  const [unit, symbol] = size >= 1 ? [1, "m"] : size >= 1e-3 ? [1e-3, "mm"] : [1e-6, "µm"];
  return `${significant(metres / unit, 3)} ${symbol}`;
}

function colourOfStretch(value) {
  const [low, high] = shapes.stretches, ramp = data.colours;
  const share = high > low ? Math.max(0, Math.min(1, (value - low) / (high - low))) : 0;
  const place = share * (ramp.length - 1), k = Math.min(ramp.length - 2, Math.floor(place)), part = place - k;
  return `rgb(${ramp[k].map((start, c) => Math.round(start + part * (ramp[k + 1][c] - start))).join(",")})`;
}

// Nodes of a member at a fraction of its duration, between the frames that were kept.
function shapeAt(member, fraction) {
  const at = shapes.at, nodes = shapes.nodes;
  let k = 0;
  while (k < at.length - 2 && at[k + 1] < fraction) k++;
  const next = Math.min(k + 1, at.length - 1), gap = at[next] - at[k];
  const part = gap > 0 ? Math.max(0, Math.min(1, (fraction - at[k]) / gap)) : 0;
  const read = (field) => Float64Array.from({ length: nodes }, (_, node) => {
    const here = field(member, k * nodes + node), there = field(member, next * nodes + node);
    return Number.isNaN(there) ? here : here + part * (there - here);
  });
  return smoothed({ x: read(shapes.x), y: read(shapes.y), stretch: read(shapes.stretch) });
}

// Four pieces between two nodes: cubics over the length of the chord, whose slopes are those of the parabola through
// three nodes. The nodes stand closer at the clamps, so a cubic over their number would overshoot.
function smoothed(shape) {
  const count = shape.x.length, length = [0];
  for (let k = 1; k < count; k++) length.push(length[k - 1] + (Math.hypot(shape.x[k] - shape.x[k - 1], shape.y[k] - shape.y[k - 1]) || 1e-300));
  const refine = (values) => {
    const chord = (k) => (values[k + 1] - values[k]) / (length[k + 1] - length[k]);
    const slope = Array.from(values, (_, k) => {
      if (k === 0 || k === count - 1) return chord(k ? k - 1 : 0);
      const before = length[k] - length[k - 1], after = length[k + 1] - length[k];
      return (chord(k - 1) * after + chord(k) * before) / (before + after);
    });
    const fine = [values[0]];
    for (let k = 0; k + 1 < count; k++) {
      const h = length[k + 1] - length[k];
      for (let piece = 1; piece <= 4; piece++) {
        const u = piece / 4, v = 1 - u;
        fine.push(v * v * (1 + 2 * u) * values[k] + u * u * (1 + 2 * v) * values[k + 1] + u * v * h * (v * slope[k] - u * slope[k + 1]));
      }
    }
    return fine;
  };
  return { x: refine(shape.x), y: refine(shape.y), stretch: refine(shape.stretch).map((value) => Math.max(1e-3, value)) };
}

// Bounds of a member over its whole run, so that the picture stands still while it plays.
function boundsOf(member) {
  const bounds = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
  for (let k = 0; k < shapes.at.length * shapes.nodes; k++) {
    const x = shapes.x(member, k), y = shapes.y(member, k);
    if (Number.isNaN(x) || Number.isNaN(y)) continue;
    bounds.left = Math.min(bounds.left, x); bounds.right = Math.max(bounds.right, x);
    bounds.low = Math.min(bounds.low, y); bounds.high = Math.max(bounds.high, y);
  }
  return bounds;
}

function drawFilament(member, fraction) {
  const { pen, width, height } = fresh(document.getElementById("filament")), said = document.getElementById("drawn");
  const bounds = boundsOf(member);
  if (!(bounds.right > bounds.left)) {
    said.textContent = "no shapes of this member";
    return;
  }
  const known = data.thickness[member], thickness = known || 0.01 * (bounds.right - bounds.left);
  bounds.low -= 1.2 * thickness; bounds.high += 1.2 * thickness;
  const scale = Math.min((width - 30) / (bounds.right - bounds.left), (height - 16) / (bounds.high - bounds.low));
  const middle = [(bounds.left + bounds.right) / 2, (bounds.low + bounds.high) / 2];
  const px = (x) => width / 2 + (x - middle[0]) * scale, py = (y) => height / 2 - (y - middle[1]) * scale;
  const { x, y, stretch } = shapeAt(member, fraction);
  const drawn = (s) => Math.max(1.5, (scale * thickness) / (data.sheet ? s : Math.sqrt(s)));
  pen.setLineDash([2, 4]); pen.strokeStyle = styleOf("--quiet"); pen.lineWidth = 1;
  pen.beginPath(); pen.moveTo(px(x[0]), py(y[0])); pen.lineTo(px(x[x.length - 1]), py(y[y.length - 1])); pen.stroke();
  pen.setLineDash([]);
  const edge = (side) => Array.from(x, (_, k) => {
    const before = Math.max(0, k - 1), after = Math.min(x.length - 1, k + 1);
    const run = x[after] - x[before], rise = y[after] - y[before], length = Math.hypot(run, rise) || 1;
    const half = (side * drawn(stretch[k])) / 2;
    return [px(x[k]) - (rise / length) * half, py(y[k]) - (run / length) * half];
  });
  const upper = edge(1), lower = edge(-1);
  for (let k = 0; k + 1 < x.length; k++) {
    const colour = colourOfStretch((stretch[k] + stretch[k + 1]) / 2);
    pen.fillStyle = colour; pen.strokeStyle = colour; pen.lineWidth = 1;
    pen.beginPath();
    pen.moveTo(...upper[k]); pen.lineTo(...upper[k + 1]); pen.lineTo(...lower[k + 1]); pen.lineTo(...lower[k]);
    pen.closePath(); pen.fill(); pen.stroke();
  }
  pen.strokeStyle = styleOf("--edge"); pen.lineWidth = 1;
  for (const side of [upper, lower]) { pen.beginPath(); side.forEach((point, k) => (k ? pen.lineTo(...point) : pen.moveTo(...point))); pen.stroke(); }
  said.textContent = known ? "true shape and thickness, colour: stretch" : "true shape; the thickness is not known, colour: stretch";
}

function drawRamp() {
  const { pen, width, height } = fresh(document.getElementById("ramp"));
  const [low, high] = shapes.stretches;
  for (let k = 0; k < width; k++) { pen.fillStyle = colourOfStretch(low + (k / (width - 1)) * (high - low)); pen.fillRect(k, 0, 1.5, height); }
  document.getElementById("least").textContent = significant(low, 3);
  document.getElementById("most").textContent = `≥ ${significant(high, 3)}`;
}

function drawMidpoint(member, fraction) {
  const { pen, width, height } = fresh(document.getElementById("midpoint"));
  const at = midpoints.at, left = 62, right = width - 10, top = 10, bottom = height - 26;
  const curve = at.map((_, k) => midpoints.height(member, k)), finite = curve.filter(Number.isFinite);
  let low = Math.min(0, ...finite), high = Math.max(0, ...finite);
  if (!(high > low)) { high = 1e-6; low = -1e-6; }
  const px = (f) => left + f * (right - left), py = (h) => bottom - ((h - low) / (high - low)) * (bottom - top);
  const line = (heights, colour, thick) => {
    pen.strokeStyle = colour; pen.lineWidth = thick; pen.beginPath();
    let begun = false;
    heights.forEach((h, k) => {
      if (!Number.isFinite(h)) { begun = false; return; }
      if (begun) pen.lineTo(px(at[k]), py(h)); else pen.moveTo(px(at[k]), py(h));
      begun = true;
    });
    pen.stroke();
  };
  pen.save(); pen.beginPath(); pen.rect(left, top - 4, right - left, bottom - top + 8); pen.clip();
  const others = Math.max(1, Math.ceil(data.members / 60), data.members > 20 ? 10 : 1);
  for (let other = 0; other < data.members; other += others) line(at.map((_, k) => midpoints.height(other, k)), styleOf("--faint"), 1);
  line(curve, colourOf(member), 2.2);
  pen.restore();
  pen.strokeStyle = pen.fillStyle = styleOf("--quiet"); pen.lineWidth = 1;
  pen.beginPath(); pen.moveTo(left, top); pen.lineTo(left, bottom); pen.lineTo(right, bottom); pen.stroke();
  pen.textAlign = "right";
  for (const h of [low, high]) pen.fillText(lengthText(h), left - 5, py(h) + 4);
  pen.fillText(timeText(data.duration[member] ?? NaN), right, bottom + 15);
  pen.textAlign = "left"; pen.fillText("0", left, bottom + 15);
  if (!finite.length) { pen.fillText("no midpoint of this member", left + 12, (top + bottom) / 2); return; }
  let k = 0;
  while (k < at.length - 2 && at[k + 1] < fraction) k++;
  const next = Math.min(k + 1, at.length - 1), gap = at[next] - at[k];
  const h = curve[k] + (gap > 0 ? Math.min(1, (fraction - at[k]) / gap) : 0) * (curve[next] - curve[k]);
  if (!Number.isFinite(h)) return;
  pen.fillStyle = colourOf(member); pen.strokeStyle = styleOf("--paper");
  pen.beginPath(); pen.arc(px(fraction), py(h), 5, 0, 2 * Math.PI); pen.fill(); pen.stroke();
}
