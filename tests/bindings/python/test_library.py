"""Finding the library: what happens when it is missing, another one, or of another version."""

import os
import re
import runpy
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import BINDINGS

from haptic_retargeting import _abi


def in_a_process(code: str, library: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-c", code], env={**os.environ, "HRT_LIBRARY": library}, text=True,
                          capture_output=True, check=False)


def built(tmp_path: Path, source: str) -> str:
    (tmp_path / "library.c").write_text(source)
    out = tmp_path / "library.so"
    subprocess.run(["gcc", "-shared", "-fPIC", "-o", str(out), str(tmp_path / "library.c")], check=True)
    return str(out)


def version(major: int, minor: int) -> str:
    return ("void hrt_get_version(unsigned* a, unsigned* b, unsigned* c) "
            f"{{ *a = {major}; *b = {minor}; *c = 0; }}")


def test_missing_library_is_named() -> None:
    done = in_a_process("import haptic_retargeting as hrt; hrt.Session()", "/no/such/library.so")
    assert done.returncode == 1 and "/no/such/library.so cannot be loaded" in done.stderr and "HRT_LIBRARY" in done.stderr


def test_recordings_are_read_without_the_library() -> None:
    code = f"import haptic_retargeting as hrt; print(len(hrt.read_recording({str(BINDINGS / 'reach.csv')!r}).reaches))"
    assert in_a_process(code, "/no/such/library.so").stdout == "1\n"


@pytest.mark.parametrize("found", [(_abi.VERSION[0] + 1, 0), (_abi.VERSION[0], _abi.VERSION[1] - 1)])
def test_library_of_another_version_is_refused(tmp_path: Path, found: tuple[int, int]) -> None:
    done = in_a_process("import haptic_retargeting as hrt; hrt.Session()", built(tmp_path, version(*found)))
    assert done.returncode == 1 and f"has version {found[0]}.{found[1]}.0" in done.stderr


def test_library_without_the_functions_is_refused(tmp_path: Path) -> None:
    for source in ("int nothing;", version(*_abi.VERSION[:2])):
        done = in_a_process("import haptic_retargeting as hrt; hrt.Session()", built(tmp_path, source))
        assert done.returncode == 1 and "is not the haptic_retargeting library" in done.stderr, done.stderr


def test_example_of_the_readme_runs() -> None:
    text = (BINDINGS / "python/README.md").read_text()
    examples = re.findall(r"```python\n(.*?)```", text, re.S)
    assert examples
    for example in examples:
        exec(compile(example, "README.md", "exec"), {})


def test_closed_loop_shows_what_learning_is_for(capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(BINDINGS / "python/examples/closed_loop.py"))
    printed = capsys.readouterr().out
    rows = re.findall(r"^ +(0\.\d+) +([-+\d.]+) \+- [\d.]+ +([-+\d.]+) \+- ([\d.]+)$", printed, re.M)
    assert [row[0] for row in rows] == ["0.12", "0.15", "0.20", "0.25"]
    for weight, assumed, learnt, deviation in rows:
        # The mean of 50 is known to within about 3 standard errors of 0.13 degrees.
        assert abs(float(learnt) + 5) < 0.4 and 0.6 < float(deviation) < 1.3
        assert weight == "0.15" or abs(float(assumed) + 5) > 2
