#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the sources obey src/LAYERS and the rules of CONTRIBUTING.md that a script can see.

Rooms include upwards only; third parties and threads stay in their rooms; libraries do not print, exit or read the
environment; files keep their lengths and their licence lines; CMake says what the includes say.
Usage: tools/check_layers.py [ROOT]      exit 0: all is well; 1: one line a complaint on standard output.
"""
import os
import re
import sys
from dataclasses import dataclass, field

HEADER_LINES, SOURCE_LINES = 150, 400
CODE = (".h", ".cc")
LICENSED = CODE + (".py", ".sh", ".cmake", ".txt", ".yaml", ".yml", ".supp")
LICENSED_NAMES = ("Makefile", "run", ".clang-tidy", ".clang-format")
# Headers that only tests and benchmarks may include: src/*/test_*.h and src/*/*_oracle.h.
TEST_HEADERS = r"src/\w+/(test_\w+|\w+_oracle)\.h"
TESTS = r".*_(test|bench)\.cc|tests/.*|" + TEST_HEADERS
LOCKS = r"src/core/(channel|latest|parallel|prefetch)\.h|src/core/log\.cc|src/system/(pipeline\w*|frame_log)\.(h|cc)|src/viewer/.*"
LOCKS_STAY = "core/{channel,latest,parallel,prefetch}.h, core/log.cc, system/{pipeline*,frame_log}.*"
PACING = r"src/runs/feed\.cc"  # the live player keeps the pace of the time stamps

# Third parties and the files that may include them: (what, pattern of the include, pattern of the files, where instead).
GUESTS = [
    ("spdlog", r"(spdlog|fmt)/", r"src/core/log\.cc", "core/log.cc; log through core/log.h"),
    ("YAML", r"yaml-cpp/", r"src/camera/camera_io\.cc|src/datasets/class_list\.cc|src/system/config_io\.cc",
     "camera/camera_io.cc, datasets/class_list.cc and system/config_io.cc"),
    ("OpenCV", r"opencv2/", r"(?!src/(core|geometry|map|optimize|places)/).*",
     "rooms that see pictures; not in core, geometry, map, optimize, places"),
    ("OpenCV's codecs", r"opencv2/(imgcodecs|videoio)", r"src/pictures/(opencv_formats/.*|\w+_test\.cc)",
     "src/pictures/opencv_formats, a module: linked to, they cost every start 60 MB; pictures/picture_file.h reads and writes"),
    ("libpng and libjpeg", r"(png|jpeglib|jerror)\.h", r"src/pictures/\w+\.cc", "src/pictures; pictures/picture_file.h reads and writes"),
    ("nlohmann-json", r"nlohmann/", r"(src/(system|detection|datasets|evaluation|runs|experiments)|apps|tests)/.*",
     "system, detection, datasets, evaluation, runs, experiments, apps"),
    ("CLI11", r"CLI/", r"(apps|training)/.*", "apps and training"),
    ("libtorch", r"(torch|ATen|c10)/", r"training/.*", "training"),
    ("the ONNX protobuf", r"onnx/", r"training/.*", "training"),
    ("Ceres", r"ceres/", r"src/optimize/.*_(test|bench)\.cc|" + TEST_HEADERS, "the tests and benchmarks of optimize (it is an oracle)"),
    ("the inference engine", r"(opencv2/dnn|xnnpack\.h|pthreadpool\.h|onnxruntime)", r"src/detection/.*\.cc|training/.*_test\.cc", "src/detection/*.cc; detectors stand behind detection/detector.h"),
    ("GoogleTest", r"(gtest|gmock)/", TESTS, "*_test.cc"),
    ("Google Benchmark", r"benchmark/", r".*_bench\.cc|bench/.*", "*_bench.cc"),
    ("threads", r"(mutex|shared_mutex|thread|atomic|condition_variable|future|semaphore|latch|barrier|stop_token|pthread\.h)$",
     LOCKS + "|" + PACING + "|" + TESTS, LOCKS_STAY),
]

# Words that a library (all below src/) must not say: (pattern, files where it may stand, the complaint).
WORDS = [
    (r"\bstd::(mutex|recursive_mutex|shared_mutex|thread|jthread|atomic\w*|condition_variable\w*|async|future|call_once)\b",
     LOCKS + "|" + TESTS, "threads and locks stay in " + LOCKS_STAY),
    (r"\b(usleep|nanosleep|sleep_for|sleep_until)\b", PACING + "|" + TESTS,
     "no sleeping and no polling: wait on a Channel (only the live player keeps a pace)"),
    (r"\bstd::(cout|cerr|clog)\b|\b(printf|puts|putchar)\s*\(|\bfprintf\s*\(\s*std(out|err)",
     r"src/core/(check|log)\.cc|" + TESTS, "libraries never print: log through core/log.h"),
    (r"(?<![\w.>])(exit|_exit|_Exit|quick_exit|abort)\s*\(", r"src/core/check\.cc|" + TESTS,
     "libraries never exit: give back a Result, or YORB_CHECK an invariant"),
    (r"\b(secure_)?getenv\s*\(", TESTS, "libraries never read the environment"),
    (r"\bstd::(random_device|mt19937\w*|default_random_engine|rand)\b|(?<![\w.:])s?rand\s*\(", TESTS,
     "chance comes from core/random.h, seeded from the config"),
    (r"\b(TODO|FIXME|XXX)\b", r"$^", "no notes to oneself in the sources"),
]


@dataclass
class Layers:
    """The rooms of src/LAYERS and the line that each stands on."""
    line_of: dict = field(default_factory=dict)

    def may_include(self, room, other):
        return room == other or self.line_of[other] < self.line_of[room]


def read_layers(root, complaints):
    layers = Layers()
    with open(os.path.join(root, "src/LAYERS"), encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            if not line.strip() or line.startswith("#"):
                continue
            *rooms, meaning = re.split(r"\s{2,}|\t", line.rstrip("\n"))
            if not rooms or not meaning:
                complaints.append(f"src/LAYERS:{number}: a line is 'room [room ...]   meaning', with wide gaps between")
                continue
            for room in rooms:
                if room in layers.line_of:
                    complaints.append(f"src/LAYERS:{number}: the room {room} stands here twice")
                layers.line_of[room] = number
    return layers


def files_under(root):
    """All files of the project, relative to the root, without build outputs and hidden folders but .ci and .github."""
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(f for f in folders if (not f.startswith(".") or f in (".ci", ".github")) and f != "__pycache__"
                            and not (folder == root and (f == "build" or f.startswith("yorb_"))))
        for name in sorted(names):
            yield os.path.relpath(os.path.join(folder, name), root)


def without_comments_and_texts(line):
    line = re.sub(r'"(\\.|[^"\\])*"', '""', line)
    return re.sub(r"//.*", "", line)


def room_of(path):
    parts = path.split("/")
    return parts[1] if parts[0] == "src" and len(parts) > 2 else None


def check_include(root, layers, path, name, is_quoted, where):
    room, other = room_of(path), name.split("/")[0]
    if is_quoted and other in layers.line_of:
        if not os.path.exists(os.path.join(root, "src", name)):
            yield f"{where}: src/{name} does not exist"
        if re.fullmatch(TEST_HEADERS, "src/" + name) and not re.fullmatch(TESTS, path):
            yield f"{where}: src/{name} is for tests and benchmarks alone"
        if room and not layers.may_include(room, other):
            way = "sideways" if layers.line_of[room] == layers.line_of[other] else "down"
            yield (f"{where}: {room} includes {way} into {other}; move what both need to a room above "
                   "(or make it a message in map/event.h)")
    elif is_quoted and other in ("apps", "tests", "training"):
        if not path.startswith(other + "/"):
            yield f"{where}: {other} is below every room and is included by itself alone"
    elif is_quoted:
        yield f'{where}: "{name}" is of no room; third parties stand in <>, our headers begin with their room'
    else:
        for guest, pattern, files, instead in GUESTS:
            if re.match(pattern, name) and not re.fullmatch(files, path):
                yield f"{where}: {guest} stays in {instead}"


def check_code(root, layers, path, lines):
    """Includes, forbidden words and length of one source file."""
    for number, line in enumerate(lines, 1):
        where = f"{path}:{number}"
        include = re.match(r'\s*#\s*include\s*(["<])([^">]+)[">]', line)
        if include:
            yield from check_include(root, layers, path, include[2], include[1] == '"', where)
            continue
        code = without_comments_and_texts(line)
        for pattern, files, complaint in WORDS:
            text = line if "TODO" in pattern else code
            if path.startswith("src/") and re.search(pattern, text) and not re.fullmatch(files, path):
                yield f"{where}: {complaint}"
    limit = HEADER_LINES if path.endswith(".h") else SOURCE_LINES
    if len(lines) > limit:
        yield f"{path}:{limit + 1}: {len(lines)} lines, the limit is {limit}; split it by idea"


def check_licence(path, lines):
    name = os.path.basename(path)
    if not (name.endswith(LICENSED) or name in LICENSED_NAMES):
        return
    top = "".join(lines[:3])
    for word in ("SPDX-FileCopyrightText: ", "SPDX-License-Identifier: BSD-3-Clause"):
        if word not in top:
            yield f"{path}:1: the two SPDX lines are missing at the top (copy them from a neighbour)"
            return


def room_calls(text):
    """Of each yorb_room(...): name, line, {keyword: [targets]}."""
    for call in re.finditer(r"^yorb_room\(\s*(\w+)([^)]*)\)", text, re.M):
        words, deps, key = re.sub(r"#.*", "", call[2]).split(), {"DEPS": [], "TEST_DEPS": [], "BENCH_DEPS": []}, "DEPS"
        for word in words:
            if word in deps:
                key = word
            else:
                deps[key].append(word)
        yield call[1], text.count("\n", 0, call.start()) + 1, deps


def check_room_cmake(layers, room, path, text, deps_of):
    for name, number, deps in room_calls(text):
        where = f"{path}:{number}"
        if name != room:
            yield f"{where}: yorb_room({name}) stands in the folder of {room}"
        deps_of[room] = deps
        for key, targets in deps.items():
            for target in targets:
                other = target.removeprefix("yorb_")
                if target.startswith("yorb_") and other not in layers.line_of:
                    yield f"{where}: {key} names {target}, and src/LAYERS knows no room {other}"
                elif target.startswith("yorb_") and not layers.may_include(room, other):
                    yield f"{where}: {key} names {target}, which is not above {room} in src/LAYERS"
                elif target.startswith("Ceres") and (room != "optimize" or key == "DEPS"):
                    yield f"{where}: Ceres is for TEST_DEPS and BENCH_DEPS of optimize alone"
                elif target.startswith("opencv_") and key == "DEPS" and room in ("core", "geometry", "map", "optimize", "places"):
                    yield f"{where}: {room} does without OpenCV"
    if room not in deps_of:
        yield f"{path}:1: the folder's CMakeLists.txt does not call yorb_room({room} ...)"


def reachable(room, deps_of):
    seen, todo = set(), [room]
    while todo:
        for target in deps_of.get(todo.pop(), {"DEPS": []})["DEPS"]:
            other = target.removeprefix("yorb_")
            if target.startswith("yorb_") and other not in seen:
                seen.add(other)
                todo.append(other)
    return seen


def check_cmake(root, layers, includes):
    """CMake's idea of the rooms against LAYERS and against what the sources include."""
    deps_of = {}
    for room in sorted(layers.line_of):
        path = f"src/{room}/CMakeLists.txt"
        if os.path.exists(os.path.join(root, path)):
            with open(os.path.join(root, path), encoding="utf-8") as file:
                yield from check_room_cmake(layers, room, path, file.read(), deps_of)
        elif os.path.isdir(os.path.join(root, "src", room)):
            yield f"src/{room}: the room has no CMakeLists.txt"
    for (room, other, kind), where in sorted(includes.items()):
        targets = deps_of.get(room, {}).get(kind, []) if kind != "DEPS" else []
        near = {t.removeprefix("yorb_") for t in targets}
        known = near | reachable(room, deps_of) | {r for n in near for r in reachable(n, deps_of)}
        if room in deps_of and other != room and other in layers.line_of and other not in known:
            yield f"{where}: includes {other}, and {kind} in src/{room}/CMakeLists.txt does not lead to yorb_{other}"


