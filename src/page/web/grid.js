// Grids of elements: src/page/packed_grid.h says how they are kept, src/elements/element_grid.h what
// their cells and lists are.

const countBits = 20, mostFree = 2 ** 12 - 1;

// The distance of each cell, x fastest, to the nearest cell where `is` is 0, as a king walks on a
// chessboard. Two passes over all cells find it. Places outside of the grid count as 1.
function chessboardDistances([nx, ny, nz], is) {
    const steps = new Uint16Array(is.length);
    for (let k = 0; k < is.length; ++k) steps[k] = is[k] ? mostFree : 0;
    const at = (x, y, z) => x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz
        ? steps[(z * ny + y) * nx + x] : mostFree;
    // Lowers a cell's step by the 13 neighbours that come before, or after.
    const lower = (k, x, y, z, sign) => {
        if (steps[k] <= 1) return;
        let least = at(x - sign, y, z);
        for (let dx = -1; dx <= 1; ++dx) {
            least = Math.min(least, at(x + dx, y - sign, z));
            for (let dy = -1; dy <= 1; ++dy) least = Math.min(least, at(x + dx, y + dy, z - sign));
        }
        steps[k] = Math.min(steps[k], least + 1);
    };
    let k = 0;
    for (let z = 0; z < nz; ++z)
        for (let y = 0; y < ny; ++y) for (let x = 0; x < nx; ++x) lower(k++, x, y, z, 1);
    for (let z = nz; z-- > 0;)
        for (let y = ny; y-- > 0;) for (let x = nx; x-- > 0;) lower(--k, x, y, z, -1);
    return steps;
}

// Calls at(element, cell) for all elements in ascending order.
function forEachPlace(reader, [nx, ny], elements, at) {
    for (let element = 0; element < elements; ++element) {
        const [ax, ay, az, bx, by, bz] = reader.take(6);
        const size = Math.max(bx - ax + 1, 0) * Math.max(by - ay + 1, 0) * Math.max(bz - az + 1, 0);
        const bits = reader.take((size + 7) >> 3);
        let k = 0;
        for (let z = az; z <= bz; ++z)
            for (let y = ay; y <= by; ++y)
                for (let x = ax; x <= bx; ++x, ++k)
                    if ((bits[k >> 3] >> (k & 7)) & 1) at(element, (z * ny + y) * nx + x);
    }
}

// The grid as the shaders read it: two words a cell, the elements of all lists, and how many the
// longest has.
function unpackedGrid(bytes, across, elements) {
    const count = across[0] * across[1] * across[2];
    const reader = new Reader(bytes);
    const bits = reader.take((count + 7) >> 3);
    const isFree = Uint8Array.from({ length: count }, (_, k) => (bits[k >> 3] >> (k & 7)) & 1);
    const places = reader.at;
    const counts = new Uint32Array(count);
    forEachPlace(reader, across, elements, (_, cell) => ++counts[cell]);
    const next = new Uint32Array(count);
    let entries = 0, longest = 0;
    counts.forEach((n, cell) => {
        next[cell] = entries;
        entries += n;
        longest = Math.max(longest, n);
    });
    const free = chessboardDistances(across, isFree);
    const empty = chessboardDistances(across, counts.map((n) => Number(n === 0)));
    const cells = new Uint32Array(2 * count);
    for (let cell = 0; cell < count; ++cell) {
        cells[2 * cell] = counts[cell] | (free[cell] << countBits);
        cells[2 * cell + 1] = counts[cell] ? next[cell] : empty[cell] - 1;
    }
    const listed = new Uint32Array(entries);
    reader.at = places;
    forEachPlace(reader, across, elements, (element, cell) => (listed[next[cell]++] = element));
    return { cells, listed, longest };
}

// One cell with all elements, which holds whatever their values are.
function gridOfAll(elements) {
    return { across: [1, 1, 1], cells: new Uint32Array([elements, 0]),
        listed: Uint32Array.from({ length: elements }, (_, k) => k), longest: elements };
}
