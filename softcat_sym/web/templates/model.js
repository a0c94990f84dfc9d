"use strict"
/* What a page computes around its solver: parameters from sliders, fields over the whole span, a verdict in the words of
 * `softcat run`, the scene as TOML, the midpoint as CSV, the state as a link. Pure functions; DATA is the page's JSON,
 * `state` is {scene: number, values: {key: SI}}. Nothing here touches the document, and text of a scene stays text. */

// ---- Parameters

function ownState(data, scene = 0) {
  return { scene, values: { ...data.scenes[scene].keys } }
}

function valueOf(data, state, key) {
  const value = (state.values || {})[key]
  return typeof value === "number" && Number.isFinite(value) ? value : data.scenes[state.scene].keys[key]
}

function productOf(data, state, coefficient, exponentOf) {
  for (const slider of data.sliders) {
    const exponent = exponentOf(slider)
    if (exponent) coefficient *= Math.pow(valueOf(data, state, slider.key), exponent)
  }
  return coefficient
}

/* What an interpolation says, of which the logarithm is a polynomial of groups of the keys. */
function interpolatedAt(data, state, { groups, middles, halves, degrees, coefficients }) {
  const places = groups.map((group, j) => (sumOf(Object.keys(group).map(key => group[key] * Math.log(valueOf(data, state, key)))) - middles[j]) / halves[j])
  return Math.exp(sumOf(coefficients.map((one, k) => places.reduce((term, place, j) => term * place ** degrees[k][j], one))))
}

function parametersOf(data, state) {
  const { coefficients } = data.scenes[state.scene]
  return Float64Array.from(data.parameters, (name, k) => {
    const known = data.interpolations[name], coefficient = coefficients[k] * (known ? interpolatedAt(data, state, known) : 1)
    return productOf(data, state, coefficient, slider => slider.exponents[name])
  })
}

/* A number beside the parameters from which a run is judged; undefined where it is no product of powers. */
function numberOf(data, state, name) {
  const exponents = data.limits.numbers[name], coefficient = data.scenes[state.scene].numbers[name]
  return exponents && coefficient !== undefined ? productOf(data, state, coefficient, slider => exponents[slider.key]) : undefined
}

function durationOf(data, state) {
  const moves = data.sliders.some(slider => slider.key === "run.duration")
  return moves ? valueOf(data, state, "run.duration") : data.scenes[state.scene].duration
}

// ---- Numbers in words, as Python's format writes them

function general(value, digits = 6) {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "nan" : value > 0 ? "inf" : "-inf"
  if (value === 0) return Object.is(value, -0) ? "-0" : "0"
  const [mantissa, power] = value.toExponential(digits - 1).split("e"), exponent = Number(power)
  const bare = text => text.includes(".") ? text.replace(/\.?0+$/, "") : text
  if (exponent >= -4 && exponent < digits) return bare(value.toFixed(digits - 1 - exponent))
  return `${bare(mantissa)}e${exponent < 0 ? "-" : "+"}${String(Math.abs(exponent)).padStart(2, "0")}`
}

const percent = share => `${(100 * share).toFixed(0)}%`

// ---- Arrays of frames: a field is a Float64Array of frames * n, row by row

const rowOf = (field, frame, frames) => {
  const n = field.length / frames
  return field.subarray(frame * n, (frame + 1) * n)
}
const largestOf = values => values.reduce((most, one) => one > most || Number.isNaN(one) ? one : most, -Infinity)
const leastOf = values => values.reduce((least, one) => one < least || Number.isNaN(one) ? one : least, Infinity)
const sumOf = values => values.reduce((sum, one) => sum + one, 0)
const placeOfLargest = values => {
  const unknown = values.findIndex(Number.isNaN)
  return unknown >= 0 ? unknown : values.reduce((best, one, k) => one > values[best] ? k : best, 0)
}
const differences = values => Float64Array.from({ length: values.length - 1 }, (_, k) => values[k + 1] - values[k])
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
function solvedRaw(data, module, state, resolution, tighter = 1) {
  const settings = settingsOf(data, state), looser = resolution.looser / tighter
  const absolute = resolution.slots.map(name => looser * settings.absolute[data.settings.kinds[name]])
  const { exports } = module, parameters = parametersOf(data, state), { start } = data.scenes[state.scene]
  const view = (address, length) => new Float64Array(exports.memory.buffer, address, length)
  view(exports.page_parameters(), parameters.length).set(parameters)
  view(exports.page_absolute(absolute.length), absolute.length).set(absolute)
  const place = exports.page_start(start ? start.rows : 0)
  if (start) view(place, start.numbers.length).set(start.numbers)
  const scale = parameters[data.parameters.indexOf("time_scale")] || 0
  const code = exports.page_solve(resolution.cells, resolution.fibres, resolution.frames, durationOf(data, state),
    resolution.grading, settings.relative * looser, settings.largest_step * scale, settings.method, resolution.max_steps)
  const status = Array.from(view(exports.page_status(), 10)), [, reached, steps, , site, slot, frames, sites, extremes, yielded] = status
  const copied = (address, length) => view(address, length).slice()
  return {
    code, reached, steps, site, slot, frames, sites,
    sentence: textAt(exports, exports.page_explain(code)),
    rows: copied(exports.page_fields(), frames * resolution.rows.length * sites),
    midpoint: copied(exports.page_midpoint(), frames),
    extremes: copied(exports.page_extremes(), 3 * extremes),
    yielded: yielded > 0,
    work: copied(exports.page_work(), frames * data.powers.length),
  }
}

