// What starts on the ends of the eye's rays on a single surface: src/render/secondary_rays.cpp.

class FurtherRays {
    constructor(gl, surface, glassDepth) {
        this.surface = surface;
        this.ends = surface.newFloats(3);
        if (surface.table.has("mirror")) this.mirrorEnds = surface.newFloats(3);
        if (surface.table.has("glass")) this.glass = new GlassPaths(gl, surface, glassDepth);
    }

    // Traces from the states of the eye's rays, which are bound.
    async trace(size, go) {
        const { surface, ends, mirrorEnds, glass } = this;
        const { table } = surface;
        table.unbindNumbered("surface_texture", ends);
        surface.run("surface", ends, size);
        table.bindNumbered("surface_texture", ends);
        if (mirrorEnds) {
            table.unbindNumbered("mirrored_texture", mirrorEnds);
            await surface.march("mirror", size, go);
            surface.run("mirrorSurface", mirrorEnds, size);
            table.bindNumbered("mirrored_texture", mirrorEnds);
        }
        if (glass) await glass.trace(size, go);
        if (!table.has("shadow")) return;
        const castFrom = async (from, start, seenAs) => {
            table.bindNumbered("surface_texture", from);
            const ended = await surface.march("shadow", size, go, start);
            table.bind(seenAs, ended.textures[1]);
        };
        if (mirrorEnds) await castFrom(mirrorEnds, "mirrored shadow", "mirrored_shadow_texture");
        if (glass?.ground)
            await castFrom(glass.drawGround(size), "shadow in glass", "glass_shadow_texture");
        await castFrom(ends, "shadow", "shadow_texture");
    }
}
