#!/bin/sh
# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause
# clang-tidy by .clang-tidy over all sources but tests and benchmarks. Usage: tools/tidy.sh BUILD_FOLDER JOBS
set -eu
cd "$(dirname "$0")/.."
find src apps -name '*.cc' ! -name '*_test.cc' ! -name '*_bench.cc' -print0 | sort -z |
  xargs -0 -n 1 -P "$2" clang-tidy-14 --quiet -p "$1"
