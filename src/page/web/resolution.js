// The resolution while something moves, so that pictures keep coming: src/player/draw's controller in
// fewer words. A picture at scale s of the screen's sides is taken to cost a + b s^2 milliseconds, both
// fitted to the last pictures. Scales are the ladder 2^(-k/4); they fall after two pictures in a row
// that took too long, so that a hiccup changes nothing, and rise where there was room several times.
// Where a alone takes too long, smaller pictures would not come sooner: then it is a that decides.

const mostRungs = 16;
const wantedMilliseconds = 33;
const remembered = 8; // pictures
const patience = 4;   // pictures that leave room before a larger one is tried
const tallestRise = 4;
const tries = 40; // pictures of one size, after which another tells a from b
const compiled = 2; // pictures, of which the first ones wait for the card's compiler
const scaleOf = (rung) => 2 ** (-rung / 4);

// Fits a and b by least squares of relative errors, neither below 0. Pictures of one size do not
// tell a from b: then the shape of before stays.
function costOf(pictures, before) {
    let x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    const areas = pictures.map(({ scale }) => scale * scale);
    pictures.forEach(({ milliseconds }, k) => {
        const u = 1 / milliseconds, v = areas[k] / milliseconds;
        x += u, y += v, xx += u * u, xy += u * v, yy += v * v;
    });
    if (Math.max(...areas) < 1.9 * Math.min(...areas)) {
        const part = (k) => (before.fixed + before.filled * areas[k]) / pictures[k].milliseconds;
        let c = 0, cc = 0;
        pictures.forEach((_, k) => ((c += part(k)), (cc += part(k) ** 2)));
        return { fixed: (before.fixed * c) / cc, filled: (before.filled * c) / cc };
    }
    const determinant = xx * yy - xy * xy;
    const fixed = (x * yy - y * xy) / determinant, filled = (y * xx - x * xy) / determinant;
    if (!(fixed >= 0)) return { fixed: 0, filled: y / yy };
    if (!(filled >= 0)) return { fixed: x / xx, filled: 0 };
    return { fixed, filled };
}

class Resolution {
    constructor() {
        this.rung = 4;
        this.pictures = [];
        this.cost = { fixed: 4, filled: 100 }; // until more is known
        this.over = 0;  // pictures in a row that took too long
        this.roomy = 0; // that left room for a larger one
        this.steady = -compiled; // pictures at this scale
    }

    get scale() {
        return scaleOf(this.rung);
    }

    // The largest picture that takes this part of the time wanted.
    largestWithin(part) {
        const { fixed, filled } = this.cost;
        const milliseconds = part * Math.max(wantedMilliseconds, 1.5 * fixed);
        let rung = 0;
        while (rung < mostRungs && fixed + filled * scaleOf(rung) ** 2 > milliseconds) ++rung;
        return rung;
    }

    choose(rung) {
        if (rung !== this.rung) this.steady = 0;
        this.rung = rung;
        this.over = this.roomy = 0;
    }

    // Takes the cost of a picture at this scale into account.
    measured(milliseconds) {
        this.steady += 1;
        if (this.steady <= 0 && this.pictures.length === 0) return;
        this.pictures = [...this.pictures, { scale: this.scale, milliseconds }].slice(-remembered);
        this.cost = costOf(this.pictures, this.cost);
        const isOver = milliseconds > Math.max(wantedMilliseconds, 1.5 * this.cost.fixed);
        this.over = isOver ? this.over + 1 : 0;
        if (this.over >= 2 || (isOver && this.pictures.length === 1))
            return this.choose(Math.max(this.rung, this.largestWithin(0.9)));
        const higher = this.largestWithin(0.8);
        this.roomy = !isOver && higher < this.rung ? this.roomy + 1 : 0;
        if (this.roomy >= patience) this.choose(Math.max(higher, this.rung - tallestRise));
        else if (this.steady >= tries && this.rung > 0) this.choose(Math.max(this.rung - 2, 0));
    }
}