const clock = () => typeof performance === "object" ? performance.now() : Date.now()

/* Solve, and judge the answer; where a step was too long for a run, again in shorter ones. */
function solve(data, module, state, resolution) {
  const begun = clock()
  let run, steps = 0, tighter = 1
  for (let left = data.limits.tries; left > 0; left--, tighter *= data.limits.tighter) {
    run = runOf(data, state, resolution, solvedRaw(data, module, state, resolution, tighter))
    steps += run.steps
    if (!data.limits.of_a_step_too_long.includes(run.verdict.outcome)) break
  }
  return { ...run, steps, milliseconds: clock() - begun }
}

// ---- Fields

/* Fields of the run by name, whole span, SI; energies and works of the whole filament [J]. */
function fieldsOf(data, state, resolution, raw) {
  const { limits } = data, { frames, sites } = raw, observed = {}, points = {}
  resolution.rows.forEach((row, k) => {
    const n = row.summed ? 1 : sites - row.behind - row.first, values = new Float64Array(frames * n)
    for (let frame = 0; frame < frames; frame++) {
      const begin = (frame * resolution.rows.length + k) * sites, part = raw.rows.subarray(begin + row.first, begin + sites - row.behind)
      if (row.summed) values[frame] = sumOf(raw.rows.subarray(begin, begin + sites))
      else values.set(part, frame * n)
    }
    const point = row.name.startsWith("point_") && /^point_(.*)_\d+$/.exec(row.name)
    if (point) (points[point[1]] = points[point[1]] || []).push(values)
    else observed[row.name] = values
  })
  if (resolution.points) Object.assign(observed, shownOfSection(resolution.points, points, frames))
  limits.work.forEach((name, k) => { observed[name] = mapped(frames, frame => raw.work[frame * data.powers.length + k]) })
  if ("heat_lost" in observed) observed.heat_lost = observed.heat_lost.map(one => one * numberOf(data, state, "heat"))
  const parameters = parametersOf(data, state), parameter = name => parameters[data.parameters.indexOf(name)]
  if (limits.gradient_by_frames) observed.energy_gradient = gradientByFrames(observed, frames, parameter("rest_length"))
  for (const name of limits.since_start) if (name in observed) {
    const [first] = observed[name]
    observed[name] = observed[name].map(one => one - first)
  }
  const thickness = numberOf(data, state, "thickness")
  observed.thickness = observed.relative_thickness.map(one => one * thickness)
  const area = numberOf(data, state, "area"), fields = {}
  for (const name of [...limits.fields, "q0", "q1", "q2", "q3"]) if (name in observed) {
    const unit = limits.per_area.includes(name) ? area : 1, values = observed[name]
    if (values.length === frames) fields[name] = values.map(one => one * unit * (data.half ? 2 : 1))
    else fields[name] = data.half ? mirrored(values, frames, sites, unit, limits.odd.includes(name) ? -1 : 1) : values.map(one => one * unit)
  }
  return fields
}

