// What is looked at, as the part of an address behind #: f=40&az=30&el=20&d=5&t=0,0,1&m=3.5, where the
// names of parameters stand for the values that sliders hold.

const shortNumber = (x) => String(Number(x.toPrecision(10)));
const ownNames = ["f", "az", "el", "d", "t", "h"];
const slideName = (name) => (ownNames.includes(name) ? `p.${name}` : name);

function addressOf({ frame, view, moved, values }) {
    const parts = new URLSearchParams();
    parts.set("f", frame);
    if (moved) {
        const { azimuth, elevation, distance } = anglesOf(view);
        parts.set("az", shortNumber(azimuth));
        parts.set("el", shortNumber(elevation));
        parts.set("d", shortNumber(distance));
        parts.set("t", view.target.map(shortNumber).join(","));
        if (view.parallel) parts.set("h", shortNumber(view.height));
    }
    for (const [name, value] of values) parts.set(slideName(name), shortNumber(value));
    return "#" + parts.toString().replaceAll("%2C", ",");
}

// What of it can be read; `view` is the scene's own at a frame.
function readAddress(hash, about, viewAt) {
    const parts = new URLSearchParams(hash.replace(/^#/, ""));
    const number = (name) => {
        const text = parts.get(name);
        const value = text === null || text.trim() === "" ? NaN : Number(text);
        return Number.isFinite(value) ? value : undefined;
    };
    const asked = number("f");
    const frame = asked === undefined ? undefined : clamp(Math.round(asked), 1, about.frames);
    const values = new Map();
    for (const { name } of about.sliders) {
        const value = number(slideName(name));
        if (value !== undefined) values.set(name, value);
    }
    const [azimuth, elevation, distance] = ["az", "el", "d"].map(number);
    if (azimuth === undefined || elevation === undefined || !(distance > 0))
        return { frame, values };
    const own = viewAt(frame ?? 1);
    const target = (parts.get("t") ?? "").split(",").map((part) => part.trim() === "" ? NaN : Number(part));
    const camera = usable(cameraAt({
        azimuth, distance, up: own.up,
        elevation: clamp(elevation, poleDistance - 90, 90 - poleDistance),
        target: target.length === 3 && target.every(Number.isFinite) ? target : own.target,
        height: number("h") > 0 ? number("h") : own.height,
    }), own);
    return { frame, values, camera };
}
