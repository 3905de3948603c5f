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
    view(frame, fit = 1) {
        const own = this.data.view(frame);
        const view = { ...own, ...this.camera, fit };
        // What was in focus at the target stays so.
        const wasAtTarget = Math.abs(own.focus - distanceOf(own)) <= 1e-9 * own.focus;
        if (wasAtTarget) view.focus = distanceOf(view);
        return view;
    }
    // The value of a parameter, held or not.
    value({ name, place }, frame) {
        return this.values.get(name) ?? this.data.parameter(place, frame);
    }

    address() {
        const frame = this.frame(now());
        return addressOf({ frame, view: this.view(frame), moved: this.camera !== undefined,
            values: this.values });
    }
    read(hash) {
        const { frame, camera, values } =
            readAddress(hash, this.data.about, (at) => this.data.view(at));
        if (frame !== undefined)
            this.playback = { ...scrubbed(this.playback, frame, now()), playing: false };
        this.camera = camera;
        this.values = values;
        return frame !== undefined;
    }
}
