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

// The rows of a table of 32-bit words, packed as src/page/value_table.h says.
function unpackedTable(reader, width, rows) {
    const moves = reader.take(width);
    const words = new Uint32Array(width * rows);
    for (let column = 0; column < width; ++column) words[column] = reader.word();
    const moving = [];
    for (let column = 0; column < width; ++column) {
        if (moves[column]) moving.push(column);
        else for (let row = 1; row < rows; ++row) words[row * width + column] = words[column];
    }
    const count = moving.length * (rows - 1);
    const planes = [3, 2, 1, 0].map(() => reader.take(count));
    let k = 0;
    for (const column of moving) {
        for (let row = 1; row < rows; ++row, ++k) {
            const difference =
                (planes[0][k] << 24) | (planes[1][k] << 16) | (planes[2][k] << 8) | planes[3][k];
            words[row * width + column] = words[(row - 1) * width + column] + difference;
        }
    }
    return words;
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

class SceneData {
    static async read(letters) {
        const reader = new Reader(await inflated(letters));
        const length = reader.word();
        const about = JSON.parse(new TextDecoder().decode(reader.take(length)));
        const tables = new Map();
        for (const { name, width } of about.tables)
            tables.set(name, { width, words: unpackedTable(reader, width, about.frames) });
        return new SceneData(about, tables, reader);
    }

    constructor(about, tables, reader) {
        this.about = about;
        this.tables = tables;
        for (const pass of about.passes) {
            pass.text = this.text(pass.text);
            pass.vertex = this.text(pass.vertex);
        }
        // Halves begin at whole words of two bytes.
        const halves = ([width, height]) =>
            new Uint16Array(reader.take(width * height * 6).slice().buffer);
        if (about.environment) this.environment = halves(about.environment);
        if (about.environmentLevels) this.environmentLevels = halves(about.environmentLevels);
    }

    text(numbers) {
        return numbers.map((number) => this.about.lines[number]).join("\n") + "\n";
    }

    row(table, frame) {
        const { width, words } = this.tables.get(table);
        return words.slice((frame - 1) * width, frame * width);
    }
    floats(table, frame) {
        return new Float32Array(this.row(table, frame).buffer);
    }

    // What rays depend on, as the scene has it.
    view(frame) {
        const view = named(new Float64Array(this.row("view", frame).buffer), this.about.view);
        view.parallel = this.about.parallel;
        view.box = this.about.box;
        return view;
    }
    effects(frame) {
        const { about } = this;
        return about.effects.length ? named(this.floats("effects", frame), about.effects) : {};
    }
    // Elements of an array at a frame: behind the parameters, whole numbers.
    count(array, frame) {
        return this.row("parameters", frame)[4 * this.about.parameterVectors + array];
    }
}
