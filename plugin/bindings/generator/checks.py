"""A C source that compiles only if the model is what the compiler sees."""

from __future__ import annotations

from abi import Abi


def render(abi: Abi, pointer_size: int, exported: str) -> str:
    """`exported` is the macro of declarations."""
    lines = [*(f"#include <haptic_retargeting/{name}>" for name in abi.headers),
             f"_Static_assert(sizeof(void*) == {pointer_size}, \"size of a pointer\");"]
    lines += [f'_Static_assert({c.name} == {c.value}{"u" if c.unsigned else ""}, "{c.name}");' for c in abi.constants]
    for struct in abi.structs:
        places, size = abi.layout(struct, pointer_size)
        lines.append(f'_Static_assert(sizeof({struct.name}) == {size}, "size of {struct.name}");')
        for field, place in zip(struct.fields, places):
            lines.append(f'_Static_assert(offsetof({struct.name}, {field.member}) == {place.offset}, '
                         f'"offset of {struct.name}::{field.name}");')
    # Declared again: an error unless the types are the same.
    for function in abi.functions:
        lines.append(f"{exported} {function.result} {function.name}({function.declared});")
    return "\n".join(lines) + "\n"
