"""Debian's Chromium without a window, spoken to in its own protocol over two pipes."""
import base64
import contextlib
import json
import os
import pathlib
import subprocess
import tempfile
import time

OPTIONS = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
           "--disable-background-networking", "--disable-component-update", "--disable-sync",
           "--hide-scrollbars", "--remote-debugging-pipe"]
PATIENCE_S = 30.0


class Browser(contextlib.AbstractContextManager):
    """One process and one page; `requests` and `complaints` are those since the last `open`."""

    def __init__(self, chromium):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        to_it, self.to_it = os.pipe()
        self.from_it, from_it = os.pipe()
        # The protocol's pipes are descriptors 3 and 4 of the browser.
        self.process = subprocess.Popen(
            ["bash", "-c", f'exec "$@" 3<&{to_it} 4>&{from_it}', "bash", chromium, *OPTIONS,
             f"--user-data-dir={self.profile.name}", "about:blank"],
            pass_fds=(to_it, from_it), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_it)
        os.close(from_it)
        self.waiting, self.number, self.session = b"", 0, None
        self.requests, self.complaints = [], []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
        os.close(self.to_it)
        os.close(self.from_it)
        self.profile.cleanup()

    def call(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        text = json.dumps(message).encode() + b"\0"
        while text:
            text = text[os.write(self.to_it, text):]
        while True:
            answer = self.next_message()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self.note(answer)

    def next_message(self):
        while b"\0" not in self.waiting:
            read = os.read(self.from_it, 1 << 16)
            if not read:
                raise RuntimeError("the browser has ended")
            self.waiting += read
        text, self.waiting = self.waiting.split(b"\0", 1)
        return json.loads(text)

    def note(self, event):
        name, what = event.get("method"), event.get("params", {})
        if name == "Network.requestWillBeSent":
            self.requests.append(what["request"]["url"])
        elif name == "Runtime.exceptionThrown":
            self.complaints.append(what["exceptionDetails"]["text"])
        elif name == "Log.entryAdded" and what["entry"]["level"] == "error":
            self.complaints.append(what["entry"]["text"])

    def evaluate(self, expression):
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def open(self, file, width, dark=False, height=900):
        """Opens a file and waits until it has loaded and, if it is a report, drawn itself."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1.5,
                  mobile=False)
        self.call("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        self.call("Page.navigate", url="about:blank")
        self.requests, self.complaints = [], []
        self.call("Page.navigate", url=pathlib.Path(file).resolve().as_uri())
        self.wait_for('location.href !== "about:blank" && document.readyState === "complete" && '
                      'document.documentElement.dataset.state !== "loading"')

    def wait_for(self, expression):
        end = time.monotonic() + PATIENCE_S
        while not self.evaluate(expression):
            if time.monotonic() > end:
                raise RuntimeError(f"still not true after {PATIENCE_S} s: {expression}")
            time.sleep(0.05)

    def picture(self, element="document.documentElement", without=""):
        """PNG of an element, given by JavaScript that finds it; `without`: style for the picture alone."""
        box = self.evaluate(f"""(async () => {{
          const found = {element};
          if (!found) return null;
          document.head.append(Object.assign(document.createElement("style"), {{ textContent: {json.dumps(without)} }}));
          for (let e = found; e; e = e.parentElement) if (e.tagName === "DETAILS") e.open = true;
          found.scrollIntoView();
          await new Promise((resolve) => setTimeout(resolve, 400));
          const r = found.getBoundingClientRect();
          return {{x: r.x + scrollX, y: r.y + scrollY, width: r.width, height: r.height}};
        }})()""")
        if not box:
            raise RuntimeError(f"the page has nothing that is {element}")
        png = self.call("Page.captureScreenshot", clip={**box, "scale": 1}, captureBeyondViewport=True)
        return base64.b64decode(png["data"])
