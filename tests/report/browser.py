"""A headless Chromium, steered over pipes by its DevTools protocol."""

import base64
import json
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

NAMES = ("chromium-headless-shell", "chromium", "chromium-browser",
         "google-chrome")

# Reports the widest element beyond the window, the text with the least
# contrast, and which elements lack what readers without eyes need.
CHECKS = """(() => {
  const parse = c => {
    const m = c.match(/[0-9.]+/g).map(Number);
    return m.length < 4 ? [...m.slice(0, 3), 1] : m;
  };
  const over = (top, below) => top.slice(0, 3).map(
    (x, i) => x * top[3] + below[i] * (1 - top[3])).concat(1);
  const light = c => {
    const [r, g, b] = c.slice(0, 3).map(x => {
      x /= 255;
      return x <= 0.03928 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const contrast = (a, b) => {
    const [x, y] = [light(a), light(b)].sort((p, q) => q - p);
    return (x + 0.05) / (y + 0.05);
  };
  const ground = e => {
    const layers = [];
    for (; e; e = e.parentElement) {
      const c = parse(getComputedStyle(e).backgroundColor);
      layers.push(c);
      if (c[3] === 1) break;
    }
    return layers.reverse().reduce((below, top) => over(top, below),
                                   [255, 255, 255, 1]);
  };
  let worst = {contrast: 99}, texts = 0, smallest = 99;
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const e = walker.currentNode.parentElement;
    if (!walker.currentNode.data.trim() || !e.getClientRects().length) continue;
    if (e.closest("title, style")) continue;
    const style = getComputedStyle(e);
    const colour = e.closest("svg") ? style.fill : style.color;
    const back = ground(e.closest("svg") ? e.closest("svg") : e);
    const found = contrast(over(parse(colour), back), back);
    const scale = e.closest("svg") ? e.closest("svg").getScreenCTM().a : 1;
    smallest = Math.min(smallest, parseFloat(style.fontSize) * scale);
    texts += 1;
    if (found < worst.contrast)
      worst = {contrast: found, text: walker.currentNode.data.trim()};
  }
  let lines = 99;
  for (const e of document.querySelectorAll(".chart .curve"))
    lines = Math.min(lines, contrast(parse(getComputedStyle(e).stroke),
                                     ground(e.closest("svg"))));
  const width = document.documentElement.clientWidth;
  const wide = [...document.body.querySelectorAll("*")].filter(
    e => !e.closest(".scroll > *, pre > *, svg *")
         && e.getBoundingClientRect().right > width + 0.5);
  return {
    scroll_width: document.documentElement.scrollWidth, width, worst, texts,
    smallest, lines,
    wide: wide.map(e => e.tagName + "." + e.className).slice(0, 5),
    background: getComputedStyle(document.body).backgroundColor,
    headings: [...document.querySelectorAll("h1, h2, h3")].map(
      e => e.tagName + " " + e.textContent),
    unnamed: [...document.querySelectorAll("img:not([alt]), svg:not([aria-label]):not([aria-hidden])")].length,
    tables_without_caption: [...document.querySelectorAll("table")].filter(
      e => !e.caption).length,
    broken_images: [...document.images].filter(
      e => e.complete && !e.naturalWidth).length,
    text: document.body.innerText,
  };
})()"""


def find_browser():
    """The path of a Chromium; fails without one, for the tests mean nothing
    then."""
    for name in NAMES:
        path = shutil.which(name)
        if path:
            return path
    raise AssertionError(
        "there is no Chromium to open reports in; ./taut test installs it, or "
        "type: apt install --no-install-recommends chromium-headless-shell")


class Browser:
    """One page; use it in a `with`."""

    def __init__(self):
        self.profile = tempfile.mkdtemp(prefix="taut browser ")
        read_commands, self.commands = os.pipe()
        self.answers, write_answers = os.pipe()

        def connect():
            # In two steps: 3 and 4 may be among those to be copied.
            reading, writing = os.dup(read_commands), os.dup(write_answers)
            os.dup2(reading, 100)
            os.dup2(writing, 101)
            os.dup2(100, 3)
            os.dup2(101, 4)

        self.process = subprocess.Popen(
            [find_browser(), "--headless", "--no-sandbox", "--disable-gpu",
             "--disable-dev-shm-usage", "--hide-scrollbars", "--no-first-run",
             "--host-resolver-rules=MAP * ~NOTFOUND",
             "--remote-debugging-pipe", f"--user-data-dir={self.profile}",
             "about:blank"],
            preexec_fn=connect, close_fds=False, stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(read_commands)
        os.close(write_answers)
        self.buffer, self.count = b"", 0
        self.session = None
        self.events = []
        targets = self.call("Target.getTargets")["targetInfos"]
        page = next(t for t in targets if t["type"] == "page")
        self.session = self.call("Target.attachToTarget",
                                 targetId=page["targetId"],
                                 flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        os.close(self.commands)
        os.close(self.answers)
        shutil.rmtree(self.profile, ignore_errors=True)

    def read_message(self):
        while b"\0" not in self.buffer:
            data = os.read(self.answers, 1 << 16)
            if not data:
                raise AssertionError("the browser has ended")
            self.buffer += data
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, **parameters):
        self.count += 1
        message = {"id": self.count, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.commands, data):]
        while True:
            answer = self.read_message()
            if answer.get("id") == self.count:
                if "error" in answer:
                    raise AssertionError(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def wait_for(self, method):
        while not any(e.get("method") == method for e in self.events):
            self.events.append(self.read_message())

    def open(self, file, width, scheme):
        """Shows a file at a width in px, `scheme` light or dark."""
        self.call("Emulation.setDeviceMetricsOverride", width=width,
                  height=900, deviceScaleFactor=1, mobile=width < 600)
        self.call("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": scheme}])
        self.events = []
        self.call("Page.navigate", url=Path(file).resolve().as_uri())
        self.wait_for("Page.loadEventFired")

    def check(self):
        """What CHECKS finds, and what the page said and asked for."""
        found = self.call("Runtime.evaluate", expression=CHECKS,
                          returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in found:
            raise AssertionError(found["exceptionDetails"])
        result = found["result"]["value"]
        result["errors"] = [
            e["params"] for e in self.events if e.get("method") in (
                "Runtime.exceptionThrown", "Log.entryAdded",
                "Runtime.consoleAPICalled")]
        urls = [e["params"]["request"]["url"] for e in self.events
                if e.get("method") == "Network.requestWillBeSent"]
        result["requests"] = [url for url in urls
                              if not url.startswith(("data:", "file:"))]
        result["files"] = [url for url in urls if url.startswith("file:")]
        return result

    def take_screenshot(self, file):
        shot = self.call("Page.captureScreenshot", captureBeyondViewport=True)
        Path(file).write_bytes(base64.b64decode(shot["data"]))
