// Puts the page together.

function copyText(text) {
    const copied = navigator.clipboard?.writeText(text) ?? Promise.reject();
    return copied.catch(() => {
        // Frames and old browsers let no page write to the clipboard, but they let it copy a
        // selection.
        const area = made("textarea", { value: text });
        document.body.append(area);
        area.select();
        const done = document.execCommand("copy");
        area.remove();
        if (!done) throw new Error("copying is not allowed here");
    });
}

// Where the page is a frame's srcdoc it has no address of its own.
function setAddress(hash) {
    try {
        history.replaceState(null, "", hash);
    } catch {
        /* The link is still copied. */
    }
}

function toggleTheme() {
    const { dataset } = document.documentElement;
    const prefersDark = matchMedia("(prefers-color-scheme: dark)").matches;
    const isDark = dataset.theme ? dataset.theme === "dark" : prefersDark;
    dataset.theme = isDark ? "light" : "dark";
}

function commandsOf(look, painter, panel, hands) {
    const playback = (change) => () => {
        look.playback = change(look.playback, now());
        painter.change();
        panel().update();
    };
    const camera = (change) => () => {
        look.camera = change();
        painter.change();
    };
    const toggleAbout = () => element("about").classList.toggle("open");
    return {
        " ": playback(toggled),
        ArrowRight: playback((p, t) => stepped(p, 1, t)),
        ArrowLeft: playback((p, t) => stepped(p, -1, t)),
        Home: playback((p, t) => scrubbed(p, 1, t)),
        End: playback((p, t) => scrubbed(p, p.last, t)),
        "[": playback((p, t) => withSpeed(p, p.doublings - 1, t)),
        "]": playback((p, t) => withSpeed(p, p.doublings + 1, t)),
        l: () => {
            playback((p, t) => withLoop(p, !p.loop, t))();
            panel().say(look.playback.loop ? "plays over and over" : "plays once");
        },
        r: camera(() => undefined),
        f: camera(() => {
            const { clientWidth, clientHeight } = painter.canvas;
            const all = ballAboutAll(look.views(look.frame(now())));
            return fitted(hands().view(), clientWidth / clientHeight, all);
        }),
        c: () => {
            const hash = look.address();
            setAddress(hash);
            copyText(location.href.replace(/#.*/, "") + hash).then(
                () => panel().say("The link is copied."),
                (error) => panel().say(`No link: ${error.message}.`));
        },
        d: toggleTheme,
        p: toggleAbout,
        "?": () => {
            element("about").classList.add("open");
            element("keys").open = true;
        },
        Escape: () => element("about").classList.remove("open"),
    };
}

async function main() {
    const query = new URLSearchParams(location.search);
    if (query.get("ui") === "0") document.documentElement.dataset.ui = "0";
    const letters = element("data").textContent;
    const data = await SceneData.read(letters);
    const look = new Look(data);
    const isMoving = data.about.frames > 1;
    const isAsked = look.read(location.hash);
    if (!isAsked) look.playback = scrubbed(look.playback, data.about.poster, now());

    const canvas = element("picture");
    const fragments = {};
    for (const name of ["add", "show", "unfinished"]) fragments[name] = textOf(`${name}.frag`);
    fragments.enlarge = fragments.show.replace("\n", "\n#define ENLARGED\n");
    let panel, hands;
    const painter = new Painter(canvas, data, look,
        { vertex: textOf("screen.vert"), fragments },
        {
            shown: () => panel.update(),
            failed: (error) => panel.fail(error),
            waits: (text) => panel.waits(text),
        });
    const samples = Number(query.get("samples"));
    if (samples >= 1) painter.samplesWanted = Math.min(Math.floor(samples), data.about.pattern.length);
    painter.tallies = query.has("tally");
    const changed = () => {
        painter.change();
        panel.update();
    };
    const commands = commandsOf(look, painter, () => panel, () => hands);
    panel = new Panel(data, look, commands, changed);
    hands = new Hands(canvas, look, commands, changed);
    hands.fit = (width, height) => painter.fitOf(width, height);
    let size = String(painter.size());
    new ResizeObserver(() => {
        // It tells the size at first, too, when the picture is on its way.
        if (size === String(painter.size())) return;
        size = String(painter.size());
        painter.change(false);
    }).observe(canvas);
    window.addEventListener("hashchange", () => {
        look.read(location.hash);
        changed();
    });
    if (isMoving && !isAsked && query.get("play") !== "0" &&
        !matchMedia("(prefers-reduced-motion: reduce)").matches) {
        look.playback = { ...scrubbed(look.playback, 1, now()), playing: true };
    }
    panel.update();
    // For tests and for who looks behind the page.
    window.isomotion = { about: data.about, look, painter, commands };
    await painter.run();
}

const textOf = (id) => element(id).textContent.trimStart();

main().catch((error) => {
    showFailure(typeof DecompressionStream === "undefined"
        ? "This browser is too old: it has no DecompressionStream, which unpacks the scene."
        : `The page failed: ${error.message}`);
    throw error;
});
