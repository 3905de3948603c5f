// What stands around the picture: transport, marks, sliders, the formula and its source.

const element = (id) => document.getElementById(id);

function made(name, properties = {}, ...children) {
    const node = Object.assign(document.createElement(name), properties);
    node.append(...children);
    return node;
}

const shown = (value) => String(Number(value.toPrecision(4)));

// In place of the picture: why there is none, and the movie if the page has one.
function showFailure(text) {
    element("failure").textContent = text;
    element("failure").hidden = false;
    const movie = element("movie");
    if (movie) movie.hidden = false;
}

class Panel {
    constructor(data, look, commands, changed) {
        this.data = data;
        this.look = look;
        this.changed = changed;
        const { about } = data;
        element("formula").textContent = about.formula;
        element("source").textContent = about.source || "The scene's file is too long to be shown.";
        element("accuracy").hidden = !about.accuracy;
        element("accuracy").querySelector("p").textContent = about.accuracy ?? "";
        element("frame").max = about.frames;
        element("transport").hidden = about.frames === 1;
        element("frame").addEventListener("input", () => {
            look.playback = scrubbed(look.playback, Number(element("frame").value), now());
            changed();
        });
        for (const [id, name] of [["play", " "], ["copy", "c"], ["reset", "r"], ["theme", "d"],
            ["about-button", "p"]]) {
            element(id).addEventListener("click", () => commands[name]());
        }
        about.markers.forEach((marker) => this.addMarker(marker));
        this.sliders = about.sliders.map((slider) => this.addSlider(slider));
        element("sliders").hidden = this.sliders.length === 0;
    }

    addMarker({ kind, frame, label }) {
        const { frames } = this.data.about;
        const mark = made("button", { className: `mark ${kind}`, title: label, type: "button" });
        mark.setAttribute("aria-label", label);
        mark.style.setProperty("--at", (frame - 1) / Math.max(frames - 1, 1));
        mark.addEventListener("click", () => {
            const whole = clamp(Math.floor(frame), 1, frames);
            this.look.playback =
                { ...scrubbed(this.look.playback, whole, now()), playing: false };
            this.changed();
            this.say(label);
        });
        element("marks").append(mark);
    }

    // Double click gives a parameter back to the animation.
    addSlider(slider) {
        const { name, least, most } = slider;
        const input = made("input",
            { type: "range", min: least, max: most, step: (most - least) / 1000 });
        const output = made("output");
        const free = made("button", { type: "button", textContent: "×",
            title: `Give ${name} back to the animation` });
        const row = made("label", { className: "slider" },
            made("span", { textContent: name, title: name }), input, output, free);
        input.setAttribute("aria-label", name);
        input.addEventListener("input", () => {
            this.look.values.set(name, Number(input.value));
            this.changed();
        });
        free.addEventListener("click", (event) => {
            event.preventDefault();
            this.look.values.delete(name);
            this.changed();
        });
        element("sliders").append(row);
        return { slider, input, output, row };
    }

    // What is seen now.
    update() {
        const { look } = this;
        const { about } = this.data;
        const frame = look.frame(now());
        if (Number(element("frame").value) !== frame) element("frame").value = frame;
        element("frame-number").textContent = `${frame} / ${about.frames}`;
        const isPlaying = look.playing;
        element("play-icon").setAttribute("href", isPlaying ? "#icon-pause" : "#icon-play");
        element("play").setAttribute("aria-label", isPlaying ? "Pause" : "Play");
        const speed = 2 ** look.playback.doublings;
        element("speed").textContent = speed === 1 ? "" : speed < 1 ? `1/${1 / speed} ×` : `${speed} ×`;
        element("reset").disabled = !look.camera;
        for (const { slider, input, output, row } of this.sliders) {
            const value = look.value(slider, frame);
            if (Number(input.value) !== value) input.value = value;
            output.textContent = shown(value);
            row.classList.toggle("held", look.values.has(slider.name));
        }
    }

    // A few words for a few seconds.
    say(text) {
        element("said").textContent = text;
        clearTimeout(this.silence);
        this.silence = setTimeout(() => (element("said").textContent = ""), 4000);
    }

    waits(text) {
        element("waits").textContent = text;
    }
    fail(error) {
        showFailure(error instanceof NotPossible ? error.message
            : `The page failed: ${error.message}`);
        element("waits").textContent = "";
    }
}
