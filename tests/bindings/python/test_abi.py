"""Tests the generated declarations. `model` is api.json, which update_api makes from the headers."""

import ctypes
import importlib
import re
import sys

from conftest import BINDINGS

import haptic_retargeting as hrt
from haptic_retargeting import _abi

sys.path.insert(0, str(BINDINGS / "generator"))
model = importlib.import_module("abi").Abi()


def python_name(c_name: str) -> str:
    name = "".join(part.capitalize() for part in c_name.removeprefix("hrt_").split("_"))
    return name + "Handle" if hasattr(_abi, name + "Handle") else name


def test_structs_have_the_sizes_and_offsets_of_the_library() -> None:
    for struct in (s for s in model.structs if s.size):
        declared = getattr(_abi, python_name(struct.name))
        assert ctypes.sizeof(declared) == struct.size, struct.name
        for field in struct.fields:
            seen = getattr(declared, field.name)
            assert (seen.offset, seen.size) == (field.offset, model.size(field)), f"{struct.name}::{field.name}"


def test_help_has_units_ranges_and_defaults() -> None:
    text = hrt.SessionConfig.__doc__ or ""
    assert re.search(r"horizon: Steps that the controller plans ahead.*1\s+to 20\. Default 3\.", text, re.S)
    assert "Control.FIXED_PLATE" in text and "HRT_" not in text and "struct_size" not in text
    assert "OUT_OF_RANGE: A value is outside" in (hrt.ErrorCode.__doc__ or "")
    assert all(eval(name, vars(hrt)) for c_name, name in _abi.NAMES.items() if c_name.startswith("hrt_"))
    missing = [f"{struct.__name__}.{name}" for struct in vars(_abi).values()
               if isinstance(struct, type) and issubclass(struct, _abi.Struct) and struct is not _abi.Struct
               for name in struct.names() if not re.search(rf"^ *{name}\b", struct.__doc__ or "", re.M)]
    assert not missing


def test_versions_agree() -> None:
    assert hrt.__version__ == ".".join(map(str, hrt.library_version()))
