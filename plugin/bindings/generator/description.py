"""The interface as text, a line for each thing that another version may change. The changelog has its hash, and tests of hosts
compare their declarations with it: fields have offset, size, type, range and default."""

from __future__ import annotations

from abi import Abi, Field


def render(abi: Abi) -> str:
    lines = [f"constant {c.name} {c.value}{'u' * c.unsigned}" for c in abi.constants if "_VERSION" not in c.name]
    for struct in abi.structs:
        places, size = abi.layout(struct, 8)
        lines.append(f"struct {struct.name} {size}")
        lines += [f"  {f.name} {place.offset} {place.size} {f.type}{_range(f)}"
                  for f, place in zip(struct.fields, places)]
    lines += [f"callback {f.result} {f.name}({f.declared})" for f in abi.callbacks] + [f"function {f.result} {f.name}({f.declared})" for f in abi.functions]
    return "\n".join(lines) + "\n"


def _range(field: Field) -> str:
    numbers = field.numbers
    text = f", {numbers.lower} to {numbers.upper}" * (numbers.lower is not None) + ", or 0" * numbers.zero
    default = numbers.default if isinstance(numbers.default, str) else " ".join(map(str, numbers.default or ()))
    return text + f", default {default}" * bool(default) + ", in profiles" * numbers.in_profiles
