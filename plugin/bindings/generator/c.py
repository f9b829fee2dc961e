"""Generates two kinds of C headers: functions that return initialised structs, and a table of all functions for hosts
that load the library at run time."""

from __future__ import annotations

from abi import Abi, Struct

# Headers that haptic_retargeting.h includes; init.h initialises their structs. Any other header x.h includes x_init.h.
CORE = ("base.h", "reach.h", "session.h", "target.h")


def render_inits(abi: Abi, notice: str) -> dict[str, str]:
    inits = {"init.h": CORE} | {f"{h.removesuffix('.h')}_init.h": (h,) for h in abi.headers if h not in CORE}
    return {name: _render_init(abi, notice, name, headers) for name, headers in inits.items()}


def _render_init(abi: Abi, notice: str, name: str, headers: tuple[str, ...]) -> str:
    structs = [s for s in abi.structs if s.fields[0].name == "struct_size" and s.header in headers]
    cycle = "" if headers is CORE else "  /* NOLINT(misc-header-include-cycle) */"
    guard = f"HAPTIC_RETARGETING_{name.upper().replace('.', '_')}"
    return (f"/*\n * {notice}\n *\n"
            " * Functions that return initialised structs: configurations with defaults, other structs with zeros.\n"
            f" *\n *   {structs[0].name} value = {structs[0].name}_init();\n */\n"
            f"/* clang-format off */\n#ifndef {guard}\n#define {guard}\n\n"
            + "".join(f'#include "{header}"{cycle}\n' for header in headers)
            + "\n#if defined(__cplusplus)\n#define HRT_EMPTY {}\n#else\n#define HRT_EMPTY {0}\n#endif\n\n"
            + "\n".join(map(_init, structs))
            + "\n#undef HRT_EMPTY\n\n#endif\n")


def _init(struct: Struct) -> str:
    name = struct.name
    what = "Returns the struct with the default of every field" if struct.has_default else "Returns the struct with struct_size set; all other fields are zero"
    return (f"/** {what}. [any-thread] */\n"
            f"static inline {name} {name}_init(void) {{\n  {name} value = HRT_EMPTY;\n{fill(struct)}  return value;\n}}\n")


def fill(struct: Struct) -> str:
    """Returns C statements that set size and defaults of the zeroed struct `value`."""
    return "  value.struct_size = sizeof value;\n" + "".join(
        f"  value.{f.member}{f'[{i}]' if f.count else ''} = {literal};\n" for f in struct.fields
        for i, literal in enumerate(f.literals) if struct.has_default and literal.strip("0."))


def render_functions(abi: Abi, notice: str) -> str:
    members = [(f, f.name.removeprefix("hrt_")) for f in abi.functions]
    return (f"/*\n * {notice}\n *\n"
            " * A table of all functions, for hosts that load the library at run time and do not link it.\n"
            " *\n *   hrt_functions hrt;\n"
            f' *   void* library = dlopen("libhaptic_retargeting.so.{abi.soversion}", RTLD_NOW | RTLD_LOCAL);\n'
            " *   const char* missing = hrt_functions_load(dlsym, library, &hrt);\n"
            " *   if (!missing) hrt.session_create(HRT_VERSION, &config, &session);\n */\n"
            "/* clang-format off */\n#ifndef HAPTIC_RETARGETING_FUNCTIONS_H\n#define HAPTIC_RETARGETING_FUNCTIONS_H\n\n"
            "#include <string.h>\n\n#include \"haptic_retargeting.h\"\n"
            + "".join(f'#include "{header}"\n' for header in abi.headers if header not in CORE) + "\n"
            + "".join(f"typedef {f.result} (*PFN_{f.name})({f.declared});\n" for f in abi.functions)
            + "\n/** Pointers to all functions, named without hrt_. */\ntypedef struct hrt_functions {\n"
            + "".join(f"  PFN_{f.name} {member};\n" for f, member in members)
            + "} hrt_functions;\n\n"
            "/** A function that returns the address of a symbol, or null: dlsym() or, on Windows, a function that calls\n"
            " *  GetProcAddress(). */\n"
            "typedef void* (*hrt_get_proc)(void* library, const char* name);\n\n"
            "/** Fills the table. Returns null, or the name of the first function that the library lacks. All functions\n"
            " *  that the library lacks are null in the table. [any-thread] */\n"
            "static inline const char* hrt_functions_load(hrt_get_proc get_proc, void* library,\n"
            "                                             hrt_functions* out_functions) {\n"
            "  const char* missing = NULL;\n  void* address = NULL;\n"
            "#define HRT_LOAD(name)                                         \\\n"
            "  address = get_proc(library, \"hrt_\" #name);                   \\\n"
            "  memcpy(&out_functions->name, &address, sizeof address);      \\\n"
            "  if (address == NULL && missing == NULL) missing = \"hrt_\" #name;\n"
            + "".join(f"  HRT_LOAD({member})\n" for _, member in members)
            + "#undef HRT_LOAD\n  return missing;\n}\n\n#endif\n")
