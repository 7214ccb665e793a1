#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Figures of how the house stands, as a Markdown table; of any checkout, with streets or with flat layers.

usage: house_figures.py [ROOT] [--compare ROOT] [--build FOLDER] [--no-preprocessing]
  ROOT                the checkout; this one if none is given
  --compare ROOT      an older checkout: its figures stand in a first column
  --build FOLDER      the build folder in every ROOT, made for Ninja; the first of build/* if none is given
  --no-preprocessing  leaves out what takes minutes

files a street     .h and .cpp files of a folder src/<layer>/<street>/, or src/<layer>/ where there are no streets.
methods a class    functions that a class or struct of src, include or apps declares; constructors, destructors and what
                   is defaulted or deleted do not count. A class that many files define counts once and whole.
words a sentence   of README.md and docs/*.md, without headings, code blocks and cells of tables of at most twelve
                   words. Code in a sentence is one word.
margins            hexadecimal literals of 2^-10 and less (0x1p-40) outside src/exact.
catches            `catch` blocks that ask for ErrorCode::kUnsupported, and calls of exact::tried, which catches it for
                   its caller: they try another way, or leave something out. Beside them the blocks that take any
                   Error and throw none.
lines a file       after the preprocessor, of the median of at most 60 source files of src, with the flags of
                   the build folder, empty lines left out; then what comes after the precompiled header, which is all that
                   the compiler reads of it, where there is one.
equal names        of anonymous namespaces, in several files of a street: they hinder unity builds."""
import argparse
import glob
import json
import os
import re
import shlex
import statistics
import subprocess
import sys

from check_layers import CODE, ROOT, files, read, without_comments

CODE_FOLDERS = ("src", "include", "apps")
CLASS = re.compile(r"(?<!enum )\b(class|struct)\s+(\w+)(?:\s+final)?\s*(?::[^;{(]*)?\{")
MARGIN = re.compile(r"\b0[xX][0-9a-fA-F.']+[pP]-(\d+)")
LEAST_EXPONENT = 10
SAMPLE = 60
LONG_CELL = 12  # words
PRECOMPILED = "cmake_pch.hxx"
WITH_VALUE = ("-o", "-c", "-include", "-include-pch", "-MF", "-MT", "-MQ", "-x")  # options left out, with their value
ALONE = ("-MD", "-MMD", "-Winvalid-pch", "-fpch-preprocess", "-fno-pch-timestamp")  # and those that have none


# --- C++ as text ---------------------------------------------------------------------------------------------------

class Code:
    """The C++ of a checkout: {path: text without comments and strings}, read once."""

    def __init__(self, root):
        self.root = root
        self.text = {path: without_comments(read(root, path))
                     for folder in CODE_FOLDERS for path in files(root, folder) if path.endswith(CODE)}

    def streets(self):
        """{folder: paths} of src."""
        streets = {}
        for path in self.text:
            if path.startswith("src" + os.sep):
                streets.setdefault(os.path.dirname(path), []).append(path)
        return streets


def closing(text, opening):
    """Where the brace that opens at `opening` closes."""
    depth = 0
    for match in re.compile(r"[{}]").finditer(text, opening):
        depth += 1 if match.group() == "{" else -1
        if depth == 0:
            return match.start()
    return len(text)


def statements(text):
    """The statements of a body, the insides of their braces left out; a label such as `public:` is one of its own."""
    flat, at = "", 0
    while True:
        opening = text.find("{", at)
        if opening < 0:
            break
        end = closing(text, opening)
        after = text[end + 1:end + 40].lstrip()
        ends = not after.startswith((";", ",", "{", ")", "="))  # the body of a function, not an initialiser
        flat += text[at:opening] + ("{}\n;" if ends else "{}")
        at = end + 1
    flat = re.sub(r"^\s*#.*$", "", flat + text[at:], flags=re.M)
    flat = re.sub(r"\b(public|private|protected)\s*:(?!:)", r";\1;", flat)
    return [" ".join(statement.split()) for statement in flat.split(";") if statement.strip()]


def function_name(statement):
    """The name of the function that a statement declares, or None."""
    if re.match(r"(using|friend|typedef|static_assert|enum|class|struct|namespace|extern)\b", statement):
        return None
    statement = re.sub(r"^template\s*<[^;]*?>\s*(?=[\w:\[~])", "", statement)
    operator = re.search(r"\boperator\s*(\(\)|[^\s\w(]+|[\w:<>&* ]+)\s*\(", statement)
    if operator:
        return "operator" + operator.group(1)
    angles, depth = "", 0
    for character in statement:  # what stands between < and > names types
        depth += (character == "<") - (character == ">")
        angles += character if depth <= 0 and character != ">" else ""
    found = re.match(r"[^=({]*?(~?\w+)\s*\(", angles)
    return found.group(1) if found else None


# --- the figures ---------------------------------------------------------------------------------------------------

def street_figures(code):
    counts = sorted((len(paths), folder) for folder, paths in code.streets().items())
    numbers = [count for count, _ in counts]
    largest, folder = counts[-1]
    yield "folders of src with files", str(len(counts))
    yield "files a folder, median", f"{statistics.median(numbers):g}"
    yield "files a folder, largest", f"{largest} (`{folder}`)"


def methods(name, body):
    """(methods, private ones) that a class of this name declares in its body."""
    private, found = True, []
    for statement in statements(body):
        if statement in ("public", "private", "protected"):
            private = statement == "private"
            continue
        method = function_name(statement)
        if method and method.lstrip("~") != name and not re.search(r"= (default|delete)$", statement):
            found.append((method, private))
    return found


def class_figures(code):
    classes = []
    for path, text in code.text.items():
        for match in CLASS.finditer(text):
            kind, name = match.groups()
            found = methods(name, text[match.end():closing(text, match.end() - 1)])
            hidden = sum(private for _, private in found) if kind == "class" else 0
            classes.append((len(found), hidden, name, path, {method for method, _ in found}))
    classes.sort(key=lambda c: (-c[0], c[2], c[3]))
    more = sum(count > 15 for count, *_ in classes)
    yield "classes of more than 15 methods", f"{more} of {len(classes)}"
    for rank, (count, hidden, name, path, names) in enumerate(classes[:10], 1):
        define = re.compile(rf"\b{name}::({'|'.join(map(re.escape, names))})\s*\(")
        layer = os.sep.join(path.split(os.sep)[:2])
        in_files = {path} | {other for other in code.text if path.endswith(".h") and other.startswith(layer)
                             and define.search(code.text[other])}
        yield f"methods a class, largest {rank}", f"{count} (`{name}`, {hidden} private, {len(in_files)} files)"


def paragraphs(text):
    """The paragraphs, list items and long cells of tables of a Markdown text, without headings and code."""
    lines, fence, code = [], False, False
    for line in re.sub(r"<!--.*?-->", "", text, flags=re.S).splitlines() + [""]:
        bare = line.strip()
        if bare.startswith(("```", "~~~")):
            fence, bare = not fence, ""
        code = line.startswith("    ") and (code or not lines)
        item = re.match(r"([-*+]|\d+\.|>)\s+", bare)
        ends = fence or code or item or not bare or bare.startswith(("#", "|"))
        if ends and lines:
            yield " ".join(lines)
            lines = []
        if bare.startswith("|") and not fence:
            yield from (cell for cell in bare.split("|") if len(cell.split()) > LONG_CELL)
        elif not (fence or code or bare.startswith("#")) and bare:
            lines.append(bare[item.end():] if item else bare)


def sentences(text):
    """The sentences of a Markdown text, each a list of words."""
    for paragraph in paragraphs(text):
        plain = re.sub(r"``[^`]+``|`[^`]+`", "code", paragraph)
        plain = re.sub(r"!\[[^]]*\]\([^)]*\)|<[^>]+>", " ", plain)
        plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", plain)
        for sentence in re.split(r"(?<=[.!?])(?<!e\.g\.)(?<!i\.e\.)[)*_\"']*\s+(?=\W*[A-Z0-9]|\W*code\b)", plain):
            words = re.findall(r"[^\W_][\w'’.,/-]*", sentence)
            if words:
                yield words


def sentence_figures(root):
    paths = ["README.md"] + sorted(os.path.join("docs", name) for name in os.listdir(os.path.join(root, "docs")) if name.endswith(".md"))
    every = []
    for path in paths:
        lengths = [len(words) for words in sentences(read(root, path))]
        if lengths:
            every += lengths
            yield f"words a sentence, {path}", f"{statistics.mean(lengths):.1f} (longest {max(lengths)})"
    yield "words a sentence, all of these", f"{statistics.mean(every):.1f} (longest {max(every)})"


def margin_figures(code):
    outside = [path for path in code.text if not path.startswith(os.path.join("src", "exact") + os.sep)]
    count = {path: sum(int(n) >= LEAST_EXPONENT for n in MARGIN.findall(code.text[path])) for path in outside}
    yield "hexadecimal margins outside src/exact", f"{sum(count.values())} in {sum(n > 0 for n in count.values())} files"


def closing_parenthesis(text, opening):
    """Where the parenthesis that opens at `opening` closes."""
    depth = 0
    for match in re.compile(r"[()]").finditer(text, opening):
        depth += 1 if match.group() == "(" else -1
        if depth == 0:
            return match.start()
    return len(text)


def tried(text):
    """How many calls of exact::tried catch kUnsupported: those that name no other code."""
    calls = (text[m.start():closing_parenthesis(text, m.end() - 1)] for m in re.finditer(r"\bexact::tried\s*\(", text))
    return sum(not re.search(r",\s*ErrorCode::k(?!Unsupported)\w+\s*$", call) for call in calls)


def catch_figures(code):
    asking = trying = taking = 0
    where = set()
    for path, text in code.text.items():
        calls = tried(text)
        trying += calls
        where.update([path] if calls else [])
        for match in re.finditer(r"\bcatch\s*\(\s*const Error\s*&\s*\w*\s*\)\s*\{", text):
            body = text[match.end():closing(text, match.end() - 1)]
            if re.search(r"code\(\)\s*[!=]=\s*(ErrorCode::)?kUnsupported", body):
                asking += 1
                where.add(path)
            elif not re.search(r"\bthrow\b|\bfail\w*\(", body):
                taking += 1
    yield "catches of `kUnsupported`", f"{asking + trying} in {len(where)} files ({trying} by `exact::tried`)"
    yield "catches of any `Error` that throw none", str(taking)


def equal_name_figures(code):
    total, most = 0, (0, "")
    for folder, paths in code.streets().items():
        where = {}
        for path in paths:
            for name in anonymous_names(code.text[path]) if path.endswith(".cpp") else ():
                where.setdefault(name, set()).add(path)
        several = sum(len(found) > 1 for found in where.values())
        total, most = total + several, max(most, (several, folder))
    yield "equal names in anonymous namespaces of a folder", str(total) + (f" (most: {most[0]}, `{most[1]}`)" if total else "")


def anonymous_names(text):
    names = set()
    for match in re.finditer(r"\bnamespace\s*\{", text):
        for statement in statements(text[match.end():closing(text, match.end() - 1)]):
            defined = re.match(r"(?:template\s*<.*?>\s*)?(?:class|struct|enum(?: class)?|using)\s+(\w+)", statement)
            constant = re.match(r"(?:static |inline )*(?:constexpr|const|thread_local)\b[^=({]*?(\w+)\s*(?:\[[^]]*\])?\s*(?:=|\{)", statement)
            name = defined.group(1) if defined else function_name(statement) or constant and constant.group(1)
            if name:
                names.add(name)
    return names


# --- the preprocessor ----------------------------------------------------------------------------------------------

def compile_commands(root, build):
    """The commands of a build folder of Ninja, or None where there is none; of this checkout, though it may have been
    configured where it had another path (a bind mount, a container, a moved folder)."""
    found = [os.path.join(root, build)] if build else sorted(glob.glob(os.path.join(root, "build", "*")))
    folder = next((path for path in found if os.path.exists(os.path.join(path, "build.ninja"))), None)
    if folder is None:
        return None
    text = subprocess.run(["ninja", "-C", folder, "-t", "compdb"], capture_output=True, text=True, check=True).stdout
    return [{key: moved(value, configured_in(folder), os.path.abspath(root)) for key, value in command.items()}
            for command in json.loads(text)]


def configured_in(folder):
    """The checkout's path when CMake made the build folder; None where it does not say."""
    cache = os.path.join(folder, "CMakeCache.txt")
    if not os.path.exists(cache):
        return None
    with open(cache, encoding="utf-8") as file:
        match = re.search(r"^CMAKE_HOME_DIRECTORY:INTERNAL=(.+)$", file.read(), re.M)
    return match and match.group(1)


def moved(text, old, new):
    """The text with the path `old`, and what lies in it, at `new`."""
    if not old or old == new:
        return text
    return re.sub(re.escape(old) + r"(?=$|[/\s\"'])", lambda match: new, text)


def flags(commands, layer):
    """Compiler and flags of the layer's library, without output, input and precompiled header; that header; where to run."""
    entry = next(c for c in commands if f"findspace_{layer}.dir" in c["command"] and c["file"].endswith((".cpp", "_cxx.cxx")))
    # clang is given what its driver does not know word by word, each after -Xclang: the precompiled header as well.
    words = iter(word for word in shlex.split(entry["command"]) if word != "-Xclang")
    kept, header = [], None
    for word in words:
        if os.path.basename(word).startswith("ccache"):
            continue
        if word in WITH_VALUE:
            value = next(words)
            header = value if word == "-include" and value.endswith(PRECOMPILED) else header
        elif word not in ALONE:
            kept.append(word)
    return kept, header, entry["directory"]


def lines(command, folder, *included):
    """How many lines that are not empty the preprocessor makes of these files, one after the other."""
    text = "".join(f'#include "{path}"\n' for path in included)
    done = subprocess.run([*command, "-E", "-P", "-x", "c++", "-"], input=text, cwd=folder, capture_output=True, text=True, check=True)
    return sum(bool(line.strip()) for line in done.stdout.splitlines())


def preprocessor_figures(root, build):
    commands = compile_commands(root, build)
    if commands is None:
        yield "lines of the median file after the preprocessor", "no build folder"
        return
    sources = [path for path in files(root, "src") if path.endswith(".cpp")]
    step = max(1.0, len(sources) / SAMPLE)
    sample = [sources[int(k * step)] for k in range(min(SAMPLE, len(sources)))]
    whole, rest, brought = [], [], {}
    for source in sample:
        command, header, folder = flags(commands, source.split(os.sep)[1])
        path = os.path.abspath(os.path.join(root, source))
        whole.append(lines(command, folder, path))
        if header and header not in brought:
            brought[header] = lines(command, folder, header)
        rest.append(lines(command, folder, header, path) - brought[header] if header else whole[-1])
    yield "lines of the median file after the preprocessor", f"{statistics.median_high(whole):,}"
    yield "… of these after the precompiled header", f"{statistics.median_high(rest):,}"


# --- the table -----------------------------------------------------------------------------------------------------

def figures(root, options):
    code = Code(root)
    rows = [*street_figures(code), *class_figures(code), *sentence_figures(root), *margin_figures(code), *catch_figures(code),
            *equal_name_figures(code)]
    return dict(rows if options.no_preprocessing else rows + list(preprocessor_figures(root, options.build)))


def main(argv):
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].removeprefix("usage: "))
    parser.add_argument("root", nargs="?", default=ROOT)
    parser.add_argument("--compare")
    parser.add_argument("--build")
    parser.add_argument("--no-preprocessing", action="store_true")
    options = parser.parse_args(argv)
    columns = {"now": figures(options.root, options)}
    if options.compare:
        columns = {"before": figures(options.compare, options), **columns}
    print(f"| | {' | '.join(columns)} |\n|---|{'---|' * len(columns)}")
    for row in dict.fromkeys(row for column in columns.values() for row in column):
        print(f"| {row} | {' | '.join(column.get(row, '–') for column in columns.values())} |")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
