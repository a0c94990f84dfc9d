// Parallel axes: a line for each member, a handle for each varied parameter, a range to keep for each result.
const TOP = 50, BOTTOM = 32, SIDE = 68;
const panel = document.getElementById("axes"), lines = document.getElementById("lines");
const background = document.createElement("canvas");

function across(k) { return axes.length > 1 ? SIDE + (k * (panel.clientWidth - 2 * SIDE)) / (axes.length - 1) : panel.clientWidth / 2; }
function up(share) { return TOP + (1 - share) * (panel.clientHeight - TOP - BOTTOM); }

function element(tag, text = "", className = "") {
  const made = document.createElement(tag);
  made.textContent = text;
  if (className) made.className = className;
  return made;
}

function buildAxes(chosen) {
  axes.forEach((axis, k) => {
    const box = element("div", "", "axis"), name = element("label", axis.name, "name");
    name.append(element("small", [axis.unit, axis.scale === "log" ? "log" : ""].filter(Boolean).join(", ")));
    axis.box = box;
    axis.output = element("output");
    axis.output.dataset.key = axis.key;
    box.append(name, axis.output);
    if (axis.varied) {
      const handle = document.createElement("input");
      Object.assign(handle, { type: "range", min: 0, max: 1, step: 0.001, id: `axis-${k}` });
      handle.dataset.key = axis.key;
      handle.setAttribute("aria-label", axis.name);
      name.htmlFor = handle.id;
      handle.addEventListener("input", () => chosen.byHandles());
      handle.addEventListener("change", () => chosen.settle());
      handle.addEventListener("keydown", (event) => {
        const direction = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
        if (!direction) return;
        event.preventDefault();
        chosen.take(neighbour(chosen.member, axis, direction));
      });
      axis.handle = handle;
      box.append(handle);
    }
    panel.append(box);
  });
}

function placeAxes() { axes.forEach((axis, k) => { axis.box.style.left = `${across(k)}px`; }); }

function trace(pen, member) {
  pen.beginPath();
  let begun = false;
  axes.forEach((axis, k) => {
    const share = axis.places[member];
    if (Number.isNaN(share)) { begun = false; return; }
    if (begun) pen.lineTo(across(k), up(share)); else pen.moveTo(across(k), up(share));
    begun = true;
  });
  pen.stroke();
}

// All lines, drawn once into a picture of their own; choosing a member only lays one line over it.
function drawLines() {
  background.style.cssText = `width:${panel.clientWidth}px;height:${panel.clientHeight}px;position:absolute;visibility:hidden`;
  panel.append(background);
  const { pen } = fresh(background);
  background.remove();
  const strength = Math.max(0.08, Math.min(0.8, 40 / data.members));
  const order = [...Array(data.members).keys()].sort((a, b) => Number(isKept(a)) - Number(isKept(b)));
  for (const member of order) {
    const kept = isKept(member);
    pen.strokeStyle = kept ? colourOf(member) : styleOf("--faint");
    pen.globalAlpha = kept ? strength : 0.35;
    pen.lineWidth = 1;
    pen.setLineDash(data.regime[member] ? [] : [4, 3]);
    trace(pen, member);
  }
  pen.globalAlpha = 1;
  pen.setLineDash([]);
  axes.forEach((axis, k) => {
    pen.strokeStyle = styleOf("--quiet");
    pen.beginPath(); pen.moveTo(across(k), up(0)); pen.lineTo(across(k), up(1)); pen.stroke();
    if (axis.kept) {
      pen.fillStyle = "rgba(230, 159, 0, 0.35)";
      pen.fillRect(across(k) - 9, up(axis.kept[1]), 18, up(axis.kept[0]) - up(axis.kept[1]));
    }
    pen.fillStyle = styleOf("--quiet");
    const right = k === axes.length - 1;
    pen.textAlign = right ? "right" : "left";
    pen.strokeStyle = styleOf("--paper"); pen.lineWidth = 3; pen.lineJoin = "round";
    const single = axis.back(0) === axis.back(1);
    for (const share of single ? [0.5] : [0, 0.5, 1]) {
      const place = [axis.words ? axis.text(axis.back(share)) : significant(axis.back(share), 3), across(k) + (right ? -15 : 15), up(share) + (share === 1 ? 10 : share ? 4 : -3)];
      pen.strokeText(...place);
      pen.fillText(...place);
    }
    pen.lineWidth = 1;
  });
}

function drawChosen(member) {
  const { pen, width, height } = fresh(lines);
  pen.drawImage(background, 0, 0, width, height);
  pen.lineJoin = "round";
  for (const [colour, thick] of [[styleOf("--chosen"), 5], [colourOf(member), 3]]) {
    pen.strokeStyle = colour; pen.lineWidth = thick;
    trace(pen, member);
  }
  axes.forEach((axis) => {
    axis.output.textContent = axis.text(axis.values[member]);
    if (axis.handle) axis.handle.setAttribute("aria-valuetext", `${axis.text(axis.values[member])} ${axis.unit}`.trim());
  });
}

// Pointer on the axes: a click chooses the nearest line, a drag along an axis of results keeps a range.
function watchPointer(chosen) {
  let from = null;
  const shareAt = (event) => {
    const box = panel.getBoundingClientRect();
    const share = 1 - (event.clientY - box.top - TOP) / (panel.clientHeight - TOP - BOTTOM);
    return [event.clientX - box.left, Math.max(0, Math.min(1, share))];
  };
  const axisAt = (x) => axes.findIndex((axis, k) => !axis.varied && Math.abs(across(k) - x) < 14);
  lines.addEventListener("pointerdown", (event) => {
    const [x, share] = shareAt(event);
    from = { x, share, axis: axisAt(x), moved: false };
    lines.setPointerCapture(event.pointerId);
  });
  lines.addEventListener("pointermove", (event) => {
    if (!from || from.axis < 0) return;
    const [, share] = shareAt(event);
    if (Math.abs(share - from.share) < 0.02 && !from.moved) return;
    from.moved = true;
    axes[from.axis].kept = [Math.min(share, from.share), Math.max(share, from.share)];
    chosen.filtered();
  });
  lines.addEventListener("pointerup", () => {
    if (from && !from.moved) chosen.take(lineAt(from.x, from.share));
    from = null;
  });
  lines.addEventListener("dblclick", (event) => {
    const hit = axisAt(shareAt(event)[0]);
    axes.forEach((axis, k) => { if (hit < 0 || k === hit) axis.kept = null; });
    chosen.filtered();
  });
}

// The member whose line passes nearest to a place between two axes.
function lineAt(x, share) {
  let left = 0;
  while (left < axes.length - 2 && across(left + 1) < x) left++;
  const right = Math.min(left + 1, axes.length - 1);
  const part = right > left ? (x - across(left)) / (across(right) - across(left)) : 0;
  let best = 0, least = Infinity;
  for (let member = 0; member < data.members; member++) {
    const there = axes[left].places[member] * (1 - part) + axes[right].places[member] * part;
    const distance = Math.abs(there - share) + (isKept(member) ? 0 : 10);
    if (distance < least) { least = distance; best = member; }
  }
  return best;
}