/* The whole span of a field from its right half; a node at midspan is there once, a cell beside it twice. */
function mirrored(values, frames, sites, unit, sign) {
  const n = values.length / frames, left = n === sites ? n - 1 : n, whole = new Float64Array(frames * (left + n))
  for (let frame = 0; frame < frames; frame++) for (let k = 0; k < n; k++) {
    const value = values[frame * n + k] * unit, begin = frame * (left + n)
    whole[begin + left + k] = value
    if (n - 1 - k < left) whole[begin + n - 1 - k] = sign * value
  }
  return whole
}

/* Means, limits and largest of what the points of a section show. */
function shownOfSection({ count, weight, zeta }, points, frames) {
  const length = points.yields[0].length, n = length / frames, found = {}
  const mean = (rows, share = weight) => mapped(length, at => {
    let sum = 0
    for (let k = 0; k < count; k++) sum += share[k] * rows[k][at]
    return sum
  })
  found.yielded_fraction = mean(points.yields)
  found.plastic_rate = mapped(length, at => points.speed.reduce((most, row) => Math.max(most, row[at]), -Infinity))
  const others = Object.keys(points).filter(kind => !["yields", "speed"].includes(kind) && !(zeta && kind === "axial"))
  if (zeta) {
    const square = sumOf(weight.map((one, k) => one * zeta[k] ** 2))
    const edges = [-1, ...zeta.slice(1).map((one, k) => (one + zeta[k]) / 2), 1], widths = edges.slice(1).map((one, k) => one - edges[k])
    const fromFace = (rows, wide) => mapped(length, at => {
      let total = 0, part = 1
      for (let k = 0; k < count && part; k++) total += wide[k] * (part *= rows[k][at])
      return total
    })
    found.core_low = fromFace(points.yields, widths).map(one => -1 + one)
    found.core_high = fromFace([...points.yields].reverse(), [...widths].reverse()).map((one, at) => Math.max(found.core_low[at], 1 - one))
    found.stress_mean = mean(points.axial)
    found.stress_bending = mean(points.axial, weight.map((one, k) => one * zeta[k] / square))
  }
  for (const kind of others) found[kind] = mean(points[kind])
  return found
}

/* Work against the necking gradient where positions have no velocity: summed over frames. */
function gradientByFrames(observed, frames, span) {
  const force = observed.double_force, n = force.length / frames, work = new Float64Array(frames)
  const slope = (frame, k) => observed.stretch[frame * (n + 1) + k + 1] - observed.stretch[frame * (n + 1) + k]
  for (let frame = 1; frame < frames; frame++) {
    let step = 0
    for (let k = 0; k < n; k++) {
      step += (force[frame * n + k] + force[(frame - 1) * n + k]) / 2 * (slope(frame, k) - slope(frame - 1, k))
    }
    work[frame] = work[frame - 1] + step * span
  }
  return work
}

// ---- Verdict

/* A run as pages show it, from what the module has made of a state. */
function runOf(data, state, resolution, raw) {
  const { limits } = data, duration = durationOf(data, state), length = parametersOf(data, state)[data.parameters.indexOf("rest_length")]
  if (!(String(raw.code) in data.words.codes) && raw.code) throw new Error(`the solver refused to begin: ${raw.sentence}`)
  const right = resolution.nodes, half = data.half ? right.slice(1).reverse().map(one => -one) : []
  const X_node = Float64Array.from([...half, ...right], one => one * length)
  const fields = fieldsOf(data, state, resolution, raw), frames = raw.frames
  const time = mapped(frames, k => duration * k / (resolution.frames - 1))
  const stopped = { code: raw.code, reached: raw.reached, steps: raw.steps, message: raw.code ? stopMessage(data, resolution, raw) : "" }
  const { extremes, yielded } = raw, judged = judge(data, state, { ...stopped, time, X_node, fields, extremes, yielded })
  const sag = Math.max(0, ...judged.extremes.map(([, height]) => -height))
  return { ...stopped, nodes: X_node.length, cells: X_node.length - 1, X_node, ...judged, sag }
}

function stopMessage(data, resolution, { reached, site, slot, sentence }) {
  const worst = slot >= 0 ? `; worst: ${resolution.slots[slot]}[${site}] at X/L = ${general(resolution.nodes[site], 4)}` : ""
  return `stopped after t = ${general(reached)} s${worst}; ${sentence}`
}

