# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Writes python/findspace/_findspace.pyi from the module's own signatures.

usage: PYTHONPATH=build/python/python /usr/bin/python3 python/make_stubs.py > python/findspace/_findspace.pyi
"""
import inspect
import re

HEAD = """# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
# Written by python/make_stubs.py; a test compares.
from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, ClassVar, overload

import numpy
import numpy.typing
"""
TYPES = [
    (r"findspace\._findspace\.", ""),
    (r"numpy\.ndarray\[([a-z0-9.]+)\]", r"numpy.typing.NDArray[\1]"),
    (r"NDArray\[bool\]", "NDArray[numpy.bool_]"),
    (r"\bList\[", "list["), (r"\bDict\[", "dict["), (r"\bTuple\[", "tuple["),
    (r"Optional\[((?:[^\[\]]|\[[^\]]*\])*)\]", r"\1 | None"),
    (r"Annotated\[list\[float\], FixedSize\(\d\)\]|list\[float\[\d\]\]|(float)\[\d\]", r"list[float]"),
    (r"list\[bool\[\d\]\]|(bool)\[\d\]", r"list[bool]"),
    (r"\bSequence\b(?!\[)", "Sequence[Any]"),
    (r"= <[^>]*>", "= ..."), (r"= Formula\('true'\)", "= ..."),
    (r"(?<=: )object\b", "Any"), (r"(?<=-> )object\b", "Any"),
]


def typed(text, argument):
    for pattern, by in TYPES:
        text = re.sub(pattern, by, text)
    return re.sub(r"(positions|ring|points|vertices|faces|chain): numpy\.typing\.NDArray\[[a-z0-9._]+\]",
                  r"\1: numpy.typing.ArrayLike", text) if argument else text


def signatures(name, doc):
    """The signatures in a docstring of pybind11, one for each overload."""
    found = []
    for line in (doc or "").splitlines():
        match = re.match(rf"(?:\d+\. )?{re.escape(name)}\((.*)\) -> (.*)$", line.strip())
        if match:
            found.append((typed(match[1], True).replace("self: object", "self"), typed(match[2], False)))
    return [f for f in found if f[0] != "*args, **kwargs"]


def function(name, doc, indent):
    out = []
    found = signatures(name, doc)
    for arguments, result in found:
        if len(found) > 1:
            out.append(f"{indent}@overload")
        out.append(f"{indent}def {name}({re.sub(r'^self: [A-Za-z]+', 'self', arguments)}) -> {result}: ...")
    return out


def methods(cls):
    out = []
    for name, value in sorted(vars(cls).items()):
        if isinstance(value, property):
            result = re.search(r"-> (.*)$", (value.fget.__doc__ or "").strip().splitlines()[0]) if value.fget.__doc__ else None
            out += ["    @property", f"    def {name}(self) -> {typed(result[1], False) if result else 'Any'}: ..."]
        elif isinstance(value, staticmethod):
            lines = function(name, value.__func__.__doc__, "    ")
            out += [line for def_line in lines for line in
                    (["    @staticmethod", def_line] if def_line.lstrip().startswith("def") else [def_line])]
        elif name not in ("__module__", "__doc__", "__new__", "__getstate__", "__setstate__", "__hash__") and hasattr(value, "__doc__"):
            out += function(name, value.__doc__, "    ")
    return out or ["    ..."]


def stub(module):
    out = [HEAD]
    for name, value in sorted(vars(module).items()):
        if name.startswith("_"):
            continue
        if inspect.isclass(value):
            bases = [b.__name__ for b in value.__bases__ if b.__name__ not in ("object", "pybind11_object")]
            body = methods(value)
            if issubclass(value, Exception):
                known = ["limit"] if name == "Stopped" else ["message", "place", "code"]
                body = [f"    {k}: str" for k in known]
            out += [f"\nclass {name}({', '.join(bases)}):" if bases else f"\nclass {name}:", *body]
        else:
            out += ["", *function(name, value.__doc__, "")]
    return "\n".join(out) + "\n"


if __name__ == "__main__":
    from findspace import _findspace
    print(stub(_findspace), end="")
