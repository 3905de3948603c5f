// What a person looks at: a moment of the playback, a camera in place of the scene's, values that
// sliders hold in place of the animation's.

class Look {
    constructor(data) {
        this.data = data;
        this.playback = playbackOf(data.about);
        this.camera = undefined;
        this.values = new Map();
    }

    get playing() {
        if (hasEnded(this.playback, now())) this.playback = toggledOff(this.playback, now());
        return this.playback.playing;
    }
    frame(moment) {
        return frameAt(this.playback, moment);
    }
    // `moment` is one of the frame's, while the shutter is open.
    view(frame, fit = 1, moment = 0, surface = 0) {
        const own = this.data.view(frame, moment, surface);
        const held = this.held(frame, moment)?.surfaces[surface].view;
        const view = { ...own, ...held, isHeld: held !== undefined, ...this.camera, fit };
        // What was in focus at the target stays so.
        const wasAtTarget = Math.abs(own.focus - distanceOf(own)) <= 1e-9 * own.focus;
        if (wasAtTarget) view.focus = distanceOf(view);
        return view;
    }
    // The views of all surfaces.
    views(frame, fit, moment) {
        return this.data.surfaces.map((_, k) => this.view(frame, fit, moment, k));
    }
    // The frame with the values that sliders hold and what follows them; none if nothing is held.
    held(frame, moment = 0) {
        if (this.values.size === 0) return undefined;
        const key = JSON.stringify([frame, moment, ...this.values]);
        if (this.known?.key === key) return this.known;
        const places = this.data.surfaces.map(() => new Map());
        for (const { name, surface, place } of this.data.about.sliders) {
            if (this.values.has(name)) places[surface].set(place, this.values.get(name));
        }
        const time = this.data.seconds(frame, moment);
        this.known = { key, surfaces: this.data.surfaces.map((of, k) =>
            heldFrame(of, frame, moment, time, places[k])) };
        return this.known;
    }
    // The value of a parameter, held or not.
    value({ name, surface, place }, frame) {
        const parameters = this.held(frame)?.surfaces[surface].parameters ??
            this.data.surfaces[surface].floats("parameters", frame, 0);
        return this.values.get(name) ?? parameters[place];
    }

    address() {
        const frame = this.frame(now());
        return addressOf({ frame, view: this.view(frame), moved: this.camera !== undefined,
            values: this.values });
    }
    read(hash) {
        const { frame, camera, values } =
            readAddress(hash, this.data.about, (at) => this.data.view(at, 0));
        if (frame !== undefined)
            this.playback = { ...scrubbed(this.playback, frame, now()), playing: false };
        this.camera = camera;
        this.values = values;
        return frame !== undefined;
    }
}
