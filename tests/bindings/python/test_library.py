import os
import re
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


def test_missing_numpy_is_named(tmp_path: Path) -> None:
    (tmp_path / "numpy.py").write_text("raise ImportError('no module')")
    code = f"import sys; sys.path.insert(0, {str(tmp_path)!r}); import haptic_retargeting"
    done = in_a_process(code, "")
    assert done.returncode == 1 and "haptic_retargeting needs numpy, 1.20 or later: pip install numpy" in done.stderr


def test_examples_of_the_readme_print_what_it_shows(capsys: pytest.CaptureFixture[str]) -> None:
    text = (BINDINGS / "python/README.md").read_text()
    examples = re.findall(r"```python\n(.*?)```.*?```text\n(.*?)```", text, re.S)
    assert len(examples) == 2
    for example, shown in examples:
        exec(compile(example, "README.md", "exec"), {})
        assert capsys.readouterr().out == shown
