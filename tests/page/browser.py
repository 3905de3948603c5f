"""A headless chromium, driven by the DevTools protocol."""
import base64
import json
import os
import shutil
import subprocess
import tempfile
import time

SKIPPED = 77  # what ctest takes for a test that could not run here


def missing():
    """Why there is no browser to drive here, or None."""
    try:
        import websocket  # noqa: F401
    except ImportError:
        return "python3-websocket is not installed"
    if not executable():
        return "chromium is not installed"
    return None


def executable():
    return os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("chromium-browser")


# What draws: chromium's own software renderer, or the EGL of the system, which `isomotion render` has.
SWIFTSHADER = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
SYSTEM_GL = ("--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist")


class Browser:
    """Starts chromium, with SwiftShader unless told otherwise; a context manager."""

    def __init__(self, *flags, gl=SWIFTSHADER):
        self.folder = tempfile.mkdtemp(prefix="isomotion-chromium-")
        self.process = subprocess.Popen(
            [executable(), "--headless=new", "--no-sandbox", *gl,
             "--force-color-profile=srgb", "--hide-scrollbars",
             "--disable-dev-shm-usage", "--mute-audio", "--no-first-run",
             "--remote-debugging-port=0", "--remote-allow-origins=*",
             f"--user-data-dir={self.folder}", *flags, "about:blank"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.port = self._port()

    def _port(self, seconds=60):
        file = os.path.join(self.folder, "DevToolsActivePort")
        end = time.time() + seconds
        while time.time() < end:
            if os.path.exists(file):
                with open(file) as lines:
                    first = lines.readline().strip()
                if first:
                    return int(first)
            if self.process.poll() is not None:
                break
            time.sleep(0.05)
        raise RuntimeError("chromium does not start")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

    def page(self, width=256, height=256, dark=False, touch=False, scale=1):
        return Page(self, width, height, dark, touch, scale)


class Page:
    """A tab. What its console says gathers in `console`, errors and warnings alone."""

    def __init__(self, browser, width, height, dark, touch, scale):
        import urllib.request
        import websocket
        request = urllib.request.Request(
            f"http://127.0.0.1:{browser.port}/json/new?about:blank", method="PUT")
        with urllib.request.urlopen(request) as answer:
            target = json.load(answer)
        self.socket = websocket.create_connection(target["webSocketDebuggerUrl"], timeout=120)
        self.number = 0
        self.console = []
        self.heard = {}  # messages that a test listens for, by method
        for domain in ("Page", "Runtime", "Log"):
            self.call(f"{domain}.enable")
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=scale, mobile=touch)
        if touch:
            self.call("Emulation.setTouchEmulationEnabled", enabled=True)
        self.call("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def call(self, method, **parameters):
        self.number += 1
        number = self.number
        self.socket.send(json.dumps({"id": number, "method": method, "params": parameters}))
        while True:
            message = json.loads(self.socket.recv())
            if message.get("id") == number:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']['message']}")
                return message["result"]
            self._note(message)

    def listen(self, method, enabling):
        """What the browser tells of it from now on gathers in the list."""
        told = self.heard.setdefault(method, [])
        self.call(enabling)
        return told

    def _note(self, message):
        kind, told = message.get("method"), message.get("params", {})
        if kind in self.heard:
            self.heard[kind].append(told)
        if kind == "Runtime.exceptionThrown":
            details = told["exceptionDetails"]
            self.console.append(details.get("exception", {}).get("description", details["text"]))
        elif kind == "Runtime.consoleAPICalled" and told["type"] in ("error", "warning", "assert"):
            self.console.append(" ".join(str(a.get("value", a)) for a in told["args"]))
        elif kind == "Log.entryAdded" and told["entry"]["level"] in ("error", "warning"):
            self.console.append(told["entry"]["text"])

    def evaluate(self, expression):
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True,
                           awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"].get("exception", {}).get("description"))
        return answer["result"].get("value")

    def until(self, expression, seconds=120):
        """Waits until it holds; tells what the page says where it does not."""
        end = time.time() + seconds
        while time.time() < end:
            if self.evaluate(expression):
                return
            time.sleep(0.05)
        said = self.evaluate("document.getElementById('failure')?.textContent")
        raise RuntimeError(f"not within {seconds} s: {expression}; {said}; {self.console}")

    def open(self, file, query="", fragment=""):
        address = "file://" + os.path.abspath(file)
        self.call("Page.navigate", url="about:blank")
        self.call("Page.navigate", url=f"{address}{query}{fragment}")
        self.until("Boolean(window.isomotion) || !(document.getElementById('failure')?.hidden ?? true)")

    def until_at_rest(self, seconds=300):
        self.until("isomotion.painter.isAtRest || !document.getElementById('failure').hidden",
                   seconds)

    def screenshot(self):
        return base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def drag(self, start, end, steps=4):
        self.mouse("mousePressed", *start, button="left", clickCount=1)
        for k in range(1, steps + 1):
            self.mouse("mouseMoved", *[a + (b - a) * k / steps for a, b in zip(start, end)],
                       button="left", buttons=1)
        self.mouse("mouseReleased", *end, button="left", clickCount=1)

    def press(self, key, code=None):
        text = {"text": key} if len(key) == 1 else {}
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, code=code or key, **text)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key, code=code or key)

    def to_front(self):
        """Other tabs are hidden then."""
        self.call("Page.bringToFront")

    def close(self):
        self.call("Page.close")
        self.socket.close()
