"""Controls the HRTX mock runtime while an application runs on it.

    hrtx-run --control /tmp/mock -- application
    python3 -c 'import hrtx_control; print(hrtx_control.Runtime("/tmp/mock").state())'

Every method returns what the runtime then is in: `frame` and `time_ns` of the session, its `state`, and the plate's `plate_deg`. What
the runtime refuses raises a ValueError with its reason.
"""
import json
import socket
import time


class Runtime:
    """The session of an application; waits up to `timeout_s` until there is one."""

    def __init__(self, path, timeout_s=10.0):
        give_up = time.monotonic() + timeout_s
        while True:
            self._socket = socket.socket(socket.AF_UNIX)
            self._socket.settimeout(timeout_s)
            try:
                self._socket.connect(path)
                break
            except OSError:
                self._socket.close()
                if time.monotonic() > give_up:
                    raise
                time.sleep(0.02)
        self._lines = self._socket.makefile("r", encoding="utf-8")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self._lines.close()
        self._socket.close()

    def send(self, **command):
        """Any command: an event of a script by its `do`, a fault by its `function`, or `advance_ms`."""
        self._socket.sendall(json.dumps(command).encode() + b"\n")
        line = self._lines.readline()
        if not line:
            raise ConnectionError("the session has ended")
        reply = json.loads(line)
        if "error" in reply:
            raise ValueError(reply["error"])
        return reply

    def state(self):
        return self.send()

    def put_hand(self, hand, position_m, **orientation):
        """The fingertip of "left" or "right", in LOCAL; `orientation`, x, y, z, w, is the wrist's."""
        return self.send(do="put", hand=hand, position_m=list(position_m), **orientation)

    def put_head(self, position_m, **orientation):
        return self.send(do="put", of="head", position_m=list(position_m), **orientation)

    def input(self, device, source, value):
        """A button (True), trigger or stick of a controller, such as "right", "select/click", True."""
        return self.send(do="input", device=device, source=source, value=value)

    def lose_tracking(self, hand):
        return self.send(do="lose_tracking", hand=hand)

    def regain_tracking(self, hand):
        return self.send(do="regain_tracking", hand=hand)

    def fail(self, function, result, count=1):
        """The next `count` calls of a function return this error."""
        return self.send(function=function, result=result, count=count)

    def advance(self, milliseconds):
        """Lets the manual clock advance by this."""
        return self.send(advance_ms=milliseconds)

    def take_picture(self):
        """Of the next frame; where pictures are kept, hrtx-run --frames says."""
        return self.send(do="take_picture")
