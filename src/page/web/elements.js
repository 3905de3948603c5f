// The elements of arrays on the card, and the grid of those that are found by place.

// A texture of 1024 texels a row: IM_BUFFER_AT of shaders/prelude.glsl.
class LongTexture {
    constructor(gl, internal, format, numbers, channels) {
        Object.assign(this, { gl, internal, format, numbers, channels, rows: 0 });
    }
    update(values) {
        const { gl } = this;
        const row = 1024 * this.channels;
        const rows = Math.max(1, Math.ceil(values.length / row));
        let texels = values;
        if (values.length !== rows * row) (texels = new values.constructor(rows * row)).set(values);
        if (rows > this.rows) {
            if (this.texture) gl.deleteTexture(this.texture);
            this.texture = textureOf(gl, this.internal, 1024, rows);
            this.rows = rows;
        }
        gl.activeTexture(gl.TEXTURE0 + editingUnit);
        gl.bindTexture(gl.TEXTURE_2D, this.texture);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 1024, rows, this.format, this.numbers, texels);
    }
}

// Holds the textures of one surface's elements and of its grid.
class ElementTextures {
    constructor(gl, table, data) {
        this.table = table;
        this.data = data;
        const { arrays, grid } = data.about;
        this.arrays = arrays.map(({ texture }) =>
            texture && new LongTexture(gl, gl.RGBA32F, gl.RGBA, gl.FLOAT, 4));
        if (!grid) return;
        this.cells = new LongTexture(gl, gl.RG32UI, gl.RG_INTEGER, gl.UNSIGNED_INT, 2);
        this.listed = new LongTexture(gl, gl.R32UI, gl.RED_INTEGER, gl.UNSIGNED_INT, 1);
    }

    // `elements` are those of each array, packed.
    upload(elements) {
        const { table, data } = this;
        data.about.arrays.forEach(({ name }, k) => {
            const texture = this.arrays[k];
            if (!texture) return table.setBlock(name, elements[k]);
            texture.update(elements[k]);
            table.bind(name, texture.texture);
        });
    }

    // Makes the lists and tells the block Parameters of them. Elements that a slider moves may be
    // anywhere.
    uploadGrid(frame, moment, isHeld, parameters) {
        const { table, data } = this;
        const { grid } = data.about;
        if (!grid) return;
        const key = isHeld ? `all ${frame}` : `${frame} ${moment}`;
        if (this.key !== key) {
            this.key = key;
            this.grid = isHeld ? gridOfAll(data.count(grid.array, frame, moment))
                : data.grid(frame, moment);
            this.cells.update(this.grid.cells);
            this.listed.update(this.grid.listed);
        }
        table.bind("cells_texture", this.cells.texture);
        table.bind("listed_texture", this.listed.texture);
        const { across, longest } = this.grid;
        parameters[grid.place + 7] = longest;
        if (!across) return;
        parameters[grid.place + 3] = grid.leastOfNone;
        parameters.set(across, grid.place + 8);
    }
}
