// The passes of one surface at work in a tile: beams, and rays in as many draws as they take. As
// src/render/surface_passes.cpp and ray_marcher.cpp have it.

// A level of beams in squares of so many blocks, where shaders/march/beam_place.glsl has them.
function squaresOf({ width, height }, side, squaresApart) {
    const all = [];
    for (let y = 0; y < height; y += side) {
        for (let x = 0; x < width; x += side) {
            all.push({ x: (x / side) * squaresApart, y: (y / side) * squaresApart,
                width: Math.min(side, width - x), height: Math.min(side, height - y) });
        }
    }
    return all;
}

class SurfacePasses {
    // `about`: the surface; `side`: of a tile.
    constructor(gl, about, table, side) {
        this.gl = gl;
        this.about = about;
        this.table = table;
        this.side = side;
        this.beams = about.beams.map(({ block, square, masks }) => {
            const texels = about.squaresApart * Math.ceil(side / (block * square));
            return new Target(gl, texels, texels, [gl.RGBA32F]).withLayers(gl.RGBA32UI, masks)
                .expectComplete();
        });
        if (table.has("beamCopies")) this.lists = this.newLists();
        this.counter = this.newTarget([gl.R8]); // nothing is drawn into it, but fragments are counted
        this.states = new Map();
    }

    newTarget(formats) {
        return new Target(this.gl, this.side, this.side, formats).expectComplete();
    }
    // A target with `count` textures of four floats a pixel.
    newFloats(count) {
        return this.newTarget(Array(count).fill(this.gl.RGBA32F));
    }

    // A texture for each level of beams, which smaller ones read, or rays: its lists, and those of
    // the levels before.
    newLists() {
        return this.table.lists.map(({ width, height }) =>
            new Target(this.gl, width, height, [this.gl.RGBA32F]).expectComplete());
    }

    // `start`: what the rays start on, by which their states are kept apart.
    statesOf(start) {
        if (!this.states.has(start))
            this.states.set(start, [0, 1].map(() => this.newFloats(this.about.stateTextures)));
        return this.states.get(start);
    }

    // What runs from now on draws the tile whose lowest left pixel this is.
    begin({ x, y }) {
        this.at = [x, y];
    }

    run(role, target, size, level = 0) {
        const program = this.table.program(role, level);
        program.set("tile_origin", this.at);
        target.bind();
        this.table.draw(program, size);
    }

    // `ranges`: of the beams of each level.
    drawBeams(ranges, { width, height }) {
        const { table, about } = this;
        about.beams.forEach(({ block, evaluations }, level) => {
            const program = table.program("beams", level);
            program.set("beam", ranges[level]);
            program.set("beam_evaluations", evaluations);
            program.set("around_middles", 0);
            const blocks = { width: Math.ceil(width / block), height: Math.ceil(height / block) };
            for (const square of squaresOf(blocks, about.beams[level].square, about.squaresApart))
                this.run("beams", this.beams[level], square, level);
            table.bind("beam_texture", this.beams[level].textures[0]);
            if (this.lists) this.copyLists(level, blocks);
        });
    }

    copyLists(level, { width, height }) {
        const { gl, table, about, lists } = this;
        const { lists: across, listRows } = about.beams[level];
        const { firstRow } = table.lists[level];
        const size = { y: firstRow, width: 16 * across * width, height: listRows * height };
        table.bind("beam_masks_texture", this.beams[level].layers, gl.TEXTURE_2D_ARRAY);
        table.bind("array0_lists", level > 0 ? lists[level - 1].textures[0] : null);
        if (level > 0)
            lists[level].copy(lists[level - 1], { height: firstRow,
                width: Math.min(lists[level - 1].width, lists[level].width) });
        this.run("beamCopies", lists[level], size, level);
        table.bind("array0_lists", lists[level].textures[0]);
    }

    // Whether the draw of this role leaves any fragment, once the card has drawn it.
    countedBy(role, size, counter = this.counter, patience = 0) {
        const { gl } = this;
        gl.colorMask(false, false, false, false);
        const passed = anyPassed(gl, () => this.run(role, counter, size), patience);
        gl.colorMask(true, true, true, true);
        return passed;
    }

    // The evaluations of a ray in one draw. Shadow rays go to one light after the other.
    evaluationsOf(role) {
        const { evaluations, shadowLights } = this.about;
        return role === "shadow" ? Math.max(Math.floor(evaluations / shadowLights), 1)
            : evaluations;
    }

    // Gives the states of rays that ended. `go` throws where the picture is given up.
    async march(role, size, go, start = role, counter = this.counter) {
        const { table } = this;
        const program = table.program(role);
        program.set("evaluations_per_pass", this.evaluationsOf(role));
        let [from, to] = this.statesOf(start);
        for (let isFirst = true; ; isFirst = false) {
            table.bindNumbered("state_texture", from);
            program.set("first_pass", isFirst ? 1 : 0);
            this.run(role, to, size);
            table.bindNumbered("state_texture", to);
            if (!(await this.countedBy("active", size, counter))) return to;
            go();
            [from, to] = [to, from];
        }
    }
}
