"""The functions of the C interface as methods in C#'s manner: a handle's are methods of its class, a struct comes by value with
its size set, what a function fills in is returned, a refusal is thrown. hrt_target_add becomes AddTarget of the session."""

from __future__ import annotations

import re
import textwrap

from abi import Abi, Function, Parameter, Type, pascal
from csharp import Renderer, camel

_CLASSES = {"hrt_session": "HapticRetargetingSession", "hrt_person": "HapticRetargetingPerson",
            "hrt_plate": "HapticRetargetingPlate"}
_STATIC = "HapticRetargetingLibrary"
# Whose names do not follow from those of the headers.
_NAMES = {"hrt_target_list": "ListTargets", "hrt_target_assign": "AssignTargets",
          "hrt_reach_touched": "ReachTouched"}
# What the classes have by hand: constructors, updates without garbage, scenes, and what belongs to the process.
BY_HAND = ("hrt_session_get", "_create", "_destroy", "_open", "_close", "hrt_reach_update", "hrt_set_host", "hrt_replay")


def is_generated(function: Function) -> bool:
    by_hand = function.name.endswith(BY_HAND) or function.name.startswith("hrt_scene_")
    return function.returns_result and not by_hand


def render(abi: Abi, plate: Abi, notice: str) -> str:
    names, plate_names = Renderer(abi), Renderer(plate, "hrt_plate", "PlateNative")
    plate_names.fields = names.fields | plate_names.fields
    methods: dict[str, list[str]] = {}
    for model, renderer in ((abi, names), (plate, plate_names)):
        for function in filter(is_generated, model.functions):
            call = _Call(renderer, function)
            methods.setdefault(call.owner, []).append(call.render())
    text = "\n".join(f"public {'static ' if owner == _STATIC else 'sealed '}partial class {owner}\n{{\n"
                     + textwrap.indent("\n".join(bodies), "    ", lambda line: line.strip() != "") + "}\n"
                     for owner, bodies in methods.items())
    return (f"// {notice} They say more of each call.\nusing System;\nusing System.Text;\n\nnamespace Hrt\n{{\n"
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
        first = function.parameters[0].type
        self.owner = "" if first.pointer else _CLASSES.get(first.name, "")
        self.taken: list[str] = []  # of the method
        self.before: list[str] = []
        self.passed: list[str] = []  # to the function
        self.returned: tuple[str, str] | None = None  # its type, and what is returned
        self.parameters = list(function.parameters)
        outputs = [p.name for p in self.parameters if p.name.startswith("out_") and p.name != "out_count"]
        sized = [p.name for p in self.parameters if p.name in outputs and self.has_size(p.type) and not p.array]
        self.main_output = next(iter(sized + outputs), "")
        enums = {prefix for prefix in re.findall(r"\b(HRT_[A-Z_]+_)\*", function.doc) if prefix in names.enums}
        self.enum = names.enums[enums.pop()] if len(enums) == 1 else ""
        if self.owner:
            self.parameters.pop(0)
            self.passed.append("Handle")
        else:
            self.owner = _STATIC
            self.before.append("Load();")

    def render(self) -> str:
        while self.parameters:
            self.parameter(self.parameters.pop(0))
        return_type, value = self.returned or ("void", "")
        static = "static " if self.owner == _STATIC else ""
        noun = next((handle.removeprefix("hrt_") for handle, owner in _CLASSES.items() if owner == self.owner), "")
        text = self.names.doc(self.function.doc, "")
        text += f"public {static}{return_type} {method_name(self.function, noun)}({', '.join(self.taken)})\n{{\n"
        call = f"Check({self.names.native}.{self.function.name}({', '.join(self.passed)}));"
        lines = [*self.before, call, *([f"return {value};"] if value else [])]
        return text + "".join(f"    {line}\n" for line in lines) + "}\n"

    def parameter(self, p: Parameter) -> None:
        name, type_ = camel(p.name), p.type
        if p.name == "capacity":
            self.filled(self.parameters.pop(0))
        elif p.name.startswith("out_"):
            self.output(p, camel(p.name.removeprefix("out_")))
        elif type_.name == "char":
            self.text(p, name)
        elif p.array:
            self.array(p, name)
        elif type_.pointer and self.has_size(type_):
            self.taken.append(f"{self.element(type_)} {name}")
            self.before.append(f"{name}.structSize = SizeOf<{self.element(type_)}>.Value;")
            self.passed.append(f"ref {name}")
        elif not type_.pointer and type_.name in _CLASSES:
            self.taken.append(f"{_CLASSES[type_.name]} {name}")
            self.passed.append(f"{name}.Handle")
        elif type_.name == "uint32_t" and self.enum:
            self.taken.append(f"{self.enum} {name}")
            self.passed.append(f"(uint){name}")
        else:
            self.taken.append(f"{self.element(type_)} {name}")
            self.passed.append(f"ref {name}" if type_.pointer else name)

    def output(self, p: Parameter, name: str) -> None:
        element = self.element(p.type)
        if any(taken.split(" ")[-1] == name for taken in self.taken):
            name = f"found{name[:1].upper()}{name[1:]}"
        enum = self.enum if element == "uint" else ""
        declared = self.declare(p, enum or element, f"({enum}){name}" if enum else name, name)
        if self.has_size(p.type):
            self.before.append(f"{declared}{name} = new {element} {{ structSize = SizeOf<{element}>.Value }};")
            self.passed.append(f"ref {name}")
        else:
            self.passed.append(f"out {element} {name}" if declared else f"out {name}")

    def declare(self, p: Parameter, type_: str, value: str, name: str) -> str:
        """Has an output returned, and is its declaration; another one is the method's."""
        if p.name == self.main_output:
            self.returned = (type_, value)
            return "var "
        self.taken.append(f"out {type_} {name}")
        return ""

    def text(self, p: Parameter, name: str) -> None:
        self.taken.append(f"string {name}")
        if p.array:
            self.parameters.pop(0)  # its length
            self.before.append(f"byte[] bytes = Utf8.Bytes({name}, nameof({name}));")
            self.passed += ["bytes", "(ulong)bytes.Length"]
        else:
            self.passed.append(f"Utf8.ZeroEnded({name}, nameof({name}))")

    def array(self, p: Parameter, name: str) -> None:
        element = self.element(p.type)
        self.parameters.pop(0)  # their count
        self.taken.append(f"{element}[] {name}")
        self.before.append(f"if ({name} == null) throw new ArgumentNullException(nameof({name}));")
        if self.has_size(p.type):
            self.before += [f"{name} = ({element}[]){name}.Clone();",
                            f"for (int i = 0; i < {name}.Length; ++i) {name}[i].structSize = SizeOf<{element}>.Value;"]
        self.passed += [name, f"(ulong){name}.Length"]

    def filled(self, p: Parameter) -> None:
        """An array for the function to fill: as long as the one that it was given, or as the function says at first."""
        name, element = camel(p.name.removeprefix("out_")), "byte" if p.type.name == "char" else self.element(p.type)
        given = next((taken.split("[] ")[1] for taken in self.taken if "[] " in taken), "")
        counted = not given
        if counted:
            self.parameters.pop(0)
            first = ", ".join([*self.passed, "0", "null", "out ulong count"])
            self.before.append(f"Check({self.names.native}.{self.function.name}({first}));")
        length = "count + 1" if element == "byte" else "count" if counted else f"{given}.Length"
        value = f"Encoding.UTF8.GetString({name}, 0, (int)count)" if element == "byte" else name
        declared = self.declare(p, "string" if element == "byte" else f"{element}[]", value, name)
        self.before.append(f"{declared}{name} = new {element}[{length}];")
        if self.has_size(p.type):
            self.before.append(f"if ({name}.Length > 0) {name}[0].structSize = SizeOf<{element}>.Value;")
        self.passed += [f"(ulong){name}.Length", name, *(["out count"] if counted else [])]
        if counted and element != "byte":
            self.before.append(f"if (count == 0) return {name};")

    def has_size(self, type_: Type) -> bool:
        return any(s.name == type_.name and s.fields[0].name == "struct_size" for s in self.names.abi.structs)

    def element(self, type_: Type) -> str:
        return self.names.value(Type(type_.name))
