// Draws one tile of a picture, as src/render/renderer.cpp does: beams, then march and picture in one
// draw, or rays in as many passes as they take and what is lit from their ends.

class TileDrawer {
    constructor(gl, about, table) {
        this.gl = gl;
        this.about = about;
        this.table = table;
        const side = about.tile;
        const float = gl.RGBA32F;
        const target = (formats) => new Target(gl, side, side, formats).expectComplete();
        this.keepsSurfaces = table.has("surface");
        this.result = new Target(gl, side, side,
            [float, this.keepsSurfaces ? gl.RG32UI : gl.R32UI]).withDepth().expectComplete();
        this.newStates = () => [0, 1].map(() => target(Array(about.stateTextures).fill(float)));
        this.newEnds = () => target([float, float, float]);
        this.beams = about.beams.map(({ block, masks }) => {
            const blocks = Math.ceil(side / block);
            return new Target(gl, blocks, blocks, [float]).withLayers(gl.RGBA32UI, masks)
                .expectComplete();
        });
        if (table.has("beamCopies")) this.lists = this.newLists();
        this.isFused = table.has("fused"); // as long as every ray ended in one draw
        this.counter = target([gl.R8]); // nothing is drawn into it, but fragments are counted
        this.states = new Map();
        if (this.keepsSurfaces) this.ends = this.newEnds();
        if (table.has("mirror")) this.mirrorEnds = this.newEnds();
    }

    // A texture for each level of beams, which smaller ones read, or rays: its lists, and those of
    // the levels before.
    newLists() {
        const { gl, about, beams, table } = this;
        return beams.map(({ width, height }, level) => {
            const { lists, listRows } = about.beams[level];
            const rows = table.listRows[level] + listRows * height;
            return new Target(gl, 16 * lists * width, rows, [gl.RGBA32F]).expectComplete();
        });
    }

    statesOf(role) {
        if (!this.states.has(role)) this.states.set(role, this.newStates());
        return this.states.get(role);
    }

    // `inputs`: what painter.js made of a frame; `tile`: x, y, width, height in the picture. Leaves
    // the tile in `result`. `go` throws where the picture is given up.
    async draw(inputs, tile, go) {
        const { table } = this;
        const size = { width: tile.width, height: tile.height };
        this.at = [tile.x, tile.y];
        this.drawBeams(inputs, size);
        if (this.isFused) {
            this.drawFused(inputs, size);
            if (!(await this.anyUnfinished(size))) return;
            // Some ray takes longer than a draw may; others of this scene will too.
            this.isFused = false;
            await table.compile(true);
        }
        await this.drawInPasses(size, go);
    }

    run(role, target, size, level = 0) {
        const program = this.table.program(role, level);
        program.set("tile_origin", this.at);
        target.bind();
        this.table.draw(program, size);
    }

    drawBeams(inputs, { width, height }) {
        const { table, about } = this;
        about.beams.forEach(({ block, evaluations }, level) => {
            const program = table.program("beams", level);
            program.set("beam", inputs.beams[level]);
            program.set("beam_evaluations", evaluations);
            program.set("around_middles", 0);
            const blocks = { width: Math.ceil(width / block), height: Math.ceil(height / block) };
            this.run("beams", this.beams[level], blocks, level);
            table.bind("beam_texture", this.beams[level].textures[0]);
            if (this.lists) this.copyLists(level, blocks);
        });
    }

    copyLists(level, { width, height }) {
        const { gl, table, about, lists } = this;
        const { lists: across, listRows } = about.beams[level];
        const size = { y: table.listRows[level], width: 16 * across * width,
            height: listRows * height };
        table.bind("beam_masks_texture", this.beams[level].layers, gl.TEXTURE_2D_ARRAY);
        table.bind("array0_lists", level > 0 ? lists[level - 1].textures[0] : null);
        for (const to of lists.slice(level)) this.run("beamCopies", to, size, level);
        table.bind("array0_lists", lists[level].textures[0]);
    }