/* Verdict, regime and warnings of fields over the whole span; frames that are no filament any more are cut off. */
function judge(data, state, run) {
  const { limits, words } = data
  const all = run.time.length
  if (!all) {
    const outcome = words.codes[run.code] || "no_convergence"
    return { time: run.time, midpoint: run.time, extremes: [], fields: run.fields, verdict: verdictWith(data, outcome, run.message), residual: 0 }
  }
  const whole = toRupture(data, run), residual = energyResidual(data, state, whole.fields)
  const [outcome, message] = outcomeOf(data, state, whole, limits.audited ? residual : 0)
  let sound = whole.time.length
  if (outcome === "ruptured") sound = Math.max(1, ruptureFrame(data, whole))
  if (outcome === "broken") sound = 1 + breakFrame(data, whole)
  const kept = cut(whole, sound), n = kept.fields.y.length / sound
  const midpoint = mapped(sound, frame => kept.fields.y[frame * n + (n - 1) / 2])
  const frames = mapped(3 * sound, k => [kept.time, midpoint, kept.time][k % 3][Math.floor(k / 3)])
  const extremes = extremesOf(data, outcome === "solved" ? run.extremes : frames)
  const regime = outcome === "solved" ? regimeOf(data, state, kept, sound, extremes) : null
  const warnings = warningsOf(data, state, kept, extremes, outcome, residual)
  return { time: kept.time, midpoint, extremes, fields: kept.fields, residual, verdict: verdictWith(data, outcome, message, regime, warnings) }
}

const verdictWith = ({ words }, outcome, message, regime = null, warnings = []) =>
  ({ outcome, is_success: outcome === "solved", advice: words.outcomes[outcome], message, regime, warnings })

function cut(run, frames) {
  const of = run.time.length, part = values => values.slice(0, values.length / of * frames)
  return { ...run, time: part(run.time), fields: Object.fromEntries(Object.entries(run.fields).map(([name, one]) => [name, part(one)])) }
}

/* Up to the first frame in which only a thread is left somewhere, if the last one is such. */
function toRupture({ limits, words }, run) {
  const torn = frame => frame > 0 && rowOf(run.fields.stretch, frame, run.time.length).some(one => one > limits.thread)
  let frames = run.time.length
  if (!torn(frames - 1)) return { ...run, outcome: words.codes[run.code] || "solved" }
  while (torn(frames - 2)) frames--
  const message = `stopped after t = ${general(run.time[frames - 1])} s: a cell is drawn to ${general(limits.thread)} times its length`
  return { ...cut(run, frames), outcome: "ruptured", message }
}

function outcomeOf(data, state, run, residual) {
  const { limits } = data, { fields, time, X_node } = run, frames = time.length
  const joined = text => [text, run.message].filter(Boolean).join("; ")
  if (limits.breaking && breakFrame(data, run) !== null) return ["broken", breakText(data, run)]
  const neck = limits.necks ? numberOf(data, state, "neck") : null
  const necked = limits.flows ? neckThatTheGridDecides(data, rowOf(fields.stretch, frames - 1, frames), X_node, neck) : ""
  if (necked) return ["localised", joined(necked)]
  const torn = rupture(data, run)
  if (torn) return ["ruptured", joined(torn)]
  if (run.outcome !== "solved") return [run.outcome, run.message]
  const pushed = limits.bends ? "" : pushedString(data, run)
  if (pushed) return ["compressed", pushed]
  let gained = run.steps && limits.balanced ? gainedEnergy(data, state, fields, frames) : ""
  if (!gained && residual > limits.accuracy) {
    gained = `energy residual ${general(residual, 2)} against an accuracy of ${general(limits.accuracy)}`
  }
  return gained ? ["energy_drift", gained] : ["solved", ""]
}

/* X/L amid a cell, 0 at midspan. */
function placeOf(nodes, cell) {
  const [first, last] = [nodes[0], nodes[nodes.length - 1]]
  return Number(((nodes[cell] + nodes[cell + 1] - first - last) / 2 / (last - first)).toFixed(6)) + 0
}

function neckThatTheGridDecides({ limits }, stretch, nodes, neck) {
  const length = differences(nodes), where = `X/L = ${general(placeOf(nodes, placeOfLargest(stretch)), 4)}`
  if (neck === null) {
    const share = largestShareOfOneCell(stretch, length, limits.beyond_neighbours)
    return share > limits.share_of_one_cell ? `the cell at ${where} carries ${percent(share)} of the elongation of its half beyond its neighbour` : ""
  }
  const strain = neckStrain(limits, stretch, length, neck)
  const far = strain < limits.ruptured ? `by ${percent(strain)} of its length` : `to more than ${general(limits.ruptured)} times its length`
  return strain > limits.drawn_out ? `the neck at ${where} is drawn out ${far} beyond its neighbourhood: near rupture` : ""
}

