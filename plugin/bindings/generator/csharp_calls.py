"""Generates methods in the style of C# for the C functions: functions of a handle become methods of its class, structs
are passed by value with their size set, the output is returned, errors are thrown. hrt_target_add becomes AddTarget of
the session."""

from __future__ import annotations

import textwrap

from abi import Abi, Function, HostError, Type, Value, pascal
from csharp import Renderer, camel

_CLASSES = {"hrt_session": "HapticRetargetingSession", "hrt_person": "HapticRetargetingPerson",
            "hrt_plate": "HapticRetargetingPlate"}
_STATIC = "HapticRetargetingLibrary"
# Methods whose names do not follow from the C functions.
_NAMES = {"hrt_target_list": "ListTargets", "hrt_gap_assign": "AssignTargets",
          "hrt_reach_touched": "ReachTouched", "hrt_profile_reset": "NewPerson",
          "hrt_flags_text": "FlagsText"}
# Functions, or the ends of their names, whose methods are hand-written. So are those of scenes.
_BY_HAND = ("hrt_session_get", "_create", "_destroy", "_open", "_close", "hrt_reach_update", "hrt_host_set", "hrt_host_set_log", "hrt_recording_replay")


def render(abi: Abi, plate: Abi, notice: str) -> str:
    names = Renderer(abi)
    methods: dict[str, list[str]] = {}
    for model, renderer in ((abi, names), (plate, Renderer(plate, names))):
        for function in model.functions:
            if function.returns_result and not function.name.endswith(_BY_HAND) and not function.name.startswith("hrt_scene_"):
                call = _Call(renderer, function)
                methods.setdefault(call.owner, []).append(call.render())
    text = "\n".join(f"public {'static ' if owner == _STATIC else 'sealed '}partial class {owner}\n{{\n"
                     + textwrap.indent("\n".join(bodies), "    ", lambda line: line.strip() != "") + "}\n"
                     for owner, bodies in methods.items())
    return (f"// {notice} The C headers describe each call.\nusing System;\nusing System.Text;\n\nnamespace Hrt\n{{\n"
            + textwrap.indent(text, "    ", lambda line: line.strip() != "") + "}\n")


def method_name(function: Function, noun: str) -> str:
    if function.name in _NAMES:
        return _NAMES[function.name]
    own, verb, *rest = function.name.removeprefix("hrt_").split("_")
    subject = [] if own == noun else [own]
    return pascal("_".join([verb, *subject, *rest] if verb in ("get", "set") else [verb, *rest, *subject]))


class _Call:
    def __init__(self, names: Renderer, function: Function) -> None:
        self.names, self.function = names, function
        first = function.params[0].type
        self.owner = _STATIC if first.pointer else _CLASSES.get(first.name, _STATIC)
        self.taken: list[str] = []  # parameters of the C# method
        self.before = ["Load();"] * (self.owner == _STATIC)
        self.passed = ["Handle"] * (self.owner != _STATIC)  # arguments of the C function
        self.returned = ("void", "")  # type and expression of what the C# method returns
        self.parameters = function.params[len(self.passed):]

    def render(self) -> str:
        while self.parameters:
            self.parameter(self.parameters.pop(0))
        noun = next((handle.removeprefix("hrt_") for handle, owner in _CLASSES.items() if owner == self.owner), "")
        static = "static " * (self.owner == _STATIC)
        lines = [*self.before, f"Check({self.names.native}.{self.function.name}({', '.join(self.passed)}));",
                 *([f"return {self.returned[1]};"] if self.returned[1] else [])]
        return (self.names.doc(self.function.doc, "")
                + f"public {static}{self.returned[0]} {method_name(self.function, noun)}({', '.join(self.taken)})\n{{\n"
                + "".join(f"    {line}\n" for line in lines) + "}\n")

    def parameter(self, p: Value) -> None:
        name, element = camel(p.name), "" if p.type.name in ("char", "void") else self.element(p)
        if p.name == "capacity":
            self.filled(self.parameters.pop(0))
        elif p.name.startswith("out_"):
            self.output(p, camel(p.name.removeprefix("out_")))
        elif p.type.name == "char":
            self.text(p, name)
        elif p.count:
            self.array(p, name)
        elif p.type.pointer and self.has_size(p):
            self.take(element, name, f"ref {name}", f"{name}.structSize = SizeOf<{element}>.Value;")
        elif not p.type.pointer and p.type.name in _CLASSES:
            self.take(_CLASSES[p.type.name], name, f"{name}.Handle")
        elif p.values:
            self.take(self.names.enumerations[p.values], name, f"(uint){name}")
        else:
            self.take(element, name, f"ref {name}" if p.type.pointer else name)

    def take(self, type_: str, name: str, passed: str, *before: str) -> None:
        self.taken.append(f"{type_} {name}")
        self.before += before
        self.passed.append(passed)

    def output(self, p: Value, name: str) -> None:
        element, enum = self.element(p), self.names.enumerations.get(p.values, "")
        self.returns(enum or element, f"({enum}){name}" if enum else name)
        if self.has_size(p):
            self.before.append(f"var {name} = new {element} {{ structSize = SizeOf<{element}>.Value }};")
        self.passed.append(f"ref {name}" if self.has_size(p) else f"out {element} {name}")

    def returns(self, type_: str, value: str) -> None:
        if self.returned[1]:
            raise HostError(f"{self.function.name} has several outputs, which generator/csharp_calls.py does not support")
        self.returned = (type_, value)

    def text(self, p: Value, name: str) -> None:
        if p.count:
            self.parameters.pop(0)  # the length of the text
            self.take("string", name, "bytes", f"byte[] bytes = Utf8.Bytes({name}, nameof({name}));")
            self.passed.append("(ulong)bytes.Length")
        else:
            self.take("string", name, f"Utf8.NullTerminated({name}, nameof({name}))")

    def array(self, p: Value, name: str) -> None:
        element = self.element(p)
        self.parameters.pop(0)  # the number of elements
        self.take(f"{element}[]", name, name, f"if ({name} == null) throw new ArgumentNullException(nameof({name}));")
        self.passed.append(f"(ulong){name}.Length")

    def filled(self, p: Value) -> None:
        """Declares an array for the function to fill, as long as an input array or as the count of a first call."""
        text = p.type.name == "char"
        name, element = camel(p.name.removeprefix("out_")), "byte" if text else self.element(p)
        given = next((taken.split("[] ")[1] for taken in self.taken if "[] " in taken), "")
        if not given:
            self.parameters.pop(0)
            first = ", ".join([*self.passed, "0", "null", "out ulong count"])
            self.before.append(f"Check({self.names.native}.{self.function.name}({first}));")
        length = "count + 1" if text else f"{given}.Length" if given else "count"
        value = f"Encoding.UTF8.GetString({name}, 0, (int)count)" if text else name
        self.returns("string" if text else f"{element}[]", value)
        self.before.append(f"var {name} = new {element}[{length}];")
        if self.has_size(p):
            self.before.append(f"if ({name}.Length > 0) {name}[0].structSize = SizeOf<{element}>.Value;")
        self.passed += [f"(ulong){name}.Length", name, *([] if given else ["out count"])]
        if not given and not text:
            self.before.append(f"if (count == 0) return {name};")

    def has_size(self, p: Value) -> bool:
        return any(s.name == p.type.name and s.fields[0].name == "struct_size" for s in self.names.abi.structs)

    def element(self, p: Value) -> str:
        return self.names.value(Type(p.type.name))
