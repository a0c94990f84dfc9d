"use strict"
/* What a page computes around its solver: parameters from sliders, the shape of the whole span, the scene as TOML, the
 * midpoint as CSV, the state as a link. Whether an answer is to be trusted it does not judge: `softcat run` does. Pure
 * functions; DATA is the page's JSON, `state` is {values: SI by key}. Nothing here touches the document. */

// ---- Parameters

const ownState = ({ keys }) => ({ values: { ...keys } })

function valueOf(data, state, key) {
  const value = (state.values || {})[key]
  return typeof value === "number" && Number.isFinite(value) ? value : data.keys[key]
}

/* What an interpolation says: its logarithm is a polynomial of those of the keys. */
function interpolatedAt(data, state, { keys, middles, halves, degrees, coefficients }) {
  const places = keys.map((key, j) => (Math.log(valueOf(data, state, key)) - middles[j]) / halves[j])
  return Math.exp(sumOf(coefficients.map((one, k) => places.reduce((term, place, j) => term * place ** degrees[k][j], one))))
}

/* Numbers of the solver: products of powers of the keys. */
function numbersOf(data, state) {
  return Float64Array.from(data.numbers, (name, k) => {
    const known = data.interpolations[name]
    return data.sliders.reduce((product, { key, exponents }) =>
      exponents[name] ? product * valueOf(data, state, key) ** exponents[name] : product,
    data.coefficients[k] * (known ? interpolatedAt(data, state, known) : 1))
  })
}

const numberOf = (data, state, name) => numbersOf(data, state)[data.numbers.indexOf(name)]

function durationOf(data, state) {
  const moves = data.sliders.some(slider => slider.key === "run.duration")
  return moves ? valueOf(data, state, "run.duration") : data.duration
}

// ---- Arrays of frames: a field is a Float64Array of frames * n, row by row

const leastOf = values => values.reduce((least, one) => Math.min(least, one), Infinity)
const sumOf = values => values.reduce((sum, one) => sum + one, 0)
const mapped = (length, of) => Float64Array.from({ length }, (_, k) => of(k))

// ---- The module

async function instantiate(source) {
  const found = await WebAssembly.instantiate(source, {}), module = found.instance || found
  if (module.exports._initialize) module.exports._initialize()
  return module
}

const textAt = (exports, address) => {
  const bytes = new Uint8Array(exports.memory.buffer)
  let end = address
  while (bytes[end]) end++
  let encoded = ""
  for (const byte of bytes.subarray(address, end)) encoded += `%${byte.toString(16).padStart(2, "0")}`
  return decodeURIComponent(encoded)
}

/* How softcat run would integrate: the tightest of the known points that are nearest to the sliders. */
function settingsOf(data, state) {
  const { settings } = data, measure = ({ scale }) => scale === "log" ? Math.log : value => value
  const shares = data.sliders.map(slider => {
    const of = measure(slider), [low, high] = [slider.low, slider.high].map(of)
    return (of(valueOf(data, state, slider.key) / slider.si) - low) / (high - low)
  })
  const apart = settings.at.map(at => Math.hypot(...at.map((share, k) => Number.isFinite(shares[k]) ? share - shares[k] : 0)))
  const nearest = leastOf(apart), near = apart.map((one, k) => k).filter(k => apart[k] <= 1.3 * nearest + 2e-4)
  const least = values => leastOf(near.map(k => values[k])), methods = new Set(near.map(k => settings.method[k]))
  const steps = near.map(k => settings.largest_step[k]).filter(one => one > 0)
  return {
    relative: least(settings.relative),
    absolute: settings.absolute[0].map((_, kind) => least(settings.absolute.map(row => row[kind]))),
    largest_step: steps.length ? leastOf(steps) : 0,
    method: methods.size === 1 ? [...methods][0] : settings.mixed,
  }
}

/* What the module makes of one state, copied out of its memory. */
function solvedRaw(data, module, state, resolution) {
  const settings = settingsOf(data, state), { looser } = resolution, { start } = data
  const absolute = resolution.slots.map(name => looser * settings.absolute[data.settings.kinds[name]])
  const { exports } = module, numbers = numbersOf(data, state), parameters = numbers.subarray(0, data.parameters)
  const view = (address, length) => new Float64Array(exports.memory.buffer, address, length)
  view(exports.page_parameters(), parameters.length).set(parameters)
  view(exports.page_absolute(absolute.length), absolute.length).set(absolute)
  const place = exports.page_start(start ? start.rows : 0)
  if (start) view(place, start.numbers.length).set(start.numbers)
  const scale = numbers[data.numbers.indexOf("time_scale")] || 0
  const code = exports.page_solve(resolution.cells, resolution.fibres, resolution.frames, durationOf(data, state),
    resolution.grading, settings.relative * looser, settings.largest_step * scale, settings.method, resolution.max_steps)
  const [, reached, steps, , site, slot, frames, sites] = view(exports.page_status(), 8)
  const copied = (address, length) => view(address, length).slice()
  return {
    code, reached, steps, site, slot, frames, sites,
    sentence: textAt(exports, exports.page_explain(code)),
    rows: copied(exports.page_fields(), frames * resolution.rows.length * sites),
    midpoint: copied(exports.page_midpoint(), frames),
  }
}

const clock = () => typeof performance === "object" ? performance.now() : Date.now()

function solve(data, module, state, resolution) {
  const begun = clock(), run = runOf(data, state, resolution, solvedRaw(data, module, state, resolution))
  return { ...run, milliseconds: clock() - begun }
}

