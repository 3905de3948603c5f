// The picture on the screen: the sum of the pictures of a frame, shown as their mean.

class Screen {
    constructor(gl, table, tile) {
        this.gl = gl;
        this.table = table;
        this.tile = tile; // whose result is added
        this.sums = [];
        this.count = 0;
    }

    // The size of the pictures that are summed from now on.
    begin(width, height) {
        this.count = 0;
        if (this.next?.width === width && this.next?.height === height) return;
        if (this.next && this.next !== this.shown) this.next.free();
        this.next = new Target(this.gl, width, height, [this.gl.RGBA32F]).expectComplete();
    }

    // The first of them is copied.
    add(tile) {
        const { table } = this;
        const { result } = this.tile;
        if (this.count === 0) {
            this.next.copy(result, tile);
            return;
        }
        const program = table.program("add");
        table.bind("result", result.textures[0]);
        table.bind("sum", this.shown.textures[0]);
        program.set("tile_origin", [tile.x, tile.y]);
        this.next.bind();
        table.draw(program, tile);
        table.bind("result", null);
    }

    // All tiles of a picture were added.
    finishPicture() {
        const { width, height } = this.next;
        const free = this.shown;
        this.shown = this.next;
        this.count += 1;
        this.shownCount = this.count;
        const fits = free && free.width === width && free.height === height;
        if (free && !fits) free.free();
        this.next = fits ? free : new Target(this.gl, width, height, [this.gl.RGBA32F])
            .expectComplete();
    }

    show() {
        const { gl, table, shown } = this;
        if (!shown) return;
        const { width, height } = gl.canvas;
        const isSame = shown.width === width && shown.height === height;
        const program = table.program(isSame ? "show" : "enlarge");
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        table.bind("sum", shown.textures[0]);
        program.set("count", this.shownCount);
        program.set("picture_size", [shown.width, shown.height]);
        program.set("screen_size", [width, height]);
        table.draw(program, { width, height });
    }
}
