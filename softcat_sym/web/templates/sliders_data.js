// What the page holds, unpacked; and which member is nearest to a place on the axes.
const data = JSON.parse(document.getElementById("data").textContent);
const MISSING = -32768;

function unpack(block) {
  const bytes = Uint8Array.from(atob(block.codes), (letter) => letter.charCodeAt(0));
  const view = new DataView(bytes.buffer), length = bytes.length / 2;
  const codes = new Int16Array(length);
  for (let k = 0; k < length; k++) codes[k] = view.getInt16(2 * k, true);
  const each = length / data.members;
  return (member, index) => {
    const code = codes[member * each + index];
    return code === MISSING ? NaN : block.low[member] + block.step[member] * (code + 32767);
  };
}

const shapes = data.shapes && {
  at: data.shapes.at, nodes: data.shapes.nodes, stretches: data.shapes.stretches,
  x: unpack(data.shapes.x), y: unpack(data.shapes.y), stretch: unpack(data.shapes.stretch),
};
const midpoints = data.midpoint && { at: data.midpoint.at, height: unpack(data.midpoint) };

// Each axis maps its values to 0 .. 1.
const axes = data.axes.map((axis) => {
  const measure = axis.scale === "log" ? Math.log : (value) => value;
  const finite = axis.values.filter((value) => value !== null);
  const low = measure(finite.reduce((a, b) => Math.min(a, b)));
  const high = measure(finite.reduce((a, b) => Math.max(a, b)));
  const place = (value) => (value === null ? NaN : high > low ? (measure(value) - low) / (high - low) : 0.5);
  const text = (value) => (axis.words && value !== null ? axis.words[Math.round(value)] : significant(value));
  return { ...axis, place, text, places: axis.values.map(place) };
});
const varied = axes.filter((axis) => axis.varied);

const COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"];
const DASHED = "#8a8a8a";
const regimes = [...new Set(data.regime.filter((name) => name))].sort();
function groupOf(member) { return data.regime[member] || data.outcome[member] || "no answer"; }
function colourOf(member) {
  const known = regimes.indexOf(data.regime[member]);
  return known < 0 ? DASHED : COLOURS[known % COLOURS.length];
}

// The nearest member in scaled distance; `beyond` asks for one farther along one axis.
function nearest(target, beyond = () => true) {
  let best = -1, least = Infinity;
  for (let member = 0; member < data.members; member++) {
    if (!beyond(member)) continue;
    let distance = 0;
    varied.forEach((axis, k) => { distance += (axis.places[member] - target[k]) ** 2; });
    if (distance < least) { least = distance; best = member; }
  }
  return best;
}

// A member next to this one along an axis: the smallest step first, then the least change of the others.
function neighbour(member, axis, direction) {
  const from = axis.places[member], target = varied.map((other) => other.places[member]);
  const ahead = (other) => direction * (axis.places[other] - from);
  const steps = [...Array(data.members).keys()].map(ahead).filter((step) => step > 1e-9);
  if (!steps.length) return member;
  const step = Math.min(...steps);
  return nearest(target, (other) => ahead(other) > 1e-9 && ahead(other) < step + 1e-9);
}
