// Draws one tile of a picture, as src/render/renderer.cpp does: beams, then march and picture in one
// draw of each surface, or rays in as many passes as they take and what is lit from their ends.

const nowhere = 1e30; // NO_END of shaders/surfaces/way.glsl
const mostPlaces = 64; // of tiles
const mostPatience = 100; // milliseconds

class TileDrawer {
    // `tables`: of each surface.
    constructor(gl, about, tables) {
        this.gl = gl;
        this.about = about;
        this.surfaces = tables.map((table, k) =>
            new SurfacePasses(gl, about.surfaces[k], table, about.tile));
        const [first] = this.surfaces;
        this.isFused = first.table.has("fused"); // as long as every ray ended in one draw
        // Shaders that keep the ends of rays count evaluations of further rays, too.
        this.countsFurther = first.table.has("surface") && !this.isFused;
        const formats = [gl.RGBA32F, this.countsFurther ? gl.RGBA32UI : gl.R32UI];
        this.result = first.newTarget(formats);
        this.drawsOver = this.isFused && tables.length > 1;
        if (this.drawsOver) this.prepareDrawingOver(formats);
        this.lasted = new Map(); // milliseconds of the last draw of a tile
        if (this.isFused) this.mask = new DepthMask(gl, [this.over ?? this.result]);
        else this.prepareForPasses();
    }

    prepareForPasses() {
        const { gl, surfaces } = this;
        const [first] = surfaces;
        if (surfaces.length > 1) this.several = new SeveralSurfaces(gl, surfaces);
        else if (first.table.has("surface"))
            this.further = new FurtherRays(gl, first, this.about.glassDepth);
    }

    // Pictures over each other also have the way to what is seen. A surface reads a copy of what those
    // before it drew.
    prepareDrawingOver(formats) {
        const { gl } = this;
        const [first] = this.surfaces;
        this.over = this.result.with(gl.R32F).expectComplete();
        this.before = first.newTarget([...formats, gl.R32F]);
    }

    // `inputs`: what painter.js made of a frame; `tile`: x, y, width, height in the picture. Leaves
    // the tile in `result`. `go` throws where the picture is given up.
    async draw(inputs, tile, go) {
        const size = { width: tile.width, height: tile.height };
        for (const surface of this.surfaces) surface.begin(tile);
        if (this.isFused) {
            this.drawFused(inputs, size);
            if (!(await this.anyUnfinished(tile))) return;
            // Some ray takes longer than a draw may; others of this scene will too.
            this.isFused = false;
            for (const { table } of this.surfaces) await table.compile(true);
            this.prepareForPasses();
        }
        if (this.several) return this.several.draw(inputs.beams, size, this.result, go);
        const [only] = this.surfaces;
        only.drawBeams(inputs.beams[0], size);
        const rays = await only.march("march", size, go);
        await this.further?.trace(size, go);
        only.table.bindNumbered("state_texture", rays);
        only.run("shade", this.result, size);
        only.table.unbindNumbered("state_texture", rays);
    }

    // Each surface draws over those before it where it is nearer. Where rays have no way to march the
    // shader is not run: such pixels are misses.
    drawFused(inputs, size) {
        const { gl, mask, before } = this;
        const into = this.over ?? this.result;
        into.bind();
        gl.clearBufferfv(gl.COLOR, 0, inputs.background);
        gl.clearBufferuiv(gl.COLOR, 1, [0, 0, 0, 0]);
        if (this.over) gl.clearBufferfv(gl.COLOR, 2, [nowhere, 0, 0, 0]);
        this.surfaces.forEach((surface, k) => {
            const { table, about } = surface;
            surface.drawBeams(inputs.beams[k], size);
            if (k > 0) {
                before.copy(into, size);
                table.bindNumbered("before_texture", before);
                table.bind("way_texture", before.textures[2]);
            }
            mask.set((alone) => surface.run("mask", alone, size));
            table.program("fused").set("evaluations_per_pass", about.evaluations);
            mask.apply(() => surface.run("fused", into, size));
        });
    }

    // Answers when the card has drawn the tile, which takes about as long as it took before.
    async anyUnfinished({ x, y, width, height }) {
        const [first] = this.surfaces;
        const place = [x, y, width, height].join(" "), begin = performance.now();
        const patience = Math.min(0.85 * (this.lasted.get(place) ?? 0), mostPatience);
        first.table.bind("record", this.result.textures[1]);
        try {
            return await first.countedBy("unfinished", { width, height }, undefined, patience);
        } finally {
            first.table.bind("record", null);
            this.note(place, performance.now() - begin, patience);
        }
    }

    // What was ready when it was first asked for may have taken much less.
    note(place, took, patience) {
        if (this.lasted.size > mostPlaces) this.lasted.clear();
        if (!document.hidden) this.lasted.set(place, took < 1.1 * patience + 1 ? 0.5 * took : took);
    }

    // Rays by how they ended: miss, hit, step limit, NaN, zero gradient. Waits for the card.
    tally({ width, height }) {
        const { gl, result } = this;
        const words = this.countsFurther ? 4 : 1;
        const record = new Uint32Array(width * height * words);
        result.bind();
        gl.readBuffer(gl.COLOR_ATTACHMENT1);
        gl.readPixels(0, 0, width, height, words === 4 ? gl.RGBA_INTEGER : gl.RED_INTEGER,
            gl.UNSIGNED_INT, record);
        gl.readBuffer(gl.COLOR_ATTACHMENT0);
        const counts = [0, 0, 0, 0, 0, 0, 0, 0];
        for (let k = 0; k < record.length; k += words) ++counts[record[k] & 7];
        return counts;
    }
}
