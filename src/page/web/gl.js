// WebGL2 in the words of this page: programs, targets, and waiting for what was drawn.

class NotPossible extends Error {}

function contextOf(canvas) {
    const gl = canvas.getContext("webgl2",
        { antialias: false, depth: false, alpha: true, powerPreference: "high-performance" });
    if (!gl) throw new NotPossible("This browser has no WebGL2, which draws the surface.");
    if (gl.isContextLost()) return gl;
    if (!gl.getExtension("EXT_color_buffer_float")) {
        throw new NotPossible("This browser or its graphics card draws into no float textures " +
            "(EXT_color_buffer_float), which rays are kept in.");
    }
    gl.getExtension("KHR_parallel_shader_compile");
    gl.disable(gl.DITHER);
    return gl;
}

const knownSoftware = new WeakMap(); // by context, which is asked once

// Whether a processor draws, and no graphics card.
function drawsInSoftware(gl) {
    if (!knownSoftware.has(gl)) {
        const extension = gl.getExtension("WEBGL_debug_renderer_info");
        const name = gl.getParameter(extension ? extension.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
        knownSoftware.set(gl, /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name ?? ""));
    }
    return knownSoftware.get(gl);
}

// Steps of rays branch on graphics cards, which skip what no ray of a group needs:
// shaders/march/cubic.glsl.
function forHardware(text) {
    return text.replace("\n", "\n#define BRANCHES 1\n");
}

// A linked vertex and fragment shader. Names that it does not have are ignored.
class Program {
    constructor(gl, vertex, fragment, name) {
        this.gl = gl;
        this.name = name;
        this.program = gl.createProgram();
        if (!drawsInSoftware(gl)) fragment = forHardware(fragment);
        this.shaders = [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]].map(
            ([kind, text]) => {
                const shader = gl.createShader(kind);
                gl.shaderSource(shader, text);
                gl.compileShader(shader);
                gl.attachShader(this.program, shader);
                return shader;
            });
        gl.linkProgram(this.program);
    }

    isReady() {
        const extension = this.gl.getExtension("KHR_parallel_shader_compile");
        if (!extension) return true;
        return this.gl.getProgramParameter(this.program, extension.COMPLETION_STATUS_KHR);
    }

    // Finishes a program that is ready; throws where it did not compile.
    finish(units, bindings) {
        const { gl, program } = this;
        if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
            const told = this.shaders.map((shader) => gl.getShaderInfoLog(shader)).join("\n");
            throw new NotPossible(`This browser does not compile the shader '${this.name}': ` +
                `${told}\n${gl.getProgramInfoLog(program)}`);
        }
        this.uniforms = new Map();
        const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) ?? 0;
        gl.useProgram(program);
        for (let k = 0; k < count; ++k) {
            const { name, type } = gl.getActiveUniform(program, k);
            const location = gl.getUniformLocation(program, name);
            if (location) this.uniforms.set(name.replace("[0]", ""), { location, type });
            if (units.has(name)) gl.uniform1i(location, units.get(name));
        }
        for (const [block, binding] of bindings) {
            const index = gl.getUniformBlockIndex(program, block);
            if (index !== gl.INVALID_INDEX) gl.uniformBlockBinding(program, index, binding);
        }
        return this;
    }

    set(name, value) {
        const { gl } = this;
        const uniform = this.uniforms.get(name);
        if (!uniform) return;
        gl.useProgram(this.program);
        switch (uniform.type) {
        case gl.FLOAT: return gl.uniform1f(uniform.location, value);
        case gl.FLOAT_VEC2: return gl.uniform2fv(uniform.location, value);
        case gl.FLOAT_VEC3: return gl.uniform3fv(uniform.location, value);
        case gl.FLOAT_VEC4: return gl.uniform4fv(uniform.location, value);
        case gl.INT_VEC2: return gl.uniform2iv(uniform.location, value);
        case gl.INT_VEC3: return gl.uniform3iv(uniform.location, value);
        default: return gl.uniform1i(uniform.location, value);
        }
    }
}

