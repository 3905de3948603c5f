// Mouse, fingers and keys, as the player has them: they change the look and tell that they did.

const wheelAmount = 0.0015; // of a dolly, a pixel of the wheel

class Hands {
    constructor(canvas, look, commands, changed) {
        this.canvas = canvas;
        this.look = look;
        this.commands = commands;
        this.changed = changed;
        this.fingers = new Map();
        canvas.addEventListener("pointerdown", (event) => this.press(event));
        canvas.addEventListener("pointermove", (event) => this.move(event));
        for (const name of ["pointerup", "pointercancel"])
            canvas.addEventListener(name, (event) => this.fingers.delete(event.pointerId));
        canvas.addEventListener("wheel", (event) => this.turnWheel(event), { passive: false });
        canvas.addEventListener("contextmenu", (event) => event.preventDefault());
        document.addEventListener("keydown", (event) => this.key(event));
    }

    view() {
        const { clientWidth, clientHeight } = this.canvas;
        const fit = this.fit(clientWidth, clientHeight);
        return this.look.view(this.look.frame(now()), fit);
    }
    hold(camera) {
        this.look.camera = camera;
        this.changed();
    }

    // The place of an event in heights of the picture, to the right and up, from its middle.
    placeOf({ clientX, clientY }) {
        const { left, top, width, height } = this.canvas.getBoundingClientRect();
        return [(clientX - left - width / 2) / height, (top + height / 2 - clientY) / height];
    }

    press(event) {
        this.canvas.setPointerCapture(event.pointerId);
        this.fingers.set(event.pointerId, this.placeOf(event));
        this.pans = event.shiftKey || event.button === 1 || event.button === 2;
    }

    move(event) {
        const before = this.fingers.get(event.pointerId);
        if (!before) return;
        const here = this.placeOf(event);
        const drag = [here[0] - before[0], here[1] - before[1]];
        if (this.fingers.size === 2) this.pinch(event.pointerId, before, here);
        else this.hold(this.pans ? panned(this.view(), drag) : orbited(this.view(), drag));
        this.fingers.set(event.pointerId, here);
    }

    // Two fingers: their distance is the picture's size, their middle moves it.
    pinch(moving, before, here) {
        const [other] = [...this.fingers].find(([id]) => id !== moving).slice(1);
        const apart = (a) => Math.hypot(a[0] - other[0], a[1] - other[1]);
        const middle = [(here[0] + other[0]) / 2, (here[1] + other[1]) / 2];
        const amount = Math.log(Math.max(apart(here), 1e-3) / Math.max(apart(before), 1e-3));
        this.hold(dollied(this.view(), amount, middle));
        this.hold(panned(this.view(), [(here[0] - before[0]) / 2, (here[1] - before[1]) / 2]));
    }

    turnWheel(event) {
        event.preventDefault();
        const pixels = event.deltaY * [1, 16, 400][event.deltaMode];
        const amount = clamp(-pixels * wheelAmount, -1, 1);
        this.hold(dollied(this.view(), amount, this.placeOf(event)));
    }

    key(event) {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        if (event.target.matches?.("input, textarea, select, button, summary")) {
            // Their own keys: a slider's arrows, a button's space.
            const own = [" ", "Enter", "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End"];
            if (own.includes(event.key)) return;
        }
        const command = this.commands[event.key.length === 1 ? event.key.toLowerCase() : event.key];
        if (!command) return;
        event.preventDefault();
        command();
    }
}
