// The resolution while something moves, so that pictures keep coming: a picture at scale s of the
// screen's sides is taken to cost what the last one did, times the square of s. Scales are the ladder
// 2^(-k/4), so that they stand still while the cost does.

const mostRungs = 16;
const wantedMilliseconds = 33;
const scaleOf = (rung) => 2 ** (-rung / 4);

class Resolution {
    constructor() {
        this.rung = 4;
        this.roomy = 0; // pictures in a row that left room for a larger one
    }

    get scale() {
        return scaleOf(this.rung);
    }

    // Takes the cost of a picture at this scale into account.
    measured(milliseconds) {
        const wanted = this.rung + Math.ceil(2 * Math.log2(milliseconds / wantedMilliseconds));
        if (wanted > this.rung) {
            this.rung = Math.min(wanted, mostRungs);
            this.roomy = 0;
            return;
        }
        // The next rung up costs 1.4 times as much.
        const hasRoom = milliseconds * 1.5 < wantedMilliseconds && this.rung > 0;
        this.roomy = hasRoom ? this.roomy + 1 : 0;
        if (this.roomy < 3) return;
        this.rung -= 1;
        this.roomy = 0;
    }
}