// Makes a texture, or an array of textures where `layers` is given.
function textureOf(gl, internal, width, height, layers = 0) {
    const kind = layers ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D;
    const most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
    if (Math.max(width, height) > most && !gl.isContextLost()) {
        throw new NotPossible(`This browser or its graphics card has textures of at most ${most} x ` +
            `${most} pixels, and this scene needs one of ${width} x ${height}.`);
    }
    const texture = gl.createTexture();
    gl.activeTexture(gl.TEXTURE0 + editingUnit);
    gl.bindTexture(kind, texture);
    if (layers) gl.texStorage3D(kind, 1, internal, width, height, layers);
    else gl.texStorage2D(kind, 1, internal, width, height);
    for (const [name, value] of [[gl.TEXTURE_MIN_FILTER, gl.NEAREST],
        [gl.TEXTURE_MAG_FILTER, gl.NEAREST], [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
        [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]]) gl.texParameteri(kind, name, value);
    return texture;
}

const editingUnit = 31; // every WebGL2 has 32, and no pass reads this one

// Textures of one size that passes draw into.
class Target {
    // `formats` are those of textures to make, or textures that are there.
    constructor(gl, width, height, formats) {
        this.gl = gl;
        this.width = width;
        this.height = height;
        this.layerCount = 0;
        this.textures = formats.map((format) => format instanceof WebGLTexture ? format
            : textureOf(gl, format, width, height));
        this.framebuffer = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
        this.textures.forEach((texture, k) => gl.framebufferTexture2D(gl.FRAMEBUFFER,
            gl.COLOR_ATTACHMENT0 + k, gl.TEXTURE_2D, texture, 0));
        gl.drawBuffers(this.textures.map((_, k) => gl.COLOR_ATTACHMENT0 + k));
    }
    // A target of the same textures and one more.
    with(format) {
        return new Target(this.gl, this.width, this.height, [...this.textures, format]);
    }
    // Copies these pixels of another target with the same formats, from as many of its textures,
    // the first ones, as this one has.
    copy({ framebuffer }, { x = 0, y = 0, width, height }) {
        const { gl } = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.activeTexture(gl.TEXTURE0 + editingUnit);
        this.textures.forEach((texture, k) => {
            gl.readBuffer(gl.COLOR_ATTACHMENT0 + k);
            gl.bindTexture(gl.TEXTURE_2D, texture);
            gl.copyTexSubImage2D(gl.TEXTURE_2D, 0, x, y, 0, 0, width, height);
        });
        gl.readBuffer(gl.COLOR_ATTACHMENT0);
    }
    // Adds so many textures, which are the layers of one array.
    withLayers(format, count) {
        const { gl } = this;
        this.layerCount = count;
        if (count === 0) return this;
        const drawn = this.textures.length + count, most = gl.getParameter(gl.MAX_DRAW_BUFFERS);
        if (drawn > most) {
            throw new NotPossible(`This browser or its graphics card draws into ${most} textures at ` +
                `once, and this scene needs ${drawn}.`);
        }
        this.layers = textureOf(gl, format, this.width, this.height, count);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
        for (let k = 0; k < count; ++k) {
            gl.framebufferTextureLayer(gl.FRAMEBUFFER,
                gl.COLOR_ATTACHMENT0 + this.textures.length + k, this.layers, 0, k);
        }
        gl.drawBuffers(Array.from({ length: drawn }, (_, k) => gl.COLOR_ATTACHMENT0 + k));
        return this;
    }
    expectComplete() {
        const { gl } = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
        const status = gl.checkFramebufferStatus(gl.FRAMEBUFFER);
        if (status === gl.FRAMEBUFFER_COMPLETE || gl.isContextLost()) return this;
        const count = this.textures.length + this.layerCount;
        throw new NotPossible("This browser or its graphics card has too little memory for float " +
            `textures of ${this.width} x ${this.height} pixels, or does not draw into ${count} at once.`);
    }
    bind() {
        this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, this.framebuffer);
    }
    free() {
        const { gl } = this;
        [...this.textures, this.layers ?? null].forEach((texture) => gl.deleteTexture(texture));
        gl.deleteFramebuffer(this.framebuffer);
    }
}

// Depth that lets draws run for some pixels alone, shared by targets of one size. As
// src/gpu/depth_mask.h has it: pixels of depth 0 are left out.
class DepthMask {
    constructor(gl, targets) {
        this.gl = gl;
        const [{ width, height }] = targets, depth = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT16, width, height);
        this.alone = gl.createFramebuffer();
        for (const framebuffer of [...targets.map((target) => target.framebuffer), this.alone]) {
            gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
            gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
        }
        gl.drawBuffers([gl.NONE]); // of the last
    }
    // Draws depth.
    set(draw) {
        const { gl } = this;
        this.testing(gl.ALWAYS, true);
        draw({ bind: () => gl.bindFramebuffer(gl.FRAMEBUFFER, this.alone) });
        gl.disable(gl.DEPTH_TEST);
    }
    apply(draw) {
        this.testing(this.gl.LESS, false);
        draw();
        this.gl.disable(this.gl.DEPTH_TEST);
    }
    // Does the same for a draw that waits for the card.
    async applyTo(draw) {
        this.testing(this.gl.LESS, false);
        try {
            return await draw();
        } finally {
            this.gl.disable(this.gl.DEPTH_TEST);
        }
    }
    testing(passes, writes) {
        const { gl } = this;
        gl.enable(gl.DEPTH_TEST);
        gl.depthFunc(passes);
        gl.depthMask(writes);
    }
}

const soon = (milliseconds = 0) => new Promise((go) => setTimeout(go, milliseconds));

// Resolves after a millisecond. Timers that a timer's task sets wait at least 4, those of a
// message's task do not.
const atOnce = async () => {
    const { port1, port2 } = new MessageChannel();
    await new Promise((go) => {
        port1.onmessage = go;
        port2.postMessage(null);
    });
    port1.close();
    await soon(1);
};

// Whether any sample of a draw passed, once the card has drawn it; the page goes on meanwhile. It
// asks after `patience` milliseconds: asking takes time from what draws in software.
async function anyPassed(gl, draw, patience = 0) {
    const query = gl.createQuery();
    gl.beginQuery(gl.ANY_SAMPLES_PASSED, query);
    draw();
    gl.endQuery(gl.ANY_SAMPLES_PASSED);
    gl.flush();
    if (patience > 0) await soon(patience);
    do {
        await atOnce();
        if (gl.isContextLost()) throw new Stopped();
    } while (!gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE));
    const passed = gl.getQueryParameter(query, gl.QUERY_RESULT);
    gl.deleteQuery(query);
    return Boolean(passed);
}

// A picture that was given up.
class Stopped extends Error {}
