// Decides what is drawn and when: while something moves one small picture after the other, at rest
// the whole one and then the mean of more, and nothing once that is done, nor while the page is hidden.

const restAfter = 150; // milliseconds without a change
const mostPixels = 2.5e6;
const firstScale = 0.25;

const now = () => performance.now() / 1000;

class Painter {
    // `look` tells what is to be seen: look.frame(moment), look.view(frame), look.values, look.playing.
    constructor(canvas, data, look, pageShaders, listeners) {
        this.canvas = canvas;
        this.data = data;
        this.look = look;
        this.pageShaders = pageShaders;
        this.listeners = listeners; // shown(state), failed(error), waits(text)
        this.resolution = new Resolution();
        this.version = 0; // of what is to be seen
        this.changed = -1e9;
        this.drawn = 0;  // pictures, all samples counted
        this.isAtRest = false;
        this.samplesWanted = data.about.pattern.length;
        canvas.addEventListener("webglcontextlost", (event) => {
            event.preventDefault();
            this.version += 1;
            this.gl = undefined;
            this.lost = true;
            this.listeners.waits("The graphics card was reset; waiting for it.");
        });
        canvas.addEventListener("webglcontextrestored", () => {
            this.lost = false;
            this.change();
        });
        document.addEventListener("visibilitychange", () => this.wake?.());
    }

    // Something else is to be seen. `byHand`: more changes are likely to follow.
    change(byHand = true) {
        this.version += 1;
        this.isAtRest = false;
        if (byHand) this.changed = performance.now();
        this.wake?.();
    }

    async run() {
        for (;;) {
            try {
                await this.turn();
            } catch (error) {
                if (error instanceof Stopped || this.isLost()) continue;
                this.listeners.failed(error);
                return;
            }
        }
    }

    isLost() {
        return Boolean(this.lost || this.gl?.isContextLost());
    }

    async turn() {
        if (document.hidden || this.lost) return this.untilWoken();
        if (!this.gl) await this.make();
        if (!this.gl || this.isLost()) return this.pause(500);
        const since = performance.now() - this.changed;
        if (this.look.playing || since < restAfter) return this.drawMoving();
        if (!this.isAtRest) return this.drawResting();
        return this.untilWoken();
    }

    untilWoken() {
        return new Promise((go) => (this.wake = go));
    }
    // Waits until it is woken, and at most so long.
    pause(milliseconds) {
        return Promise.race([this.untilWoken(), soon(milliseconds)]);
    }

    async make() {
        const gl = contextOf(this.canvas);
        if (gl.isContextLost()) return;
        const { about } = this.data;
        this.listeners.waits("Compiling the shaders.");
        gl.bindVertexArray(gl.createVertexArray());
        const current = {};
        const tables = about.surfaces.map((surface, k) => new PassTable(gl, surface, about.tile,
            current, k === 0 ? this.pageShaders : undefined));
        await Promise.all(tables.map((table) => table.compile()));
        if (gl.isContextLost()) return;
        this.tables = tables;
        this.tile = new TileDrawer(gl, about, tables);
        if (!this.tile.isFused) for (const table of tables) await table.compile(true);
        this.screen = new Screen(gl, tables[0], this.tile);
        this.uploadEnvironment(gl);
        this.uploaded = undefined;
        this.elements = tables.map((table, k) =>
            new ElementTextures(gl, table, this.data.surfaces[k]));
        this.gl = gl;
        this.listeners.waits("");
    }

