"""The declarations against the model of the headers, which the compiler agrees with."""

import ctypes
import importlib
import re
import sys
from typing import Any

import numpy as np
import pytest
from conftest import BINDINGS, ROOT

import haptic_retargeting as hrt
from haptic_retargeting import _abi
from haptic_retargeting._library import library

sys.path.insert(0, str(BINDINGS / "generator"))
model = importlib.import_module("headers").read(ROOT / "plugin/include")


def python_name(c_name: str) -> str:
    name = "".join(part.capitalize() for part in c_name.removeprefix("hrt_").split("_"))
    return name if hasattr(_abi, name) else name + "Handle"


def test_structs_have_the_sizes_and_offsets_of_the_library() -> None:
    for struct in model.structs:
        declared = getattr(_abi, python_name(struct.name))
        places, size = model.layout(struct, ctypes.sizeof(ctypes.c_void_p))
        assert ctypes.sizeof(declared) == size, struct.name
        for field, place in zip(struct.fields, places):
            seen = getattr(declared, field.name)
            assert (seen.offset, seen.size) == (place.offset, place.size), f"{struct.name}::{field.name}"


def test_every_function_is_declared() -> None:
    assert len(model.functions) > 30
    for function in model.functions:
        assert getattr(library(), function.name).argtypes is not None, function.name


def test_help_has_units_ranges_and_defaults() -> None:
    text = hrt.SessionConfig.__doc__ or ""
    assert re.search(r"horizon: Steps that the controller plans ahead.*1\s+to 50\. Default 3\.", text, re.S)
    assert "Control.FIXED_PLATE" in text and "HRT_" not in text and "struct_size" not in text
    assert "OUT_OF_RANGE: A value is outside" in (hrt.ErrorCode.__doc__ or "")
    missing = [f"{struct.__name__}.{name}" for struct in vars(_abi).values()
               if isinstance(struct, type) and issubclass(struct, _abi.Struct) and struct is not _abi.Struct
               for name in struct.names() if not re.search(rf"^ *{name}\b", struct.__doc__ or "", re.M)]
    assert not missing


def test_versions_agree() -> None:
    assert hrt.__version__ == ".".join(map(str, hrt.library_version()))


def test_arrays_are_laid_out_as_the_structs() -> None:
    assert hrt.SAMPLE.itemsize == ctypes.sizeof(_abi.Sample)
    assert hrt.COMMAND.itemsize == ctypes.sizeof(_abi.Command)
    assert hrt.SAMPLE.fields["finger_position_m"][1] == _abi.Sample.finger_position_m.offset


def test_the_comment_of_a_group_is_the_enumerations() -> None:
    for enumeration, doc in ((_abi.Role, "Role of a target."), (_abi.LogLevel, "Level of a log message."),
                             (_abi.Control, "Source of the plate's commands.")):
        assert (enumeration.__doc__ or "").startswith(doc)
    assert "WARNING: " not in (_abi.LogLevel.__doc__ or "")


CONFIGS = [struct for struct in model.structs
           if f"{struct.name}_default" in {function.name for function in model.functions}]


def default_of(struct_name: str) -> _abi.Struct:
    config = getattr(_abi, python_name(struct_name))()
    assert getattr(library(), f"{struct_name}_default")(ctypes.byref(config), ctypes.sizeof(config)) == _abi.OK
    return config


@pytest.mark.parametrize("struct", CONFIGS, ids=lambda struct: struct.name)
def test_documented_defaults_are_the_librarys(struct: Any) -> None:
    values = {constant.name: constant.value for constant in model.constants}
    config = default_of(struct.name)
    compared = 0
    for field in struct.fields:
        documented = field.numbers.default
        if documented is None or field.name in ("struct_size", "reserved"):
            assert field.name in ("struct_size", "reserved", "name", "real_target", "virtual_target"), field.name
            continue
        expected = [values[documented]] if isinstance(documented, str) else [float(number) for number in documented]
        given = np.atleast_1d(np.array(getattr(config, field.name), float))
        assert given.tolist() == np.broadcast_to(expected, given.shape).tolist(), field.name
        compared += 1
    assert compared >= 3


def session_takes(**fields: float) -> bool:
    try:
        hrt.Session(**fields).close()
    except (hrt.Error, ValueError) as error:
        assert next(iter(fields)) in str(error), f"{fields}: {error}"
        return False
    return True


def test_documented_ranges_are_the_librarys() -> None:
    needed = {"plate_latency_ns": {"step_period_ns": 10**9}}  # at most 8 step periods
    compared = 0
    for field in model.struct("hrt_session_config").fields:
        limits = field.numbers
        if limits.lower is None or limits.upper is None or field.length or "stop" in field.name:  # stops depend on each other
            continue
        kind = float if field.type.name == "double" else int
        others = needed.get(field.name, {})
        for limit, outwards in ((kind(limits.lower), -1), (kind(limits.upper), 1)):
            beyond = float(np.nextafter(limit, outwards * np.inf)) if kind is float else limit + outwards
            assert session_takes(**{field.name: limit}, **others), f"{field.name} of {limit} is refused"
            assert not session_takes(**{field.name: beyond}, **others), f"{field.name} of {beyond} is accepted"
            compared += 1
    assert compared >= 40
