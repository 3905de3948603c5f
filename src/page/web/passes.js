// A surface's passes as programs: compiled, connected to their textures and blocks, ready to run, as
// src/render/pass_table.h has them.

// The textures of lists of elements, one for each level of beams: its lists' first row, behind those of
// the levels before, and the size. See shaders/march/copies.glsl.
function listTextures(beams, tile) {
    let height = 0;
    return beams.map(({ block, lists, listRows }) => {
        const firstRow = height, blocks = Math.ceil(tile / block);
        height += listRows * blocks;
        return { firstRow, width: 16 * lists * blocks, height };
    });
}

class PassTable {
    // `about`: a surface. `current.table` is the one whose textures and blocks are bound: each has
    // numbers of its own for them. `pageShaders`: what the page has of its own, of one table.
    constructor(gl, about, tile, current, pageShaders = { fragments: {} }) {
        this.gl = gl;
        this.current = current;
        this.passes = about.passes;
        this.elementBudget = about.elementBudget;
        this.units = new Map();
        this.bindings = new Map();
        this.programs = new Map(); // compiling or ready
        this.buffers = new Map();
        this.bound = new Map(); // textures
        this.effects = {};
        this.lists = listTextures(about.beams, tile);
        for (const { samplers, blocks } of this.passes) {
            for (const name of samplers) this.number(this.units, name);
            for (const name of blocks) this.number(this.bindings, name);
        }
        for (const name of ["result", "sum", "record"]) this.number(this.units, name);
        if (this.units.size > editingUnit)
            throw new NotPossible(`The scene's passes read ${this.units.size} textures.`);
        this.own = new Map();
        for (const [name, text] of Object.entries(pageShaders.fragments))
            this.own.set(name, { name, vertex: pageShaders.vertex, text, samplers: [], blocks: [] });
    }

    number(names, name) {
        if (!names.has(name)) names.set(name, names.size);
    }

    has(role) {
        return this.passes.some((pass) => pass.role === role);
    }

    find(role, level = 0) {
        return this.own.get(role) ??
            this.passes.find((pass) => pass.role === role && pass.level === level);
    }

    // Starts compiling; browsers do so beside the page.
    begin(pass) {
        const program = new Program(this.gl, pass.vertex, pass.text, pass.name);
        this.programs.set(pass, program);
        return program;
    }

    async ready(pass) {
        const program = this.programs.get(pass) ?? this.begin(pass);
        if (program.uniforms) return;
        while (!program.isReady()) await soon(5);
        program.finish(this.units, this.bindings);
        program.set("element_budget", this.elementBudget);
        program.set("list_rows", [0, 1, 2].map((k) => this.lists[k]?.firstRow ?? 0));
        const { width, height } = this.listsReadBy(pass) ?? { width: 1, height: 1 };
        program.set("list_texel", [1 / width, 1 / height]);
        for (const [name, value] of Object.entries(this.effects)) program.set(name, value);
    }

    // Beams go through the lists of the level before, rays through those of the last one.
    listsReadBy({ role, level }) {
        const ofBeams = role === "beams" || role === "beamCopies";
        return this.lists[ofBeams ? level - 1 : this.lists.length - 1];
    }

    // Compiles the passes that most pictures need, or all.
    async compile(exceptional = false) {
        const wanted = [...this.own.values(),
            ...this.passes.filter((pass) => exceptional || !pass.exceptional)];
        for (const pass of wanted) if (!this.programs.has(pass)) this.begin(pass);
        for (const pass of wanted) await this.ready(pass);
    }

    program(role, level = 0) {
        return this.programs.get(this.find(role, level));
    }

    setEffects(values) {
        Object.assign(this.effects, values);
        for (const program of this.programs.values()) {
            if (!program.uniforms) continue;
            for (const [name, value] of Object.entries(values)) program.set(name, value);
        }
    }

    setBlock(name, numbers) {
        const { gl } = this;
        if (!this.bindings.has(name)) return;
        if (!this.buffers.has(name)) this.buffers.set(name, gl.createBuffer());
        gl.bindBuffer(gl.UNIFORM_BUFFER, this.buffers.get(name));
        gl.bufferData(gl.UNIFORM_BUFFER, numbers, gl.DYNAMIC_DRAW);
        gl.bindBufferBase(gl.UNIFORM_BUFFER, this.bindings.get(name), this.buffers.get(name));
        if (this.current.table !== this) this.current.table = undefined;
    }

    bind(sampler, texture, kind = this.gl.TEXTURE_2D) {
        if (!this.units.has(sampler)) return;
        this.bound.set(sampler, { texture, kind });
        if (this.current.table === this) this.bindNow(sampler);
    }
    bindNow(sampler) {
        const { gl } = this;
        const { texture, kind } = this.bound.get(sampler) ?? { texture: null, kind: gl.TEXTURE_2D };
        gl.activeTexture(gl.TEXTURE0 + this.units.get(sampler));
        gl.bindTexture(kind, texture);
    }
    bindAll() {
        const { gl } = this;
        if (this.current.table === this) return;
        this.current.table = this;
        for (const sampler of this.units.keys()) this.bindNow(sampler);
        for (const [block, buffer] of this.buffers)
            gl.bindBufferBase(gl.UNIFORM_BUFFER, this.bindings.get(block), buffer);
    }
    bindNumbered(sampler, target) {
        target.textures.forEach((texture, k) => this.bind(`${sampler}_${k}`, texture));
    }
    // No texture may be read that is drawn into.
    unbindNumbered(sampler, target) {
        target.textures.forEach((_, k) => this.bind(`${sampler}_${k}`, null));
    }

    // Draws over these pixels of what is bound.
    draw(program, { x = 0, y = 0, width, height }) {
        const { gl } = this;
        this.bindAll();
        gl.useProgram(program.program);
        gl.viewport(x, y, width, height);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }
}
