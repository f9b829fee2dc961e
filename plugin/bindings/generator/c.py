"""Two C headers: structs by value with their defaults, and all functions as a table for hosts that open the library
when they run."""

from __future__ import annotations

import textwrap

from abi import Abi, Function, Struct

_WIDTH = 110


def render_init(abi: Abi, notice: str) -> str:
    functions = {f.name for f in abi.functions}
    structs = [s for s in abi.structs if s.fields[0].name == "struct_size"]
    return (f"/*\n * {notice}\n *\n"
            " * Each struct by value, ready for use: with its defaults, or zero with its size.\n"
            " *\n *   hrt_session_config config = hrt_session_config_init();\n */\n"
            "/* clang-format off */\n#ifndef HAPTIC_RETARGETING_INIT_H\n#define HAPTIC_RETARGETING_INIT_H\n\n"
            + "".join(f'#include "{name}"\n' for name in abi.headers)
            + "\n#if defined(__cplusplus)\n#define HRT_EMPTY {}\n#else\n#define HRT_EMPTY {0}\n#endif\n\n"
            + "\n".join(_init(s, f"{s.name}_default" in functions) for s in structs)
            + "\n#undef HRT_EMPTY\n\n#endif\n")


def _init(struct: Struct, has_default: bool) -> str:
    name = struct.name
    fill = (f"  if ({name}_default(&value, sizeof value) != HRT_OK) value.struct_size = 0;\n" if has_default
            else "  value.struct_size = sizeof value;\n")
    what = f"{name}_default() by value" if has_default else "All zero, with its size"
    return (f"/** {what}. [any-thread] */\n"
            f"static inline {name} {name}_init(void) {{\n  {name} value = HRT_EMPTY;\n{fill}  return value;\n}}\n")


def render_functions(abi: Abi, notice: str) -> str:
    members = [(f, f.name.removeprefix("hrt_")) for f in abi.functions]
    return (f"/*\n * {notice}\n *\n"
            " * All functions as a table, for hosts that open the library when they run: the headers, and no linking.\n"
            " *\n *   hrt_functions hrt;\n"
            ' *   void* library = dlopen("libhaptic_retargeting.so.0", RTLD_NOW | RTLD_LOCAL);\n'
            " *   const char* missing = hrt_functions_load(dlsym, library, &hrt);\n"
            " *   if (!missing) hrt.session_create(&config, &session);\n */\n"
            "/* clang-format off */\n#ifndef HAPTIC_RETARGETING_FUNCTIONS_H\n#define HAPTIC_RETARGETING_FUNCTIONS_H\n\n"
            "#include <string.h>\n\n#include \"haptic_retargeting.h\"\n\n"
            + "".join(_typedef(f) for f in abi.functions)
            + "\n/** Every function, without hrt_. */\ntypedef struct hrt_functions {\n"
            + "".join(f"  PFN_{f.name} {member};\n" for f, member in members)
            + "} hrt_functions;\n\n"
            "/** Returns the address of a symbol, or null: dlsym() as it is; on Windows, what calls GetProcAddress(). */\n"
            "typedef void* (*hrt_get_proc)(void* library, const char* name);\n\n"
            "/** Fills the table. Returns null, or the name of the first function that the library lacks; those that\n"
            " *  it lacks are null in the table. [any-thread] */\n"
            "static inline const char* hrt_functions_load(hrt_get_proc get_proc, void* library,\n"
            "                                             hrt_functions* out_functions) {\n"
            "  const char* missing = NULL;\n  void* address = NULL;\n"
            "#define HRT_LOAD(name)                                         \\\n"
            "  address = get_proc(library, \"hrt_\" #name);                   \\\n"
            "  memcpy(&out_functions->name, &address, sizeof address);      \\\n"
            "  if (address == NULL && missing == NULL) missing = \"hrt_\" #name;\n"
            + "".join(f"  HRT_LOAD({member})\n" for _, member in members)
            + "#undef HRT_LOAD\n  return missing;\n}\n\n#endif\n")


def _typedef(function: Function) -> str:
    head = f"typedef {'hrt_result' if function.returns_result else function.result} (*PFN_{function.name})("
    parameters = function.declared
    if len(head + parameters) + 2 <= _WIDTH:
        return f"{head}{parameters});\n"
    indent = " " * len(head) if len(head) < 60 else "    "
    lines = textwrap.wrap(parameters + ");", _WIDTH - len(indent))
    return head + ("\n" + indent).join(lines) + "\n"
