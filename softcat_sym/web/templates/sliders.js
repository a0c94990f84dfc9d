// The page: which member is chosen, what is written about it, and the clock.
const panel = document.getElementById("sliders");
const time = document.getElementById("time"), play = document.getElementById("play");

const chosen = {
  member: 0,
  take(member) { this.member = member; this.settle(); },
  byHandles() { this.show(nearest(varied.map((axis) => Number(axis.handle.value)))); },
  // Handles stand where the member is, once they are let go.
  settle() {
    varied.forEach((axis) => { axis.handle.value = axis.places[this.member]; });
    this.show(this.member);
  },
  show(member) {
    this.member = member;
    write(member);
    drawAtTime();
  },
};

function buildSliders() {
  varied.forEach((axis, k) => {
    const row = element("div"), name = element("label", axis.name);
    const handle = document.createElement("input");
    Object.assign(handle, { type: "range", min: 0, max: 1, step: 0.001, id: `axis-${k}` });
    handle.dataset.key = axis.key;
    name.htmlFor = handle.id;
    name.append(element("small", [axis.unit, axis.scale === "log" ? "log" : ""].filter(Boolean).join(", ")));
    handle.addEventListener("input", () => chosen.byHandles());
    handle.addEventListener("change", () => chosen.settle());
    handle.addEventListener("keydown", (event) => {
      const direction = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
      if (!direction) return;
      event.preventDefault();
      chosen.take(neighbour(chosen.member, axis, direction));
    });
    axis.handle = handle;
    axis.output = element("output");
    row.append(name, handle, axis.output);
    panel.append(row);
  });
}

function write(member) {
  const name = [`Member ${member + 1} of ${data.members}`, groupOf(member), data.message[member]].filter(Boolean).join(" · ");
  const heading = document.getElementById("which"), numbers = document.getElementById("numbers");
  heading.textContent = name;
  heading.dataset.member = member;
  document.getElementById("shown").style.borderLeftColor = colourOf(member);
  for (const axis of varied) {
    axis.output.textContent = `${axis.text(axis.values[member])} ${axis.unit}`.trim();
    axis.handle.setAttribute("aria-valuetext", axis.output.textContent);
  }
  numbers.replaceChildren(...axes.map((axis) => {
    const row = element("div"), value = element("dd", `${axis.text(axis.values[member])} ${axis.values[member] === null ? "" : axis.unit}`.trim());
    value.dataset.key = axis.key;
    value.dataset.value = axis.words ? axis.text(axis.values[member]) : axis.values[member] ?? "";
    row.append(element("dt", axis.name), value);
    return row;
  }));
}

function drawAtTime() {
  const fraction = Number(time.value), duration = data.duration[chosen.member];
  document.getElementById("now").textContent = duration === null ? `${significant(100 * fraction, 3)} % of the run` : `t = ${timeText(fraction * duration)}`;
  if (shapes) drawFilament(chosen.member, fraction);
  if (midpoints) drawMidpoint(chosen.member, fraction);
}

let started = null;
function tick(now) {
  if (started === null) return;
  const fraction = (now - started) / 6000;
  time.value = Math.min(1, fraction);
  drawAtTime();
  if (fraction < 1) requestAnimationFrame(tick); else setPlaying(false);
}
function setPlaying(on) {
  play.textContent = on ? "pause" : "play";
  play.setAttribute("aria-label", play.textContent);
  const from = Number(time.value) < 1 ? Number(time.value) : 0;
  started = on ? performance.now() - 6000 * from : null;
  if (on) requestAnimationFrame(tick);
}
play.addEventListener("click", () => setPlaying(started === null));
time.addEventListener("input", () => { setPlaying(false); drawAtTime(); });

function legend() {
  const list = document.getElementById("legend"), seen = new Map();
  for (let member = 0; member < data.members; member++) if (!seen.has(groupOf(member))) seen.set(groupOf(member), member);
  for (const [name, member] of [...seen].sort()) {
    const item = element("li"), mark = element("i", "", data.regime[member] ? "" : "failed");
    mark.style.borderTopColor = colourOf(member);
    const count = Array.from({ length: data.members }, (_, k) => groupOf(k)).filter((other) => other === name).length;
    item.append(mark, `${name} (${count})`);
    list.append(item);
  }
}

// A place can be sent as a link: #groups.G=0.7&t=0.5
function fromLink() {
  const asked = new URLSearchParams(location.hash.slice(1));
  if (![...asked].length) return;
  if (asked.has("t")) time.value = asked.get("t");
  for (const axis of varied) {
    if (!asked.has(axis.key)) continue;
    const share = axis.words ? axis.place(axis.words.indexOf(asked.get(axis.key))) : axis.place(Number(asked.get(axis.key)));
    if (Number.isFinite(share)) axis.handle.value = share;
  }
  chosen.byHandles();
  chosen.settle();
}

function layOut() {
  if (!panel.clientWidth) return; // no window yet, or none any more
  if (shapes) drawRamp();
  chosen.show(chosen.member);
}

buildSliders();
legend();
document.getElementById("count").textContent = `${data.members} filament${data.members === 1 ? "" : "s"}.`;
if (!shapes) { document.getElementById("shape").hidden = true; document.getElementById("film").classList.add("bare"); }
if (!midpoints) document.getElementById("curve").hidden = true;
if (!shapes && !midpoints) document.getElementById("clock").hidden = true;
chosen.member = nearest(varied.map(() => 0.5));
layOut();
chosen.settle();
fromLink();
new ResizeObserver(layOut).observe(panel);
window.addEventListener("hashchange", fromLink);
window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", layOut);