function largestShareOfOneCell(stretch, length, beyond) {
  const n = stretch.length, middle = Math.floor(n / 2), total = sumOf(length)
  const at = k => k < 0 || k >= n ? -Infinity : stretch[k]
  const share = (from, to) => {
    let most = 0, elongation = 0
    for (let k = from; k < to; k++) {
      const beside = Math.max(at(k - 1), at(k + 1))
      if (stretch[k] > beyond * beside) most = Math.max(most, Math.max(stretch[k] - Math.max(beside, 1), 0) * length[k])
      elongation += Math.abs(stretch[k] - 1) * length[k]
    }
    return elongation > 1e-9 * total ? most / elongation : 0
  }
  return Math.max(share(0, middle), share(middle, n))
}

/* Largest strain of any neck beyond its neighbourhood, spread over the length of a neck. */
function neckStrain(limits, stretch, length, neck) {
  const n = length.length, edges = new Float64Array(n + 1), elongation = new Float64Array(n + 1)
  for (let k = 0; k < n; k++) {
    edges[k + 1] = edges[k] + length[k]
    elongation[k + 1] = elongation[k] + (stretch[k] - 1) * length[k]
  }
  const end = edges[n]
  const drawn = place => {
    if (place <= 0) return elongation[0]
    if (place >= end) return elongation[n]
    let low = 0, high = n
    while (high - low > 1) {
      const middle = (low + high) >> 1
      if (edges[middle] <= place) low = middle
      else high = middle
    }
    return elongation[low] + (elongation[high] - elongation[low]) * (place - edges[low]) / (edges[high] - edges[low])
  }
  let most = -Infinity
  for (let k = 0; k < n; k++) {
    const window = Math.max(length[k], neck)
    const left = Math.min(Math.max((edges[k + 1] + edges[k] - window) / 2, 0), end - window)
    const mean = start => start > -1e-9 * end && start + window < (1 + 1e-9) * end ? (drawn(start + window) - drawn(start)) / window : -Infinity
    const beside = Math.max(mean(left - window), mean(left + window))
    const smooth = limits.smooth * (1 - neck / window) * Math.max(Number.isFinite(beside) ? beside : 0, 0)
    const excess = mean(left) - beside - smooth
    most = Math.max(most, (Number.isFinite(excess) ? excess : 0) * window / neck)
  }
  return most
}

/* The first frame in which a cell is drawn beyond what its material can bear; null without. */
function ruptureFrame({ limits }, { fields, time }) {
  for (let frame = 0; frame < time.length; frame++) {
    if (!(largestOf(rowOf(fields.stretch, frame, time.length)) <= limits.largest_stretch)) return frame
  }
  return null
}

function rupture(data, run) {
  const frame = ruptureFrame(data, run), { time, X_node } = run
  if (frame === null) return ""
  const where = placeOf(X_node, placeOfLargest(rowOf(run.fields.stretch, frame, time.length)))
  return `by t = ${general(time[frame])} s the cell at X/L = ${general(where, 4)} is drawn to more than ${general(data.limits.largest_stretch, 4)} times its length`
}

/* Load of the outer fibre over what the material bears at the middles of cells and at both ends, frame by frame. */
function fibres({ limits }, { fields, time, X_node }) {
  const cells = X_node.length - 1, middles = mapped(cells, k => (X_node[k] + X_node[k + 1]) / 2), frames = time.length
  const before = (X_node[0] - middles[0]) / (middles[0] - middles[1])
  const behind = (X_node[cells] - middles[cells - 1]) / (middles[cells - 1] - middles[cells - 2])
  const at = (name, frame, k) => {
    const row = rowOf(fields[name], frame, frames)
    if (k === 0) return row[0] * (1 + before) - row[1] * before
    return k > cells ? row[cells - 1] * (1 + behind) - row[cells - 2] * behind : row[k - 1]
  }
  const [mostStrain, mostStress] = limits.breaking
  return Array.from({ length: frames }, (_, frame) => Array.from({ length: cells + 2 }, (_, k) => {
    const curvature = at("curvature", frame, k)
    const strain = Math.log(Math.max(at("stretch", frame, k), 1e-300)) + Math.log1p(Math.abs(curvature) * at("thickness", frame, k) / 2)
    const stress = at("stress_mean", frame, k) + Math.abs(at("stress_bending", frame, k))
    const loads = [mostStrain === null ? 0 : strain / mostStrain, mostStress === null ? 0 : stress / mostStress].map(one => Number.isNaN(one) ? 0 : one)
    return { X: k === 0 ? X_node[0] : k > cells ? X_node[cells] : middles[k - 1], curvature, strain, stress, loads }
  }))
}

