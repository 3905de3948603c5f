// The page's data: what the scene is and the values of each of its frames.

async function inflated(letters) {
    const bytes = Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Reads bytes from the first one on.
class Reader {
    constructor(bytes) {
        this.bytes = bytes;
        this.at = 0;
    }
    take(count) {
        const taken = this.bytes.subarray(this.at, this.at + count);
        this.at += count;
        return taken;
    }
    word() {
        const [a, b, c, d] = this.take(4);
        return (a | (b << 8) | (c << 16) | (d << 24)) >>> 0;
    }
}

// A table of 32-bit words, packed as src/page/value_table.h says: its first row, and all rows of the
// columns that move, side by side.
class Table {
    constructor(reader, width, rows) {
        const moves = reader.take(width);
        this.first = Uint32Array.from({ length: width }, () => reader.word());
        this.moving = [...moves.keys()].filter((column) => moves[column]);
        const across = this.moving.length, count = across * (rows - 1);
        const planes = [3, 2, 1, 0].map(() => reader.take(count));
        this.words = new Uint32Array(across * rows);
        let k = 0;
        this.moving.forEach((column, place) => {
            this.words[place] = this.first[column];
            for (let row = 1; row < rows; ++row, ++k) {
                const difference = (planes[0][k] << 24) | (planes[1][k] << 16) |
                    (planes[2][k] << 8) | planes[3][k];
                this.words[row * across + place] =
                    this.words[(row - 1) * across + place] + difference;
            }
        });
    }
    row(at) {
        const words = this.first.slice();
        const begin = at * this.moving.length;
        this.moving.forEach((column, place) => (words[column] = this.words[begin + place]));
        return words;
    }
}

// Names for the numbers of a row, in order: [name, count].
function named(numbers, places) {
    const all = {};
    let at = 0;
    for (const [name, count] of places) {
        all[name] = count === 1 ? numbers[at] : Array.from(numbers.subarray(at, at + count));
        at += count;
    }
    return all;
}

// The time in seconds, as src/animation/timeline.h has it.
const secondsOf = ({ fps, moments }, frame, moment) =>
    ((frame - 1) * fps[1]) / fps[0] + (moments[moment] * fps[1]) / fps[0];

// The columns and words that expressions may miss, by rows: src/page/computed_elements.h.
function exceptionsOf(reader) {
    const rows = new Map();
    for (let left = reader.word(); left > 0; --left) {
        const row = reader.word();
        if (!rows.has(row)) rows.set(row, []);
        rows.get(row).push([reader.word(), reader.word()]);
    }
    return rows;
}

// The values of one surface. Frames have moments, of which the first one, 0, is the frame's time.
class SurfaceData {
    // `about`: the surface, of this scene.
    constructor(reader, about, scene) {
        this.about = about;
        this.scene = scene;
        const rows = scene.frames * scene.moments.length;
        this.tables = new Map();
        for (const { name, width } of about.tables)
            this.tables.set(name, new Table(reader, width, rows));
        this.exceptions = about.arrays.map(({ computed }) => computed && exceptionsOf(reader));
        if (about.grid) this.grids = Array.from({ length: rows }, () => reader.take(reader.word()));
    }

    rowOf(frame, moment) {
        return (frame - 1) * this.scene.moments.length + moment;
    }
    row(table, frame, moment) {
        return this.tables.get(table).row(this.rowOf(frame, moment));
    }
    floats(table, frame, moment) {
        return new Float32Array(this.row(table, frame, moment).buffer);
    }
    // An array's elements, as the shaders read them. Expressions compute some of the fields.
    elements(array, frame, moment) {
        const texels = this.floats(`array${array}`, frame, moment);
        const { rules, arrays } = this.about, { computed } = arrays[array];
        if (!computed) return texels;
        fillElements(texels, rules.arrays[array], computed, this.count(array, frame, moment),
            rules.seed, secondsOf(this.scene, frame, moment));
        const words = new Uint32Array(texels.buffer);
        for (const [column, word] of this.exceptions[array].get(this.rowOf(frame, moment)) ?? [])
            words[column] = word;
        return texels;
    }
    view(frame, moment) {
        const numbers = new Float64Array(this.row("view", frame, moment).buffer);
        return { ...named(numbers, this.about.view), box: this.about.box };
    }
    effects(frame, moment) {
        const { about } = this;
        return about.effects.length
            ? named(this.floats("effects", frame, moment), about.effects) : {};
    }
    // Elements of an array at a frame: behind the parameters, whole numbers.
    count(array, frame, moment) {
        return this.row("parameters", frame, moment)[4 * this.about.parameterVectors + array];
    }
    grid(frame, moment) {
        const { array, place } = this.about.grid;
        const across = this.floats("parameters", frame, moment).subarray(place + 8, place + 11);
        return unpackedGrid(this.grids[this.rowOf(frame, moment)], [...across],
            this.count(array, frame, moment));
    }
}

class SceneData {
    static async read(letters) {
        const reader = new Reader(await inflated(letters));
        const length = reader.word();
        const about = JSON.parse(new TextDecoder().decode(reader.take(length)));
        const data = new SceneData(reader, about);
        // Halves begin at whole words of two bytes.
        const halves = ([width, height]) =>
            new Uint16Array(reader.take(width * height * 6).slice().buffer);
        if (about.environment) data.environment = halves(about.environment);
        if (about.environmentLevels) data.environmentLevels = halves(about.environmentLevels);
        return data;
    }

    constructor(reader, about) {
        this.about = about;
        const text = (numbers) => numbers.map((number) => about.lines[number]).join("\n") + "\n";
        for (const { passes } of about.surfaces) {
            for (const pass of passes) {
                pass.text = text(pass.text);
                pass.vertex = text(pass.vertex);
            }
        }
        this.surfaces = about.surfaces.map((surface) =>
            new SurfaceData(reader, surface, about));
    }

    seconds(frame, moment) {
        return secondsOf(this.about, frame, moment);
    }

    // What rays to a surface depend on, as the scene has it: the first one has the camera of all.
    view(frame, moment, surface = 0) {
        const [first] = this.surfaces;
        return { ...first.view(frame, moment), ...this.surfaces[surface].view(frame, moment),
            parallel: this.about.parallel };
    }
}
