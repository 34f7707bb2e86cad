"""A browser without a window, driven over the WebDriver protocol with the standard library alone."""

from __future__ import annotations

import base64
import json
import shutil
import socket
import subprocess
import tempfile
import time
import urllib.error
import urllib.request
from pathlib import Path

_BROWSERS = ["chromium", "chromium-browser", "google-chrome"]
_DRIVERS = ["chromedriver", "chromium.chromedriver"]


def find_browser() -> tuple[str, str] | None:
    """The browser and its driver, or None where one of them is not installed."""
    browser = next(filter(None, map(shutil.which, _BROWSERS)), None)
    driver = next(filter(None, map(shutil.which, _DRIVERS)), None)
    return (browser, driver) if browser and driver else None


def _free_port() -> int:
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Browser:
    """One window; use it in a `with` statement."""

    def __init__(self, browser: str, driver: str):
        self._folder = tempfile.TemporaryDirectory()
        self._port = _free_port()
        self._driver = subprocess.Popen(
            [driver, f"--port={self._port}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        self._session = ""
        self._emulated: dict[str, dict] = {}
        try:
            self._wait_until_ready()
            self._session = self._start(browser)
        except BaseException:
            self._stop_driver()
            raise

    def __enter__(self) -> "Browser":
        return self

    def __exit__(self, *_: object) -> None:
        try:
            self._send("DELETE", "")
        finally:
            self._stop_driver()

    def _stop_driver(self) -> None:
        self._driver.terminate()
        self._driver.wait()
        self._folder.cleanup()

    def _request(self, method: str, path: str, body: dict | None) -> object:
        request = urllib.request.Request(
            f"http://127.0.0.1:{self._port}{path}",
            method=method,
            data=None if body is None else json.dumps(body).encode(),
            headers={"Content-Type": "application/json"},
        )
        try:
            with urllib.request.build_opener(urllib.request.ProxyHandler({})).open(
                request, timeout=120
            ) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as problem:
            raise RuntimeError(json.load(problem)["value"]["message"]) from None

    def _send(self, method: str, path: str, body: dict | None = None) -> object:
        return self._request(method, f"/session/{self._session}{path}", body)

    def _wait_until_ready(self) -> None:
        for _ in range(300):
            try:
                if self._request("GET", "/status", None)["ready"]:
                    return
            except OSError:
                pass
            time.sleep(0.1)
        raise RuntimeError("the driver of the browser does not answer")

    def _start(self, browser: str) -> str:
        # A sandbox needs rights that a container does not give; what is opened is our own page.
        arguments = [
            "--headless=new",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-dev-shm-usage",
            "--hide-scrollbars",
            f"--user-data-dir={self._folder.name}",
        ]
        answer = self._request(
            "POST",
            "/session",
            {
                "capabilities": {
                    "alwaysMatch": {
                        "goog:chromeOptions": {"binary": browser, "args": arguments},
                        "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"},
                        "unhandledPromptBehavior": "ignore",
                        "timeouts": {"script": 120000},  # a checker of a long page takes its time [ms]
                    }
                }
            },
        )
        return answer["sessionId"]

    def tell(self, command: str, **parameters: object) -> dict:
        """A command of the DevTools protocol."""
        return self._send("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def _emulate(self, command: str, **parameters: object) -> None:
        """Whatever is emulated anew is laid out anew, even if nothing changes."""
        if self._emulated.get(command) != parameters:
            self.tell(command, **parameters)
            self._emulated[command] = parameters

    def set_width(self, width: int, height: int = 900) -> None:
        self._emulate(
            "Emulation.setDeviceMetricsOverride",
            width=width,
            height=height,
            deviceScaleFactor=1,
            mobile=False,
        )

    def set_media(self, media: str = "screen", **features: str) -> None:
        """`prefers_color_scheme="dark"` and the like."""
        self._emulate(
            "Emulation.setEmulatedMedia",
            media=media,
            features=[
                {"name": name.replace("_", "-"), "value": value} for name, value in features.items()
            ],
        )

    def open(self, path: Path, query: str = "") -> None:
        self._send("POST", "/url", {"url": path.as_uri() + query})

    def ask(self, script: str, *arguments: object) -> object:
        """What the body of a function answers."""
        return self._send("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def title(self) -> str:
        return self._send("GET", "/title")

    def messages(self) -> list[str]:
        """What the console has been told since this was asked last."""
        return [one["message"] for one in self._send("POST", "/se/log", {"type": "browser"})]

    def requests(self) -> list[str]:
        """The addresses that were asked for since this was asked last."""
        addresses = []
        for entry in self._send("POST", "/se/log", {"type": "performance"}):
            event = json.loads(entry["message"])["message"]
            if event["method"] == "Network.requestWillBeSent":
                addresses.append(event["params"]["request"]["url"])
        return addresses

    def alert_text(self) -> str | None:
        """The text of a dialogue that stands open."""
        try:
            return self._send("GET", "/alert/text")
        except RuntimeError:
            return None

    def picture(self, path: Path, full: bool = True) -> None:
        """Writes what is seen as PNG, by default down to the end of the page."""
        shot = self.tell("Page.captureScreenshot", captureBeyondViewport=full, **self._clip(full))
        path.write_bytes(base64.b64decode(shot["data"]))

    def _clip(self, full: bool) -> dict:
        if not full:
            return {}
        width, height = self.ask(
            "const d = document.documentElement; return [d.clientWidth, d.scrollHeight];"
        )
        return {"clip": {"x": 0, "y": 0, "width": width, "height": height, "scale": 1}}