const BENT = 0.01

function breakFrame(data, run) {
  const found = fibres(data, run).findIndex(row => row.some(one => Math.max(...one.loads) >= 1))
  return found < 0 ? null : found
}

function breakText(data, run) {
  const all = fibres(data, run), frame = breakFrame(data, run), load = all.map(row => Math.max(...row.map(one => Math.max(...one.loads))))
  // The instant by a straight line between the two frames.
  const part = frame ? (1 - load[frame - 1]) / (load[frame] - load[frame - 1]) : 1
  const when = frame ? run.time[frame - 1] + part * (run.time[frame] - run.time[frame - 1]) : run.time[0]
  const kind = [0, 1].reduce((best, k) => largestOf(all[frame].map(one => one.loads[k])) > largestOf(all[frame].map(one => one.loads[best])) ? k : best, 0)
  const found = all[frame][placeOfLargest(all[frame].map(one => one.loads[kind]))]
  const bent = Math.abs(found.curvature) * largestOf(rowOf(run.fields.thickness, frame, run.time.length)) / 2 > BENT * found.strain
  const where = bent ? `from the ${found.curvature > 0 ? "bottom" : "top"}` : "through the section"
  return `it breaks after ${general(when)} s at X = ${general(found.X, 4)} m, ${where}, by its ${["strain", "stress"][kind]} (outer fibre: true strain ${general(found.strain, 4)}, true stress ${general(found.stress, 4)} Pa)`
}

function pushedString({ limits }, { fields, time }) {
  const along = fields.axial_force || fields.tension, frames = time.length, most = largestOf(along.subarray(limits.felt * along.length / frames))
  for (let frame = limits.felt; frame < frames; frame++) {
    const least = leastOf(rowOf(along, frame, frames))
    if (least < -limits.compression * most) {
      return `by t = ${general(time[frame])} s the string is pushed together with ${percent(-least / most)} of its largest tension: without bending that is ill-posed`
    }
  }
  return ""
}

const isWork = name => name.startsWith("work_")

/* Energies and works of the balance with their signs. */
function auditOf({ limits }, fields) {
  const works = Object.keys(fields).filter(isWork)
  return [...limits.energies.map(name => [name, 1]), ...works.map(name => [name, -1])].filter(([name]) => name in fields)
}

function energyResidual(data, state, fields) {
  const audit = auditOf(data, fields), frames = fields.energy_kinetic.length
  const total = mapped(frames, k => sumOf(audit.map(([name, sign]) => sign * fields[name][k])))
  const scale = Math.max(numberOf(data, state, "least_energy"), ...audit.map(([name]) => largestOf(fields[name].map(Math.abs))))
  const mechanical = scale > 0 ? largestOf(total.map(one => Math.abs(one - total[0]))) / scale : 0
  return Math.max(mechanical, heatResidual(fields, frames))
}

function heatResidual(fields, frames) {
  if (!("heat_stored" in fields)) return 0
  const signs = [["heat_stored", 1], ["heat_lost", 1], ["energy_dissipated", -1], ["energy_softening", -1]].filter(([name]) => name in fields)
  const total = mapped(frames, k => sumOf(signs.map(([name, sign]) => sign * fields[name][k])))
  const scale = Math.max(...signs.map(([name]) => largestOf(fields[name].map(Math.abs))))
  return scale > 0 ? largestOf(total.map(one => Math.abs(one - total[0]))) / scale : 0
}

