#!/bin/sh
# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause
# Installs a build into an empty prefix, looks at what is there, and builds and runs a C++17 program against it.
# Usage: tools/check_install.sh BUILD_FOLDER SCRATCH_FOLDER
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$1 scratch=$2
fail() { echo "yorb: $*" >&2; exit 1; }

rm -rf "$scratch"
mkdir -p "$scratch/elsewhere"
prefix=$(cd "$scratch" && pwd)/prefix
cmake --install "$build" --prefix "$prefix" >"$scratch/install.log" || fail "installing failed; see $scratch/install.log"

for file in bin/yorb include/yorb/system/slam.h include/yorb/core/result.h lib/cmake/yorb/yorbConfig.cmake \
            lib/libyorb_system.a lib/yorb/yorb_codecs.so share/yorb/configs/default.yaml share/doc/yorb/LICENSE; do
  [ -e "$prefix/$file" ] || fail "the installation lacks $file"
done
[ "$(find "$prefix/bin" -type f | wc -l)" -eq 1 ] || fail "the installation has other programs than yorb"
checkout=$(dirname "$here")
! grep -rIl "$checkout" "$prefix" || fail "the installation names the folder it was built in"

# Moved to another place, it still works.
mv "$prefix" "$scratch/elsewhere/prefix"
prefix=$(cd "$scratch/elsewhere/prefix" && pwd)
cmake -S "$here/consumer" -B "$scratch/consumer" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Debug >"$scratch/consumer.log" ||
  fail "find_package(yorb) failed; see $scratch/consumer.log"
cmake --build "$scratch/consumer" || fail "a C++17 program does not build against the installation"
"$scratch/consumer/consumer" || fail "a program built against the installation fails"
# The installed program finds its cameras from its own place, whatever the current folder.
sequence=$(cd "$scratch" && pwd)/sequence
(cd / && "$prefix/bin/yorb" synth xyz --frames 3 --camera tum_fr1 --out "$sequence" --quiet &&
  "$prefix/bin/yorb" run "$sequence" --camera tum_fr1 --mode inline --out "$sequence/run" --quiet) ||
  fail "the installed program does not run"
[ "$(grep -vc '^#' "$sequence/run/trajectory.txt")" -eq 3 ] || fail "the installed program did not track three frames"
printf 'P6 2 2 255\n            ' >"$scratch/picture.ppm"  # neither PNG nor JPEG: read by the module
"$prefix/bin/yorb" detect "$scratch/picture.ppm" --json >/dev/null 2>&1 || fail "the installed program does not find its module"
echo "install: a C++17 program found, compiled and linked the installed libraries"
