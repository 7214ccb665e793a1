# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""What the pretty-printers read of the standard library, as libstdc++ holds it in memory."""
import struct

import gdb


def elements(vector):
    """The elements of a std::vector."""
    start, finish = vector["_M_impl"]["_M_start"], vector["_M_impl"]["_M_finish"]
    return [start[i] for i in range(int(finish - start))]


def size(vector):
    return int(vector["_M_impl"]["_M_finish"] - vector["_M_impl"]["_M_start"])


def column(vector, *names):
    """One member of all elements of a std::vector, or several; in one read of memory, since complexes may be large."""
    count, start = size(vector), vector["_M_impl"]["_M_start"]
    kind = start.type.strip_typedefs().target().strip_typedefs()
    form = {(8, True): "d", (8, False): "q", (4, False): "I", (1, False): "b"}
    members = []
    for field in (f for name in names for f in kind.fields() if f.name == name):
        bare = field.type.strip_typedefs()
        members.append((field.bitpos // 8, form[bare.sizeof, bare.code == gdb.TYPE_CODE_FLT]))
    memory = gdb.selected_inferior().read_memory(int(start), count * kind.sizeof).tobytes() if count else b""
    rows = [[struct.unpack_from(letter, memory, i * kind.sizeof + offset)[0] for offset, letter in members] for i in range(count)]
    return [row[0] for row in rows] if len(names) == 1 else rows


def string(value):
    return value["_M_dataplus"]["_M_p"].string("utf-8", "replace", int(value["_M_string_length"]))


def pointed(shared):
    """What a std::shared_ptr points to, or None."""
    return None if int(shared["_M_ptr"]) == 0 else shared["_M_ptr"].dereference()


def held(optional):
    """What a std::optional holds, or None."""
    payload = optional["_M_payload"]
    return payload["_M_payload"]["_M_value"] if payload["_M_engaged"] else None


def enumerator(value):
    """The name of an enumerator without what stands before it: kGamma1 -> Gamma1."""
    return str(value).rsplit("::", 1)[-1].removeprefix("k")


def counted(number, one, many):
    return f"{number} {one if number == 1 else many}"
