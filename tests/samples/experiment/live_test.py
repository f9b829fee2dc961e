"""Tests the live page in headless Chromium, during a session of a simulated participant in real time: its display and its keys.

    live_test.py PROGRAM MANIFEST_OF_THE_MOCK_RUNTIME SCENE PICTURE
"""
import base64
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

PROGRAM, MANIFEST, SCENE, PICTURE = sys.argv[1:]
STUDY = {"title": "live", "participants": 2, "set_up": "none", "practice_trials": 0, "repeats": 10, "breaks": {"minutes": 0},
         "conditions": [{"name": "secret people", "controller": "people"}, {"name": "secret none", "controller": "none"}],
         "pairs": [{"name": "left", "virtual_deg": 6, "real_deg": 0}, {"name": "right", "virtual_deg": -6, "real_deg": 0}]}


class Browser:
    """Controls Chromium through a pipe, by the DevTools protocol."""

    def __init__(self, folder):
        ask, self.asks = os.pipe()
        self.answers, answer = os.pipe()
        # No graphics card is used; root needs --no-sandbox.
        self.process = subprocess.Popen(
            ["bash", "-c", 'exec chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --remote-debugging-pipe '
             f'--window-size=1280,900 --user-data-dir={folder}/chromium 3<&{ask} 4>&{answer}'], pass_fds=(ask, answer), stderr=subprocess.DEVNULL)
        os.close(ask), os.close(answer)
        self.number, self.heard = 0, b""

    def call(self, method, session=None, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters, **({"sessionId": session} if session else {})}
        os.write(self.asks, json.dumps(message).encode() + b"\0")
        while True:
            while b"\0" not in self.heard:
                self.heard += os.read(self.answers, 1 << 16)
            text, self.heard = self.heard.split(b"\0", 1)
            if (answer := json.loads(text)).get("id") == self.number:
                return answer["result"]

    def open(self, address):
        target = self.call("Target.createTarget", url=address)["targetId"]
        return self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]

    def see(self, page, expression):
        return self.call("Runtime.evaluate", page, expression=expression, returnByValue=True)["result"].get("value")

    def await_text(self, see, pattern):
        for _ in range(300):
            if re.search(pattern, str(text := see())):
                return
            time.sleep(0.1)
        raise AssertionError(f"{text!r} has no {pattern}")


def status(address, body=None, host=None):
    request = urllib.request.Request(address, body, {"Host": host} if host else {})
    try:
        with urllib.request.urlopen(request) as answer:
            return answer.status
    except urllib.error.HTTPError as refusal:
        return refusal.code


def test_addresses(look, keys):
    assert status(look) == 200 and status(look, host="example.org") == 403
    other = look[:-33] + "0" * 32 + "/"
    assert [status(other + name) for name in ("", "../", "events")] == [404] * 3 and status(other + "keys", b"s") == 404
    assert status(look + "keys", b"s") == 403 and status(keys + "keys", b"sad") == 409  # no text is expected


def test_page(browser, session, addresses, journal):
    look, keys = map(browser.open, addresses)
    has = lambda text: browser.await_text(lambda: journal.read_text(), re.escape(text))
    shows = lambda page, expression, pattern: browser.await_text(lambda: browser.see(page, expression), pattern)
    press = lambda key: shows(keys, f"[...document.querySelectorAll('button')].some((b) => b.textContent === '{key}' && (b.click(), true))", "True")
    shows(look, "doing.textContent", r"block 1 of 2, condition [AB], \d+ of 20 trials left")
    before = browser.see(look, "done.value")
    shows(look, "document.getElementById('path').getAttribute('points')", r"(\S+ ){50}")
    test_addresses(*addresses)
    shows(look, f"done.value > {before}", "True")
    assert browser.see(look, "document.querySelectorAll('button').length") == 0
    assert not any("secret" in browser.see(page, "document.documentElement.outerHTML") for page in (look, keys))
    pathlib.Path(PICTURE).write_bytes(base64.b64decode(browser.call("Page.captureScreenshot", keys)["data"]))
    press("Mark as invalid")
    has("marked as invalid by the experimenter")
    press("Record unblinding")
    shows(look, "says.textContent", "Press u again")
    press("Record unblinding")
    has('"event":"unblinded"')
    press("Note")
    shows(keys, "document.querySelectorAll('input').length", "1")
    browser.see(keys, "document.querySelector('input').value = 'a lamp'; document.querySelector('input').onkeydown({ key: 'Enter' })")
    has('"text":"a lamp"')
    press("Break")
    has('"asked":true')
    press("Stop the plate")
    shows(look, "says.textContent", "The plate is stopped")
    press("Quit")
    shows(look, "says.textContent", "Press q again")
    press("Quit")
    assert session.communicate(timeout=60)[0].startswith("sub-1: interrupted")
    shows(look, "says.textContent", "No data from the session")


with tempfile.TemporaryDirectory() as folder:
    study, script, data, said = (pathlib.Path(folder, name) for name in ("study.json", "script.json", "data", "said"))
    study.write_text(json.dumps(STUDY))
    script.write_text('{"clock": "real-time"}')
    browser = Browser(folder)
    browser.open("about:blank")  # waits until Chromium has started
    with open(said, "w") as file:
        session = subprocess.Popen([PROGRAM, "run", study, "--participant", "1", "--simulated", "3", "--scene", SCENE, "--data", data, "--live", "keys"],
                                   stderr=file, stdout=subprocess.PIPE, text=True, env={**os.environ, "XR_RUNTIME_JSON": MANIFEST, "HRT_MOCK_SCRIPT": script})
    try:
        browser.await_text(said.read_text, r"(http\S+\n.*){2}")
        test_page(browser, session, re.findall(r"http://\S+", said.read_text()), data / "sub-01/ses-01/journal.jsonl")
    finally:
        session.kill()
        browser.call("Browser.close")
        browser.process.wait()
