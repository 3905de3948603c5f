// Vectors of three numbers and, column by column, matrices of nine.

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (s, a) => [s * a[0], s * a[1], s * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
];
const length = (a) => Math.sqrt(dot(a, a));
const normalized = (a) => times(1 / length(a), a);
const largest = (a) => Math.max(...a.map(Math.abs));
const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
const radians = (degrees) => (degrees * Math.PI) / 180;

// The transposed matrix, which turns back, times a vector.
const turnedBack = (m, v) => [dot(m.slice(0, 3), v), dot(m.slice(3, 6), v), dot(m.slice(6, 9), v)];
const turned = (m, v) => add(add(times(v[0], m.slice(0, 3)), times(v[1], m.slice(3, 6))),
    times(v[2], m.slice(6, 9)));