function gainedEnergy(data, state, fields, frames) {
  const { limits } = data, inner = ["energy_kinetic", "energy_elastic", "energy_gradient"]
  const held = mapped(frames, k => fields.energy_kinetic[k] + fields.energy_elastic[k])
  const storing = limits.energies.filter(name => !inner.includes(name) && !name.startsWith("energy_dissipated") && name in fields)
  const working = auditOf(data, fields).filter(([, sign]) => sign < 0)
  const stored = mapped(frames, k => sumOf(storing.map(name => fields[name][k])))
  const given = mapped(frames, k => held[0] + stored[0] - stored[k] + sumOf(working.map(([name]) => fields[name][k])))
  const noise = limits.noise * largestOf(held) + numberOf(data, state, "least_energy")
  let most = -Infinity
  const excess = mapped(frames, k => held[k] - (1 + limits.gain) * Math.max(most = Math.max(most, given[k]), 0) - noise)
  const frame = placeOfLargest(excess)
  if (!(excess[frame] > 0)) return ""
  return `in frame ${frame} motion and stress hold ${general(held[frame], 3)} J, but weight and supports gave ${general(given[frame], 3)} J: no filament can be in that state`
}

// ---- Regime and warnings

function regimeOf(data, state, { fields, yielded }, frames, extremes) {
  const { limits } = data
  if (limits.regime === "elastic" || limits.regime === "viscous") return limits.regime
  if (limits.regime === "unflowing") {
    const stress = fields.stress_mean.map((one, k) => Math.abs(one) + Math.abs(fields.stress_bending[k])), limit = numberOf(data, state, "yield_stress")
    return limit > 0 && largestOf(stress) < limit ? "no-yield" : "elastic"
  }
  if (!yielded) return "no-yield"
  if (!isArrested(data, state, fields.plastic_rate, frames)) return "descending"
  if (limits.shaken) return "shaken"
  return reboundOf(extremes) > limits.turns_back ? "arrested-underdamped" : "arrested-overdamped"
}

function isArrested(data, state, plasticRate, frames) {
  const { limits } = data, pace = numberOf(data, state, "pace")
  if (!(pace > 0)) return false
  const share = limits.shaken ? Math.min(1, Math.max(limits.arrest_time, 1 / numberOf(data, state, "cycles"))) : limits.arrest_time
  const from = Math.min(frames - 1, Math.trunc((1 - share) * (frames - 1)))
  return largestOf(plasticRate.subarray(from * plasticRate.length / frames)) < limits.arrest_rate * pace
}

/* Largest rise of the midpoint after it had been lower, relative to its largest sag. */
function reboundOf(extremes) {
  let deepest = -Infinity, most = 0
  for (const [, height] of extremes) {
    deepest = Math.max(deepest, -height)
    most = Math.max(most, deepest + height)
  }
  return deepest > 0 ? most / deepest : 0
}

/* Time and height at both ends and at the turning points of the midpoint, beyond noise. */
function extremesOf({ limits }, numbers) {
  const all = Array.from({ length: numbers.length / 3 }, (_, k) => [numbers[3 * k], numbers[3 * k + 1]])
  return beyond(all, Math.max(limits.turn * largestOf(all.map(([, one]) => Math.abs(one))), limits.no_sag))
}

/* Without swings of this size and smaller ones. */
function beyond(extremes, least) {
  const kept = [0], height = k => extremes[k][1], last = extremes.length - 1
  if (last < 1) return extremes
  for (let k = 1; k <= last; k++) {
    const now = kept[kept.length - 1], before = kept.length > 1 ? kept[kept.length - 2] : now
    if ((height(k) - height(now)) * (height(now) - height(before)) > 0) kept[kept.length - 1] = k
    else if (Math.abs(height(k) - height(now)) > least) kept.push(k)
  }
  return [...kept.slice(0, kept.length === 1 ? 1 : -1), last].map(k => extremes[k])
}

function warningsOf(data, state, run, extremes, outcome, residual) {
  const { limits } = data, found = [thicknessWarning(data, state), descentWarning(data, state)]
  if (limits.surface) found.push(beadsOverSingleCells(data, run))
  if (limits.swells && residual > limits.accuracy) {
    found.push(`the energy residual, ${general(residual, 2)}, exceeds the accuracy of ${general(limits.accuracy)}: with finite-stretch and without thinning the section swells as it is drawn, and energy is not conserved; add thinning to run.effects`)
  }
  if (outcome === "solved") found.push(tooFewFrames(data, run.time, extremes))
  return found.filter(Boolean)
}