def check_tree(root):
    """All complaints about the tree, in the order of the files."""
    complaints, includes = [], {}
    layers = read_layers(root, complaints)
    for path in files_under(root):
        if not (path.endswith(LICENSED) or os.path.basename(path) in LICENSED_NAMES):
            continue
        with open(os.path.join(root, path), encoding="utf-8") as file:
            lines = file.read().splitlines(keepends=True)
        complaints += check_licence(path, lines)
        if not path.endswith(CODE):
            continue
        room = room_of(path)
        if room and room not in layers.line_of:
            complaints.append(f"{path}:1: the room {room} is not in src/LAYERS; add it where it belongs")
            continue
        complaints += check_code(root, layers, path, lines)
        kind = "TEST_DEPS" if path.endswith("_test.cc") or re.fullmatch(TEST_HEADERS, path) else "BENCH_DEPS" if path.endswith("_bench.cc") else "DEPS"
        for number, line in enumerate(lines, 1):
            include = re.match(r'#include "(\w+)/', line)
            if include and room:
                includes.setdefault((room, include[1], kind), f"{path}:{number}")
    complaints += check_cmake(root, layers, includes)
    return complaints


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    complaints = check_tree(os.path.normpath(root))
    for complaint in complaints:
        print(complaint)
    if complaints:
        print(f"{len(complaints)} complaints; the rules stand in src/LAYERS and CONTRIBUTING.md", file=sys.stderr)
        return 1
    print("layers: all is well")
    return 0


if __name__ == "__main__":
    sys.exit(main())