    // Where rays have no way to march the shader is not run: such pixels are misses.
    drawFused(inputs, size) {
        const { gl, table, result } = this;
        gl.enable(gl.DEPTH_TEST);
        gl.depthFunc(gl.ALWAYS);
        gl.depthMask(true);
        this.run("mask", { bind: () => gl.bindFramebuffer(gl.FRAMEBUFFER, result.depthAlone) }, size);
        result.bind();
        gl.clearBufferfv(gl.COLOR, 0, inputs.background);
        gl.clearBufferuiv(gl.COLOR, 1, [0, 0, 0, 0]);
        gl.depthFunc(gl.LESS);
        gl.depthMask(false);
        table.program("fused").set("evaluations_per_pass", this.about.evaluations);
        this.run("fused", result, size);
        gl.disable(gl.DEPTH_TEST);
    }

    // Answers when the card has drawn the tile.
    async anyUnfinished(size) {
        const { gl, table, result } = this;
        table.bind("record", result.textures[1]);
        return this.countedBy("unfinished", this.counter, size)
            .finally(() => table.bind("record", null));
    }

    countedBy(role, target, size) {
        const { gl } = this;
        gl.colorMask(false, false, false, false);
        const passed = anyPassed(gl, () => this.run(role, target, size));
        gl.colorMask(true, true, true, true);
        return passed;
    }

    // `start`: what the rays start on, by which their states are kept apart.
    async march(role, evaluations, size, go, start = role) {
        const { table } = this;
        const program = table.program(role);
        program.set("evaluations_per_pass", evaluations);
        let [from, to] = this.statesOf(start);
        for (let isFirst = true; ; isFirst = false) {
            table.bindNumbered("state_texture", from);
            program.set("first_pass", isFirst ? 1 : 0);
            this.run(role, to, size);
            table.bindNumbered("state_texture", to);
            if (!(await this.countedBy("active", this.counter, size))) return to;
            go();
            [from, to] = [to, from];
        }
    }

    async drawInPasses(size, go) {
        const { table, about, result } = this;
        const rays = await this.march("march", about.evaluations, size, go);
        if (this.keepsSurfaces) await this.traceFurtherRays(size, go);
        table.bindNumbered("state_texture", rays);
        this.run("shade", result, size);
        table.unbindNumbered("state_texture", rays);
    }

    // What starts on the ends of the eye's rays.
    async traceFurtherRays(size, go) {
        const { table, about, ends } = this;
        table.unbindNumbered("surface_texture", ends);
        this.run("surface", ends, size);
        table.bindNumbered("surface_texture", ends);
        if (this.mirrorEnds) {
            table.unbindNumbered("mirrored_texture", this.mirrorEnds);
            await this.march("mirror", about.evaluations, size, go);
            this.run("mirrorSurface", this.mirrorEnds, size);
            table.bindNumbered("mirrored_texture", this.mirrorEnds);
        }
        if (table.has("shadow")) {
            const evaluations =
                Math.max(Math.floor(about.evaluations / about.shadowLights), about.degree + 1);
            if (this.mirrorEnds) {
                table.bindNumbered("surface_texture", this.mirrorEnds);
                const mirrored =
                    await this.march("shadow", evaluations, size, go, "mirrored shadow");
                table.bind("mirrored_shadow_texture", mirrored.textures[1]);
                table.bindNumbered("surface_texture", ends);
            }
            const ended = await this.march("shadow", evaluations, size, go);
            table.bind("shadow_texture", ended.textures[1]);
        }
    }

    // Rays by how they ended: miss, hit, step limit, NaN, zero gradient. Waits for the card.
    tally({ width, height }) {
        const { gl, result } = this;
        const words = this.keepsSurfaces ? 2 : 1;
        const record = new Uint32Array(width * height * words);
        result.bind();
        gl.readBuffer(gl.COLOR_ATTACHMENT1);
        gl.readPixels(0, 0, width, height, words === 2 ? gl.RG_INTEGER : gl.RED_INTEGER,
            gl.UNSIGNED_INT, record);
        gl.readBuffer(gl.COLOR_ATTACHMENT0);
        const counts = [0, 0, 0, 0, 0, 0, 0, 0];
        for (let k = 0; k < record.length; k += words) ++counts[record[k] & 7];
        return counts;
    }
}
