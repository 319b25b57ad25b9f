#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes configs/default.yaml from the options structs: the defaults and comments beside the fields, in the order of
their Visit. Run it after changing an option (a test compares the file with the built-in values)."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
FIELD = re.compile(r"^  (?:[\w:]+) (\w+)(?: = ([^;]*))?;\s*(?:///<\s*(.*))?$")
MORE = re.compile(r"^\s+///<?\s*(.*)$")
VISIT = re.compile(r'visit\("(\w+)", self\.\w+(, .*)?\);')
MEMBER = re.compile(r"^  (\w+) (\w+)(?: = (\w+)\(\))?;", re.M)
FUNCTION = re.compile(r"^inline \w+ (\w+)\(\) \{\n(.*?)^\}", re.M | re.S)
ASSIGNMENT = re.compile(r"^  options\.(\w+) = ([^;]*);", re.M)
STRUCT = re.compile(r"struct (\w+) \{\n(.*?)^\};", re.M | re.S)
WIDTH = 120
HEAD = """# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Every setting with its default, written by tools/write_default_config.py. This file is for reading: the program has
# the same values built in (a test holds the two together), and a file for `yorb run --config FILE` lists only what
# differs. A single setting: `--set key=value`, such as `--set features.wanted=1500`.

"""


def structs():
    """Name of each options struct to its text."""
    found = {}
    for header in sorted((ROOT / "src").glob("*/*.h")):
        for name, body in STRUCT.findall(header.read_text()):
            if "Visit(Self& self" in body:
                found[name] = body
    return found


def fields(body):
    """Name of each field to its type's default and comment."""
    found, last, above = {}, None, ""
    for line in body.splitlines():
        field, more, before = FIELD.match(line), MORE.match(line), re.match(r"^  /// (.*)$", line)
        if field:
            last = field.group(1)
            found[last] = [field.group(2), field.group(3) or above]
            above = ""
        elif before:
            above += (" " if above else "") + before.group(1)
        elif more and last and found[last][1]:
            found[last][1] += " " + more.group(1)
        else:
            last = None
    return found


def value(text):
    """A C++ default as YAML; strings have none where they begin empty."""
    if text is None:
        return '""'
    if text.startswith('"'):
        word = text.strip('"')
        return text if word in ("on", "off", "yes", "no") or not re.fullmatch(r"[A-Za-z_]+", word) else word
    return f"{float(text):g}" if re.fullmatch(r"-?\d+\.\d*", text) and len(text) < 8 else text


def entry(name, default, comment, indent):
    """One setting, its comment broken into lines beside it."""
    start = f"{indent}{name}: {value(default)}"
    column = max(28, len(start) + 2)
    lines, line = [], ""
    for word in comment.split():
        if line and column + 2 + len(line) + 1 + len(word) > WIDTH:
            lines.append(line)
            line = ""
        line += (" " if line else "") + word
    lines.append(line)
    text = start.ljust(column) + "# " + lines[0] + "\n"
    return text + "".join(" " * column + "# " + more + "\n" for more in lines[1:])


def main():
    known = structs()
    top = known["Config"]
    types = {name: (kind, maker) for kind, name, maker in MEMBER.findall(top)}
    makers = FUNCTION.findall((ROOT / "src/system/config.h").read_text())
    others = {maker: dict(ASSIGNMENT.findall(body)) for maker, body in makers}
    text = HEAD
    for name, constraint in VISIT.findall(top):
        if constraint:
            text += entry(name, *fields(top)[name], "")
            continue
        kind, maker = types[name]
        body, other = known[kind], others.get(maker, {})
        text += f"\n{name}:\n"
        for key, _ in VISIT.findall(body):
            default, comment = fields(body)[key]
            text += entry(key, other.get(key, default), comment, "  ")
    (ROOT / "configs" / "default.yaml").write_text(text)


if __name__ == "__main__":
    main()
