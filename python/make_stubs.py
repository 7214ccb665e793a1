# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Writes python/findspace/_findspace.pyi from the module's own signatures.

usage: PYTHONPATH=build/release/python /usr/bin/python3 python/make_stubs.py > python/findspace/_findspace.pyi
"""
import inspect
import re
import sys

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
    (r"findspace\._findspace\.|findspace::", ""),
    (r"numpy\.ndarray\[([a-z0-9.]+)\]", r"numpy.typing.NDArray[\1]"),
    (r"NDArray\[bool\]", "NDArray[numpy.bool_]"),
    (r"(?:List\[)?\b(float|bool)\[\d\]\]?", r"list[\1]"),
    (r"\bList\[", "list["), (r"\bDict\[", "dict["), (r"\bTuple\[", "tuple["),
    (r"Optional\[((?:[^\[\]]|\[(?:[^\[\]]|\[[^\]]*\])*\])*)\]", r"\1 | None"),
    (r"\bsequence\b", "Sequence[Any]"),
    (r"(Callable\[\[[^\]]*\], None\]) = None", r"\1 | None = None"),
    (r"= <[^>]*>", "= ..."), (r"= Formula\('true'\)", "= ..."),
    (r"(?<=: )object\b", "Any"), (r"(?<=-> )object\b", "Any"),
]
# What signatures leave open.
RESULTS = {
    "World.solve": "Region | SpaceRegion",
    "World.on_line": "tuple[list[Interval], bool]",
    "Query.nearest": "tuple[tuple[float, ...], float, bool] | None",
    "Region.nearest": "tuple[tuple[float, ...], float, bool] | None",
    "SpaceRegion.bounds": "tuple[list[float], list[float]] | None",
    "SpaceRegion.boxes": "list[tuple[list[float], list[float], list[bool], list[bool]]]",
    "AdjustedPhi.evaluate": "tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]",
    "Packing.layout": "PackLayout",
    "Packing.sparrow": "tuple[Packing, PackLayout]",
    "SolidPacking.layout": "SolidPackLayout",
    "Shape.polygons": "list[Shape]",
    "Phi.evaluate": "tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]",
    "Region.__geo_interface__": "dict[str, Any]",
    "Shape.__geo_interface__": "dict[str, Any]",
}


def typed(text, argument):
    for pattern, by in TYPES:
        text = re.sub(pattern, by, text)
    if not argument:
        return text
    text = re.sub(r"(positions|ring|points|vertices|faces|heights): numpy\.typing\.NDArray\[[a-z0-9._]+\]",
                  r"\1: numpy.typing.ArrayLike", text)
    text = re.sub(r"problem: (Solid|)Packing\b", r"problem: \1Packing | \1PackProblem", text)
    return re.sub(r"(?<!self: )\bFormula\b", "Formula | str", text)


def with_words(arguments):
    """**kwargs are the words of Options."""
    if not arguments.endswith(", **kwargs"):
        return arguments
    from findspace import Options
    words = re.search(r"\*, (.*)", signatures("__init__", Options.__init__.__doc__)[0][0])[1].split(", ")
    given = arguments.removesuffix("**kwargs")
    own = [word for word in words if f" {word.split(':')[0]}:" not in given]
    return given + ("" if "*, " in given else "*, ") + ", ".join(own)


def signatures(name, doc):
    """The signatures in a docstring of pybind11, one for each overload."""
    found = []
    for line in (doc or "").splitlines():
        match = re.match(rf"(?:\d+\. )?{re.escape(name)}\((.*)\) -> (.*)$", line.strip())
        if match:
            found.append((typed(match[1], True).replace("self: object", "self"), typed(match[2], False)))
    return [f for f in found if f[0] != "*args, **kwargs"]


def function(name, doc, indent, result_of=None):
    out = []
    found = signatures(name, doc)
    for arguments, result in found:
        if len(found) > 1:
            out.append(f"{indent}@overload")
        arguments = re.sub(r"^self: [A-Za-z]+", "self", with_words(arguments))
        out.append(f"{indent}def {name}({arguments}) -> {RESULTS.get(result_of, result)}: ...")
    return out


SKIPPED = ("__module__", "__doc__", "__new__", "__getstate__", "__setstate__", "__hash__")


def result_of_property(cls, name, value):
    known = f"{cls.__name__}.{name}"
    match = re.search(r"-> (.*)$", (value.fget.__doc__ or "").strip().split("\n")[0])
    return RESULTS.get(known) or (typed(match[1], False) if match else "Any")


def methods(cls):
    out = []
    for name, value in sorted(vars(cls).items()):
        if isinstance(value, property):
            out += ["    @property", f"    def {name}(self) -> {result_of_property(cls, name, value)}: ..."]
            if value.fset:
                out += [f"    @{name}.setter", f"    def {name}(self, value: Any) -> None: ..."]
        elif isinstance(value, staticmethod):
            for line in function(name, value.__func__.__doc__, "    ", f"{cls.__name__}.{name}"):
                out += ["    @staticmethod", line]
        elif inspect.isfunction(value):  # of the Python files
            rest = ", ".join(f"{p.name}: Any = ..." if p.kind != p.VAR_KEYWORD else f"**{p.name}: Any"
                             for p in list(inspect.signature(value).parameters.values())[1:])
            out.append(f"    def {name}(self{', ' + rest if rest else ''}) -> Any: ...")
        elif name not in SKIPPED and hasattr(value, "__doc__"):
            out += function(name, value.__doc__, "    ", f"{cls.__name__}.{name}")
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
    sys.path.pop(0)  # the folder of this file has the Python files alone
    from findspace import _findspace
    print(stub(_findspace), end="")
