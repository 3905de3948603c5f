// What follows a slider: src/page/rules.h says how expressions are kept, and src/formula what they
// mean. Numbers are doubles, cut off at +-1e300.

const saturation = 1e300;
const saturated = (a) => (a > saturation ? saturation : a < -saturation ? -saturation : a);

// erf(a) by its series exp(-a^2) (a + 2 a^3/3 + 4 a^5/15 + ...) 2/sqrt(pi), whose terms have one
// sign. From 6 on it is 1 in doubles.
function errorFunction(a) {
    if (Math.abs(a) > 6) return Math.sign(a);
    let term = a, sum = a;
    for (let n = 1; Math.abs(term) > 1e-17 * Math.abs(sum); ++n) {
        term *= (2 * a * a) / (2 * n + 1);
        sum += term;
    }
    return (2 / Math.sqrt(Math.PI)) * Math.exp(-a * a) * sum;
}

// Gradient noise: src/formula/graph/noise.h.
function noise(x, y, z) {
    const low = [x, y, z].map(Math.floor);
    const [u, v, w] = [x - low[0], y - low[1], z - low[2]];
    const primes = [0x9e3779b1, 0x85ebca77, 0xc2b2ae3d];
    const period = 2 ** 20;
    const fade = (t) => t * t * t * (10 + t * (6 * t - 15));
    let sum = 0;
    for (let corner = 0; corner < 8; ++corner) {
        const which = [corner & 1, (corner >> 1) & 1, corner >> 2];
        let h = 0;
        for (const [k, prime] of primes.entries()) {
            const wrapped = low[k] - period * Math.floor(low[k] / period) + which[k];
            h ^= Math.imul(wrapped % period, prime);
        }
        h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d);
        h = Math.imul(h ^ (h >>> 12), 0x297a2d39);
        h ^= h >>> 15;
        const across = ((h >>> 16) * 3) >>> 16;
        const away = [u - which[0], v - which[1], w - which[2]];
        const along = away.filter((_, axis) => axis !== across);
        const rise = (h & 1 ? -along[0] : along[0]) + (h & 2 ? -along[1] : along[1]);
        const weights = [u, v, w].map((t, axis) => (which[axis] ? fade(t) : 1 - fade(t)));
        sum += rise * weights[0] * weights[1] * weights[2];
    }
    return sum;
}

const operations = {
    negate: (a) => -a,
    abs: Math.abs,
    sign: Math.sign,
    sqrt: (a) => (a < 0 ? 0 : Math.sqrt(a)),
    exp: (a) => saturated(Math.exp(a)),
    log: (a) => (a === 0 ? -saturation : saturated(Math.log(a))),
    sin: Math.sin,
    cos: Math.cos,
    tan: (a) => saturated(Math.tan(a)),
    sinh: (a) => saturated(Math.sinh(a)),
    cosh: (a) => saturated(Math.cosh(a)),
    tanh: Math.tanh,
    asin: (a) => Math.asin(clamp(a, -1, 1)),
    acos: (a) => Math.acos(clamp(a, -1, 1)),
    atan: Math.atan,
    atan2: (a, b) => Math.atan2(a + 0, b + 0),
    angle: (a, b) => operations.atan2(a, b),
    floor: Math.floor,
    asinh: Math.asinh,
    acosh: (a) => (a < 1 ? 0 : Math.acosh(a)),
    erf: errorFunction,
    cbrt: Math.cbrt,
    add: (a, b) => a + b,
    subtract: (a, b) => a - b,
    multiply: (a, b) => a * b,
    divide: (a, b) => {
        if (b !== 0) return saturated(a / b);
        return a > 0 ? saturation : a < 0 ? -saturation : NaN;
    },
    min: (a, b) => (a < b ? a : b),
    max: (a, b) => (a < b ? b : a),
    power: (a, b) => {
        if (b === 0) return 1;
        if (a === 0) return b > 0 ? 0 : saturation;
        return saturated(a ** b);
    },
    noise,
    select: (a, b, then, otherwise) => (a < b ? then : otherwise),
};

// A hash of the seed and both arguments, in [0, 1): random_unit() of src/formula/evaluate.
const knownRandom = new Map();
function randomUnit(seed, ...words) {
    const key = `${seed} ${words}`;
    if (!knownRandom.has(key)) knownRandom.set(key, newRandom(seed, words));
    return knownRandom.get(key);
}
function newRandom(seed, words) {
    const wrapped = (x) => BigInt.asUintN(64, x);
    const view = new DataView(new ArrayBuffer(8));
    let h = BigInt(seed);
    for (const word of words) {
        view.setFloat64(0, word === 0 ? 0 : word);
        h ^= view.getBigUint64(0);
        h = wrapped(h + 0x9e3779b97f4a7c15n);
        h = wrapped((h ^ (h >> 30n)) * 0xbf58476d1ce4e5b9n);
        h = wrapped((h ^ (h >> 27n)) * 0x94d049bb133111ebn);
        h ^= h >> 31n;
    }
    return Number(h >> 11n) * 2 ** -53;
}

