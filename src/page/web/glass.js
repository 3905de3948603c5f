// The light of pixels through glass, as src/render/glass_paths.cpp traces it: a path goes on at the
// end of each of its rays until it has left the surface, or its rays are used up.

class GlassPaths {
    // `depth`: rays after the eye's.
    constructor(gl, surface, depth) {
        this.surface = surface;
        this.depth = depth;
        this.kept = surface.newFloats(4); // all paths: shaders/glass/path.glsl
        this.goneOn = surface.newFloats(4); // those that a ray continued
        this.counter = surface.newTarget([gl.R8]);
        this.mask = new DepthMask(gl, [this.kept, this.goneOn, this.counter,
            ...surface.statesOf("glass")]); // where paths go on
        if (surface.table.has("glassGround")) this.ground = surface.newFloats(3);
    }

    anyGoesOn(size) {
        const { surface, mask, counter } = this;
        mask.set((alone) => surface.run("glassMask", alone, size));
        return mask.applyTo(() => surface.countedBy("glassActive", size, counter));
    }

    // Traces from where the eye's rays ended, which is bound. Leaves the light found bound.
    async trace(size, go) {
        const { surface, mask, kept, goneOn, counter } = this;
        const { table } = surface;
        table.unbindNumbered("glass_texture", kept);
        table.program("glassFirst").set("rays_left", this.depth);
        surface.run("glassFirst", kept, size);
        table.bindNumbered("glass_texture", kept);
        for (let left = this.depth - 1; left >= 0 && await this.anyGoesOn(size); --left) {
            // Active rays are counted under the same mask: states elsewhere are older.
            await mask.applyTo(() => surface.march("glass", size, go, "glass", counter));
            table.program("glassNext").set("rays_left", left);
            mask.apply(() => surface.run("glassNext", goneOn, size));
            table.bindNumbered("glass_texture", goneOn);
            mask.apply(() => surface.run("glassCopy", kept, size));
            table.bindNumbered("glass_texture", kept);
            go();
        }
    }

    // The points where paths met the ground, as ends of rays.
    drawGround(size) {
        this.surface.run("glassGround", this.ground, size);
        return this.ground;
    }
}
