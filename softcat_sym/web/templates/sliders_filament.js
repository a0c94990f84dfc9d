// The chosen filament with its thickness, coloured by stretch, and its midpoint against time.
function colourOfStretch(value) {
  const [low, high] = shapes.stretches, ramp = data.colours;
  const share = high > low ? Math.max(0, Math.min(1, (value - low) / (high - low))) : 0;
  const place = share * (ramp.length - 1), k = Math.min(ramp.length - 2, Math.floor(place)), part = place - k;
  return `rgb(${ramp[k].map((start, c) => Math.round(start + part * (ramp[k + 1][c] - start))).join(",")})`;
}

function drawFilament(member, fraction) {
  const { pen, width, height } = fresh(document.getElementById("filament")), said = document.getElementById("drawn");
  const bounds = boundsOf(shapes.at.length * shapes.nodes, (k) => shapes.x(member, k), (k) => shapes.y(member, k));
  if (!(bounds.right > bounds.left)) {
    said.textContent = "no shapes of this member";
    return;
  }
  const known = data.thickness[member], thickness = known || 0.01 * (bounds.right - bounds.left);
  bounds.low -= 1.2 * thickness; bounds.high += 1.2 * thickness;
  const view = viewOf(width, height, bounds), { here, next, part } = between(shapes.at, fraction);
  const read = (field) => Float64Array.from({ length: shapes.nodes }, (_, node) => {
    const before = field(member, here * shapes.nodes + node), after = field(member, next * shapes.nodes + node);
    return Number.isNaN(after) ? before : before + part * (after - before);
  });
  const x = read(shapes.x), y = read(shapes.y), stretch = read(shapes.stretch), last = shapes.nodes - 1, fine = pieced(stretch);
  pen.setLineDash([2, 4]); pen.strokeStyle = styleOf("--quiet"); pen.lineWidth = 1;
  pen.beginPath(); pen.moveTo(view.px(x[0]), view.py(y[0])); pen.lineTo(view.px(x[last]), view.py(y[last])); pen.stroke();
  pen.setLineDash([]);
  const pixels = stretch.map((s) => (view.scale * thickness) / (data.sheet ? s : Math.sqrt(s)));
  drawStrip(view, pen, x, y, pixels, (k) => colourOfStretch((fine[k] + fine[k + 1]) / 2));
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
  const duration = data.duration[member], seconds = duration !== null, end = seconds ? duration : 1;
  const curve = (other, colour, thick) => ({
    time: midpoints.at.map((share) => share * end), heights: midpoints.at.map((_, k) => midpoints.height(other, k)), colour, thick,
  });
  const every = Math.max(1, Math.ceil(data.members / 60), data.members > 20 ? 10 : 1), curves = [];
  for (let other = 0; other < data.members; other += every) curves.push(curve(other, styleOf("--faint"), 1));
  const canvas = document.getElementById("midpoint"), empty = "no midpoint of this member";
  drawMidpoints(canvas, [...curves, curve(member, colourOf(member), 2.2)], { end, now: fraction * end, seconds, empty });
}
