// Several surfaces in passes, as src/render/several_surfaces.cpp draws them: each is marched by its
// own, the nearest hit counts, and rays that begin on one surface see all.

const keptTextures = 4; // of what is kept of an end: shaders/surfaces/nearest.glsl

// Two targets in turn: the pass of each surface reads what those before it drew.
class Relay {
    constructor(surface, textures) {
        this.targets = [0, 1].map(() => surface.newFloats(textures));
        this.at = 1;
    }
    get last() {
        return this.targets[this.at];
    }
    next() {
        this.at = 1 - this.at;
        return this.last;
    }
}

class SeveralSurfaces {
    constructor(gl, all) {
        this.gl = gl;
        this.all = all;
        const [first] = all;
        this.ends = new Relay(first, keptTextures);
        if (first.table.has("mirror")) {
            this.mirrored = new Relay(first, keptTextures);
            this.seen = first.newFloats(1);
        }
        if (first.table.has("occlusion")) this.open = new Relay(first, 1);
    }

    // Draws into `result`. `ranges` are those of the beams of each surface.
    async draw(ranges, size, result, go) {
        await this.findEnds(ranges, size, go);
        if (this.mirrored) await this.seeInMirrors(size, go);
        const hidden = await this.castShadows(size, go);
        if (this.open) this.lookAround(size);
        this.all.forEach((one, k) => {
            const { table } = one;
            table.bindNumbered("state_texture", this.rays[k]);
            table.bindNumbered("surface_texture", this.ends.last);
            if (this.seen) table.bind("seen_texture", this.seen.textures[0]);
            if (hidden) table.bind("shadow_texture", hidden.textures[1]);
            if (this.open) table.bind("occlusion_texture", this.open.last.textures[0]);
            one.run("shade", result, size);
        });
    }

    async findEnds(ranges, size, go) {
        this.rays = [];
        for (const [k, one] of this.all.entries()) {
            one.drawBeams(ranges[k], size);
            one.table.bindNumbered("surface_texture", this.ends.last);
            this.rays.push(await one.march("march", size, go));
            one.run("surface", this.ends.next(), size);
        }
    }

    async seeInMirrors(size, go) {
        const { gl, all, ends, mirrored, seen } = this;
        for (const one of all) {
            one.table.bindNumbered("surface_texture", ends.last);
            await one.march("mirror", size, go);
            one.table.bindNumbered("mirrored_texture", mirrored.last);
            one.run("mirrorSurface", mirrored.next(), size);
        }
        seen.bind();
        gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
        all.forEach((one, k) => {
            one.table.bindNumbered("state_texture", this.rays[k]);
            one.table.bindNumbered("surface_texture", ends.last);
            one.table.bindNumbered("mirrored_texture", mirrored.last);
            one.run("seen", seen, size);
        });
    }

    // The states of the last surface's shadow rays tell all that is hidden.
    async castShadows(size, go) {
        let ended;
        for (const one of this.all) {
            if (!one.table.has("shadow")) continue;
            one.table.bindNumbered("surface_texture", this.ends.last);
            if (ended) one.table.bind("shadow_texture", ended.textures[1]);
            ended = await one.march("shadow", size, go);
        }
        return ended;
    }

    lookAround(size) {
        for (const one of this.all) {
            one.table.bindNumbered("surface_texture", this.ends.last);
            one.table.bind("occlusion_texture", this.open.last.textures[0]);
            one.run("occlusion", this.open.next(), size);
        }
    }
}