function thicknessWarning(data, state) {
  const { limits } = data, slender = numberOf(data, state, "slenderness")
  if (!(slender > limits.thick)) return ""
  const when = limits.moves ? " at the start" : "", [own, first, second] = limits.uncertain
  const uncertain = own + slender * (first + slender * second)
  return `too thick for a filament: h0/L = ${general(slender, 2)}${when}, so that the zones at the ends, a thickness long, fill ${percent(Math.min(1, 2 * slender))} of the span; about ${percent(uncertain)} of the sag is uncertain`
}

function descentWarning(data, state) {
  const { limits } = data, [weight, limit, pull] = ["weight", "limit", "pull"].map(name => numberOf(data, state, name))
  const gravity = weight / (limit + pull)
  if (limits.arrest === null || !(gravity >= limits.arrest)) return ""
  return `it never stops (G = ${general(gravity, 3)}, nothing rests beyond ${general(limits.arrest, 4)}): in a longer run it thins until beads or rupture, neither of which is in the theory, end it`
}

function beadsOverSingleCells({ limits }, { fields, time, X_node }) {
  const length = differences(X_node), frames = time.length, n = length.length
  let found = 0, at = 0
  for (let frame = 0; frame < frames; frame++) {
    const stretch = rowOf(fields.stretch, frame, frames), thickness = rowOf(fields.thickness, frame, frames)
    const long = k => length[k] * stretch[k] / (thickness[k] / 2)
    for (let k = 0; k + 1 < n; k++) {
      const uneven = Math.abs(Math.log(Math.max(stretch[k + 1], 1e-300)) - Math.log(Math.max(stretch[k], 1e-300)))
      const longer = uneven > limits.beaded ? Math.min(long(k + 1), long(k)) : 0
      if (longer > found) [found, at] = [longer, k]
    }
  }
  if (!(found > 1)) return ""
  return `the surface gathers the filament into beads over single cells: at X/L = ${general(placeOf(X_node, at))} they are ${general(found, 2)} radii long, and waves of the surface need less than one; take numerics.cells = ${Math.ceil(Math.floor(n / 2) * found)} or more`
}

/* Frames that show the last swings that can be seen jagged. */
function tooFewFrames({ limits }, time, extremes) {
  const largest = largestOf(extremes.map(([, one]) => Math.abs(one))), turned = beyond(extremes, limits.seen * largest).slice(1, -1)
  const half = Math.min(limits.periods, Math.floor((turned.length - 1) / 2)), frames = time.length
  if (half < 1) return ""
  const [first, last] = [turned[turned.length - 1 - 2 * half], turned[turned.length - 1]], duration = time[frames - 1]
  const perPeriod = (last[0] - first[0]) / half * (frames - 1) / duration
  if (perPeriod >= limits.frames_a_period) return ""
  const frequency = (frames - 1) / perPeriod / duration, enough = Math.ceil(2 * limits.frames_a_period / perPeriod * frames)
  return `it rings at about ${general(frequency, 3)} Hz, with ${general(perPeriod, 2)} frames a period: too few to show the swing, which may look slower than it is in midpoint.csv, pictures and films; run.frames = ${enough} shows it`
}

// ---- To take away

/* The scene as TOML with what the sliders say. */
function tomlOf(data, state) {
  const { keys, toml } = data.scenes[state.scene], lines = toml.split("\n")
  for (const { key, written } of data.sliders) {
    const value = valueOf(data, state, key)
    if (value === keys[key]) continue
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
  const { name, keys } = data.scenes[state.scene]
  const moved = data.sliders.filter(({ key }) => valueOf(data, state, key) !== keys[key])
  const parts = [["scene", name], ...moved.map(({ key }) => [key, String(valueOf(data, state, key))])]
  return parts.map(pair => pair.map(encodeURIComponent).join("=")).join("&")
}

function stateOf(data, hash) {
  const given = {}
  try {
    for (const part of String(hash).replace(/^#/, "").split("&")) {
      const [key, value] = part.split("=").map(decodeURIComponent)
      if (value !== undefined) given[key] = value
    }
  } catch (error) {
    if (error instanceof URIError) return ownState(data)
    throw error
  }
  const scene = data.scenes.findIndex(({ name }) => name === given.scene), state = ownState(data, Math.max(0, scene))
  if (scene < 0) return state
  for (const { key, si, low, high } of data.sliders) {
    const value = Object.hasOwn(given, key) && given[key].trim() ? Number(given[key]) : NaN
    if (value >= low * si * (1 - 1e-9) && value <= high * si * (1 + 1e-9)) state.values[key] = value
  }
  return state
}