// The value of a program: `inputs` are t, i and n, `siblings` the other fields of an element.
function valueOf({ code, out }, seed, inputs, tracks, siblings) {
    const registers = [];
    for (const [result, operation, ...operands] of code) {
        const [first] = operands;
        registers[result] =
            operation === "constant" ? first
            : operation === "input" ? inputs[first]
            : operation === "parameter" ? tracks[first]
            : operation === "sibling" ? siblings[first]
            : operation === "random" ? randomUnit(seed, ...operands.map((r) => registers[r]))
            : operations[operation](...operands.map((r) => registers[r]));
    }
    return registers[out];
}

const strideOf = (fields) =>
    4 * Math.max(1, Math.ceil((Math.max(...fields.map(({ slot }) => slot)) + 1) / 4));

// Puts the fields that are worked out by expressions into `texels`: src/page/computed_elements.h.
function fillElements(texels, fields, computed, count, seed, time) {
    const stride = strideOf(fields);
    const tracks = [];
    for (const [place, given] of computed.tracks)
        tracks[place] = typeof given === "number" ? given : valueOf(given, seed, [time], tracks);
    const isNeeded = fields.map((_, k) => computed.fields.includes(k));
    for (let k = fields.length; k-- > 0;) {
        if (!isNeeded[k]) continue;
        for (const [, operation, at] of fields[k].program?.code ?? [])
            if (operation === "sibling") isNeeded[at] = true;
    }
    for (let i = 0; i < count; ++i) {
        const siblings = [], inputs = [time, i, count];
        fields.forEach(({ slot, program, values }, k) => {
            if (!isNeeded[k]) return;
            siblings[k] = program ? valueOf(program, seed, inputs, tracks, siblings)
                : values ? (values.length === 1 ? values[0] : values[i] ?? 0)
                : texels[i * stride + slot];
            if (computed.fields.includes(k)) texels[i * stride + slot] = siblings[k];
        });
    }
}

// The elements of an array, `texels` as the shaders read them, where tracks have other values.
function movedElements(fields, texels, count, seed, time, tracks, changed) {
    const moved = texels.slice();
    const stride = strideOf(fields);
    const follows = fields.map(() => false);
    fields.forEach(({ program }, k) => {
        follows[k] = Boolean(program) && (program.tracks.some((track) => changed.has(track)) ||
            program.code.some(([, operation, at]) => operation === "sibling" && follows[at]));
    });
    for (let i = 0; i < count; ++i) {
        const siblings = [];
        fields.forEach(({ slot, program, values }, k) => {
            const inputs = [time, i, count];
            if (values) siblings[k] = values.length === 1 ? values[0] : values[i] ?? 0;
            else if (program && (follows[k] || slot < 0))
                siblings[k] = valueOf(program, seed, inputs, tracks, siblings);
            else siblings[k] = texels[i * stride + slot];
            if (follows[k] && slot >= 0) moved[i * stride + slot] = siblings[k];
        });
    }
    return moved;
}

// The numbers of the bounds as a view has them.
function movedBounds(view, changedNumbers) {
    if (view.box) {
        const corners = [...view.min, ...view.max];
        changedNumbers.forEach(([k, value]) => (corners[k] = value));
        const min = corners.slice(0, 3), max = corners.slice(3);
        if (min.some((x, k) => !(x < max[k]))) return {};
        return { min, max, centre: times(0.5, add(min, max)), radius: 0.5 * length(sub(max, min)) };
    }
    const sphere = [...view.centre, view.radius];
    changedNumbers.forEach(([k, value]) => (sphere[k] = value));
    const [x, y, z, radius] = sphere;
    if (!(radius > 0)) return {};
    const centre = [x, y, z];
    return { centre, radius, min: centre.map((c) => c - radius), max: centre.map((c) => c + radius) };
}

// A moment of a frame of a surface where some parameters are held: `held` maps their places to
// numbers. Gives the block of parameters, the arrays' elements and what changes of the view.
function heldFrame(data, frame, moment, time, held) {
    const { rules, arrays } = data.about;
    const parameters = data.floats("parameters", frame, moment);
    const tracks = Array.from(parameters);
    const changed = new Set(held.keys());
    for (const [place, value] of held) tracks[place] = value;
    for (const [place, program] of rules.tracks) {
        if (held.has(place) || !program.tracks.some((track) => changed.has(track))) continue;
        tracks[place] = valueOf(program, rules.seed, [time], tracks);
        changed.add(place);
    }
    for (const place of changed) parameters[place] = tracks[place];
    const bounds = rules.bounds
        .filter(([, program]) => program.tracks.some((track) => changed.has(track)))
        .map(([k, program]) => [k, valueOf(program, rules.seed, [time], tracks)]);
    const view = data.view(frame, moment);
    return {
        parameters,
        arrays: arrays.map((_, a) => movedElements(rules.arrays[a],
            data.elements(a, frame, moment), data.count(a, frame, moment), rules.seed, time,
            tracks, changed)),
        // Elements may have become smaller than the animation has them: steps have to.
        view: { ...movedBounds(view, bounds), elementRadius: 0.25 * view.elementRadius },
    };
}
