// Playing as a pure function of a clock, as src/player/model/playback.cpp has it: a playback is a
// straight line from its anchor, and whatever a person does is a new line. Moments are seconds;
// positions count frames from 1, 7.9 shows frame 7.

const leastDoublings = -3, mostDoublings = 3;

function playbackOf(about) {
    const [numerator, denominator] = about.fps;
    return { rate: numerator / denominator, last: about.frames, loop: about.loops, playing: false,
        doublings: 0, anchor: 1, moment: 0 };
}

function positionAt(p, now) {
    const passed = p.playing ? Math.max(now - p.moment, 0) * p.rate * 2 ** p.doublings : 0;
    const position = p.anchor + passed;
    if (position < p.last + 1) return position;
    return p.loop ? 1 + ((position - 1) % p.last) : p.last;
}

const frameAt = (p, now) => clamp(Math.floor(positionAt(p, now)), 1, p.last);
const hasEnded = (p, now) => p.playing && !p.loop &&
    p.anchor + (now - p.moment) * p.rate * 2 ** p.doublings >= p.last + 1;

const anchored = (p, now, changes = {}) =>
    ({ ...p, anchor: positionAt(p, now), moment: now, ...changes });

const toggledOff = (p, now) => anchored(p, now, { playing: false });

function toggled(p, now) {
    if (p.playing && !hasEnded(p, now)) return toggledOff(p, now);
    const again = !p.loop && frameAt(p, now) === p.last;
    return anchored(p, now, { playing: p.last > 1, ...(again ? { anchor: 1 } : {}) });
}

function stepped(p, frames, now) {
    const frame = frameAt(p, now) + frames;
    const anchor = p.loop ? ((frame - 1 + p.last) % p.last) + 1 : clamp(frame, 1, p.last);
    return anchored(p, now, { playing: false, anchor });
}

const scrubbed = (p, frame, now) => anchored(p, now, { anchor: clamp(frame, 1, p.last) });
const withSpeed = (p, doublings, now) =>
    anchored(p, now, { doublings: clamp(doublings, leastDoublings, mostDoublings) });
const withLoop = (p, loop, now) => anchored(p, now, { loop });
