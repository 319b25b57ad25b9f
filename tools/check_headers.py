#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compiles every header that the public door (src/system/slam.h) reaches as a C++17 translation unit of its own.

ROS 1 messages do not compile as C++20, so what a ROS node includes must not ask for it; and a header that needs another
one to be included before it is no public header.
"""
import argparse
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
DOORS = ["system/slam.h"]


def reached(doors):
    """The doors and all headers of ours that they include, directly or not."""
    found, todo = [], list(doors)
    while todo:
        header = todo.pop()
        if header in found:
            continue
        found.append(header)
        with open(os.path.join(ROOT, "src", header), encoding="utf-8") as file:
            todo += re.findall(r'^\s*#\s*include\s*"([^"]+)"', file.read(), re.M)
    return sorted(found)


def include_flags():
    """Where the third parties are, as system headers: what they warn about is not ours."""
    folders = ["/usr/include/eigen3", "/usr/include/opencv4"]
    for package in ("eigen3", "opencv4"):
        answer = subprocess.run(["pkg-config", "--cflags-only-I", package], capture_output=True, text=True, check=False)
        folders += [word.removeprefix("-I") for word in answer.stdout.split()]
    return [flag for folder in dict.fromkeys(folders) if os.path.isdir(folder) for flag in ("-isystem", folder)]


def compile_header(header, flags):
    command = [os.environ.get("CXX", "c++"), "-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow",
               "-Werror", "-Wno-missing-field-initializers", "-I", os.path.join(ROOT, "src"), *flags, "-x", "c++", "-"]
    result = subprocess.run(command, input=f'#include "{header}"\n', capture_output=True, text=True, check=False)
    return header, result.returncode, result.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    headers, flags = reached(DOORS), include_flags()
    with ThreadPoolExecutor(parser.parse_args().jobs) as pool:
        results = list(pool.map(lambda header: compile_header(header, flags), headers))
    failed = [(header, message) for header, code, message in results if code]
    for header, message in failed:
        print(f"src/{header} does not compile by itself as C++17:\n{message}")
    print(f"headers: {len(headers) - len(failed)} of {len(headers)} public headers compile by themselves as C++17")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