    uploadEnvironment(gl) {
        const { environment, environmentLevels, about } = this.data;
        const upload = (name, halves, [width, height]) => {
            const texture = textureOf(gl, gl.RGB16F, width, height);
            gl.pixelStorei(gl.UNPACK_ALIGNMENT, 2);
            gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGB, gl.HALF_FLOAT, halves);
            for (const table of this.tables) table.bind(name, texture);
        };
        if (environment) upload("environment_map", environment, about.environment);
        if (environmentLevels)
            upload("environment_levels", environmentLevels, about.environmentLevels);
    }

    // Uploads what does not depend on the camera, and the lights.
    upload({ frame, moment, aim }, views) {
        const held = this.look.held(frame, moment);
        const middle = ballAbout(views[0]).centre;
        const key = held?.key ?? `${frame} ${moment}`;
        this.data.surfaces.forEach((values, k) => {
            const table = this.tables[k], elements = this.elements[k], its = held?.surfaces[k];
            const parameters = its?.parameters ?? values.floats("parameters", frame, moment);
            elements.uploadGrid(frame, moment, Boolean(its), parameters);
            table.setBlock("Parameters", parameters);
            const shading = values.floats("shading", frame, moment);
            const own = this.data.view(frame, moment, k);
            moveLights(shading, this.data.about, own, views[k], middle, aim);
            table.setBlock("Shading", shading);
            if (k === 0) this.background = Array.from(shading.subarray(4, 8));
            if (this.uploaded === key) return;
            table.setEffects(values.effects(frame, moment));
            elements.upload(its?.arrays ??
                values.about.arrays.map((_, a) => values.elements(a, frame, moment)));
        });
        this.uploaded = key;
    }

    // Sets how rays see the surfaces; gives the ranges of their beams.
    aimAt(views, { width, height, aim }) {
        return this.data.about.surfaces.map(({ settings, beams }, k) => {
            const table = this.tables[k], view = views[k];
            table.setBlock("Frame", frameBlock(view, settings, width, height, aim));
            if (views.length > 1) table.setEffects(uniformsAmong(views, k, width, height, aim));
            return beams.map(({ block }) => beamRange(view, width, height, aim, block));
        });
    }

    // The screen's pixels, as many as are drawn at rest.
    size() {
        const { clientWidth, clientHeight } = this.canvas;
        let ratio = Math.min(window.devicePixelRatio || 1, 2);
        ratio *= Math.min(1, Math.sqrt(mostPixels / (clientWidth * clientHeight * ratio * ratio)));
        return [clientWidth, clientHeight].map((side) => Math.max(1, Math.round(side * ratio)));
    }

    // What is seen of a frame in picture k of those whose mean it is.
    picture(frame, width, height, k) {
        const { pattern, moments } = this.data.about;
        return { frame, width, height, aim: pattern[k], moment: Math.min(k, moments.length - 1) };
    }

    // One picture of all tiles. `go` is asked between them.
    async drawPicture(picture, go) {
        const { data, tile, screen } = this;
        const { frame, moment, width, height } = picture;
        const views = this.look.views(frame, this.fitOf(width, height), moment);
        this.upload(picture, views);
        const inputs = { background: this.background, beams: this.aimAt(views, picture) };
        const side = data.about.tile;
        for (let y = 0; y < height; y += side) {
            for (let x = 0; x < width; x += side) {
                const part = { x, y, width: Math.min(side, width - x),
                    height: Math.min(side, height - y) };
                await tile.draw(inputs, part, go);
                go();
                if (this.verdicts) tile.tally(part).forEach((n, k) => (this.verdicts[k] += n));
                screen.add(part);
            }
        }
        screen.finishPicture();
        this.drawn += 1;
    }

    present(frame, width, height, samples) {
        const { canvas } = this;
        const [across, up] = this.size();
        if (canvas.width !== across || canvas.height !== up)
            Object.assign(canvas, { width: across, height: up });
        this.screen.show();
        this.listeners.shown({ frame, width, height, samples });
    }

    fitOf(width, height) {
        const [ownWidth, ownHeight] = this.data.about.size;
        return Math.max(1, (Math.min(1, ownWidth / ownHeight) * height) / width);
    }

    // Draws one picture with sides smaller by the scale, and shows it.
    async drawSmall(frame, scale, go) {
        const [width, height] = this.size().map((side) => Math.max(1, Math.round(side * scale)));
        this.screen.begin(width, height);
        await this.drawPicture(this.picture(frame, width, height, 0), go);
        this.present(frame, width, height, 1);
    }

    async drawMoving() {
        await new Promise((go) => requestAnimationFrame(go));
        const { version } = this;
        const frame = this.look.frame(now());
        const isSame = frame === this.movingFrame && version === this.movingVersion;
        if (isSame) return this.look.playing ? undefined : this.pause(20);
        const begin = performance.now();
        await this.drawSmall(frame, this.resolution.scale, () => {
            if (this.isLost()) throw new Stopped();
        });
        this.resolution.measured(performance.now() - begin);
        [this.movingFrame, this.movingVersion] = [frame, version];
        this.isAtRest = false;
    }

    async drawResting() {
        const { version } = this;
        const frame = this.look.frame(now());
        const [width, height] = this.size();
        const expectWanted = () => {
            if (this.isLost() || version !== this.version || document.hidden) throw new Stopped();
        };
        // The first picture of all is to come soon.
        if (!this.screen.shown) await this.drawSmall(frame, firstScale, expectWanted);
        this.screen.begin(width, height);
        if (this.tallies) this.verdicts = Array(8).fill(0);
        for (let k = 0; k < this.samplesWanted; ++k) {
            await this.drawPicture(this.picture(frame, width, height, k), expectWanted);
            if (k === 0 && this.tallies) [this.told, this.verdicts] = [this.verdicts, undefined];
            this.present(frame, width, height, k + 1);
        }
        this.isAtRest = true;
        this.movingVersion = version;
        this.movingFrame = frame;
    }
}