// ---- The shape

const SHOWN = ["x", "y", "stretch", "yielded_fraction"]

/* Fields that are drawn, by name, over the whole span in SI: positions at nodes, the others in cells. */
function fieldsOf(data, state, resolution, { rows, frames, sites }) {
  const fields = {}, yields = []
  resolution.rows.forEach(({ name, first, behind }, k) => {
    const of_point = name.startsWith("point_yields")
    if (!of_point && !SHOWN.includes(name) && name !== "relative_thickness") return
    const n = sites - behind - first, values = new Float64Array(frames * n)
    for (let frame = 0; frame < frames; frame++) {
      const begin = (frame * resolution.rows.length + k) * sites
      values.set(rows.subarray(begin + first, begin + sites - behind), frame * n)
    }
    if (of_point) yields.push(values)
    else fields[name] = data.half ? mirrored(values, frames, sites, name === "x" ? -1 : 1) : values
  })
  if (yields.length) {
    const share = mapped(yields[0].length, at => sumOf(yields.map((one, k) => resolution.weights[k] * one[at])))
    fields.yielded_fraction = data.half ? mirrored(share, frames, sites, 1) : share
  }
  const { relative_thickness: relative, ...others } = fields, thickness = numberOf(data, state, "thickness")
  return { ...others, thickness: relative.map(one => one * thickness) }
}

/* The whole span of a field from its right half; a node at midspan is there once, a cell beside it twice. */
function mirrored(values, frames, sites, sign) {
  const n = values.length / frames, left = n === sites ? n - 1 : n, whole = new Float64Array(frames * (left + n))
  for (let frame = 0; frame < frames; frame++) for (let k = 0; k < n; k++) {
    const value = values[frame * n + k], begin = frame * (left + n)
    whole[begin + left + k] = value
    if (n - 1 - k < left) whole[begin + n - 1 - k] = sign * value
  }
  return whole
}

/* A run as pages show it. It ends where a cell is drawn beyond what its material bears: that is no filament any more. */
function runOf(data, state, resolution, raw) {
  if (!(String(raw.code) in data.words.codes) && raw.code) throw new Error(`the solver refused to begin: ${raw.sentence}`)
  const duration = durationOf(data, state), time = mapped(raw.frames, k => duration * k / (resolution.frames - 1))
  const run = { time, midpoint: raw.midpoint, fields: fieldsOf(data, state, resolution, raw) }
  const cells = run.fields.stretch.length / raw.frames, torn = run.fields.stretch.findIndex(one => !(one <= data.largest_stretch))
  const sound = torn < 0 ? raw.frames : Math.max(1, Math.floor(torn / cells)), cut = values => values.slice(0, values.length / raw.frames * sound)
  const outcome = torn >= 0 ? "ruptured" : data.words.codes[raw.code] || "computed"
  const message = torn >= 0 ? `a cell is drawn to more than ${data.largest_stretch} times its length` : raw.code ? stopMessage(resolution, raw) : ""
  const kept = { time: cut(run.time), midpoint: cut(run.midpoint), fields: Object.fromEntries(Object.entries(run.fields).map(([name, one]) => [name, cut(one)])) }
  return {
    ...kept, code: raw.code, reached: raw.reached, steps: raw.steps, sag: Math.max(0, -leastOf(kept.midpoint)),
    verdict: { outcome, is_success: outcome === "computed", advice: data.words.outcomes[outcome] || "", message },
  }
}

function stopMessage(resolution, { reached, site, slot, sentence }) {
  const worst = slot >= 0 ? `; worst: ${resolution.slots[slot]} at X/L = ${Number(resolution.nodes[site].toPrecision(4))}` : ""
  return `stopped after t = ${Number(reached.toPrecision(6))} s${worst}; ${sentence}`
}

// ---- To take away

/* The scene as TOML with what the sliders say. */
function tomlOf(data, state) {
  const lines = data.toml.split("\n")
  for (const { key, written } of data.sliders) {
    const value = valueOf(data, state, key)
    if (value === data.keys[key]) continue
    const at = key.indexOf("."), head = `[${key.slice(0, at)}]`, begin = `${key.slice(at + 1)} = `
    const line = lines.findIndex((text, k) => k > lines.indexOf(head) && text.startsWith(begin))
    lines[line] = begin + (written ? `"${value} ${written}"` : String(value))
  }
  return lines.join("\n")
}

function csvOf({ time, midpoint, verdict }) {
  const refused = verdict.is_success ? "" : `,${verdict.outcome}`
  const rows = Array.from(time, (one, k) => `${one},${midpoint[k]}${refused}`)
  return [`time_s,midpoint_m${refused && ",refused"}`, ...rows, ""].join("\n")
}

/* A state as text behind the # of a link, and back; whatever is broken or not of this page is as the scene has it. */
function linkOf(data, state) {
  const moved = data.sliders.map(({ key }) => [key, valueOf(data, state, key)]).filter(([key, value]) => value !== data.keys[key])
  return new URLSearchParams(moved).toString()
}

function stateOf(data, hash) {
  const given = new URLSearchParams(String(hash).replace(/^#/, "")), state = ownState(data)
  for (const { key, si, low, high } of data.sliders) {
    const value = (given.get(key) || "").trim() ? Number(given.get(key)) : NaN
    if (value >= low * si * (1 - 1e-9) && value <= high * si * (1 + 1e-9)) state.values[key] = value
  }
  return state
}
