"""Two C headers: structs by value with their defaults, and all functions as a table for hosts that open the library
when they run."""

from __future__ import annotations

from abi import Abi, Struct

# The layers of headers, each with the file that has its structs by value.
LAYERS = {"init.h": ("base.h", "reach.h", "session.h", "target.h"),
          "setup_init.h": ("profile.h", "scene.h", "setup.h"),
          "study_init.h": ("study.h",)}


def render_init(abi: Abi, notice: str, name: str) -> str:
    structs = [s for s in abi.structs if s.fields[0].name == "struct_size" and s.header in LAYERS[name]]
    # The layer's own header includes its structs by value at its end.
    own = {name.replace("_init", ""): "  /* NOLINT(misc-header-include-cycle) */"}
    guard = f"HAPTIC_RETARGETING_{name.upper().replace('.', '_')}"
    return (f"/*\n * {notice}\n *\n"
            " * Each struct by value, ready for use: with its defaults, or zero with its size.\n"
            " *\n *   hrt_session_config config = hrt_session_config_init();\n */\n"
            f"/* clang-format off */\n#ifndef {guard}\n#define {guard}\n\n"
            + "".join(f'#include "{header}"{own.get(header, "")}\n' for header in LAYERS[name])
            + "\n#if defined(__cplusplus)\n#define HRT_EMPTY {}\n#else\n#define HRT_EMPTY {0}\n#endif\n\n"
            + "\n".join(map(_init, structs))
            + "\n#undef HRT_EMPTY\n\n#endif\n")


def _init(struct: Struct) -> str:
    name = struct.name
    what = "Every field with its default" if struct.has_default else "All zero, with its size"
    return (f"/** {what}. [any-thread] */\n"
            f"static inline {name} {name}_init(void) {{\n  {name} value = HRT_EMPTY;\n{fill(struct)}  return value;\n}}\n")


def fill(struct: Struct) -> str:
    """Sets the size and the defaults of `value`, which is zero."""
    return "  value.struct_size = sizeof value;\n" + "".join(
        f"  value.{f.member}{f'[{i}]' if f.count else ''} = {literal};\n" for f in struct.fields
        for i, literal in enumerate(f.literals) if struct.has_default and literal.strip("0."))


def render_functions(abi: Abi, notice: str) -> str:
    members = [(f, f.name.removeprefix("hrt_")) for f in abi.functions]
    return (f"/*\n * {notice}\n *\n"
            " * All functions as a table, for hosts that open the library when they run: the headers, and no linking.\n"
            " *\n *   hrt_functions hrt;\n"
            ' *   void* library = dlopen("libhaptic_retargeting.so.0", RTLD_NOW | RTLD_LOCAL);\n'
            " *   const char* missing = hrt_functions_load(dlsym, library, &hrt);\n"
            " *   if (!missing) hrt.session_create(HRT_VERSION, &config, &session);\n */\n"
            "/* clang-format off */\n#ifndef HAPTIC_RETARGETING_FUNCTIONS_H\n#define HAPTIC_RETARGETING_FUNCTIONS_H\n\n"
            "#include <string.h>\n\n#include \"haptic_retargeting.h\"\n#include \"setup.h\"\n#include \"study.h\"\n\n"
            + "".join(f"typedef {f.result} (*PFN_{f.name})({f.declared});\n" for f in abi.functions)
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
