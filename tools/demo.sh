#!/bin/sh
# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause
# Renders a sequence, runs SLAM on it, evaluates, and names the pictures of both. Usage: tools/demo.sh YORB FOLDER
set -eu
yorb=$1 demo=$2
sequence=$demo/sequence

if [ -d "$sequence" ]; then
  echo "== The sequence is there already: $sequence"
else
  echo "== Rendering an RGB-D sequence with exact truth"
  rm -rf "$sequence.part"
  "$yorb" synth halfsphere --out "$sequence.part" --frames 300 --seed 1
  mv "$sequence.part" "$sequence"
fi

echo "== SLAM: $yorb run $sequence --out $demo/run"
"$yorb" run "$sequence" --out "$demo/run"

echo "== Evaluation: $yorb eval --reference $sequence/groundtruth.txt --estimate $demo/run/trajectory.txt"
"$yorb" eval --reference "$sequence/groundtruth.txt" --estimate "$demo/run/trajectory.txt" --sequence "$sequence" \
  --plot "$demo/trajectory.svg"

here=$(cd "$demo" && pwd)
echo "== Done. Open in a browser:"
echo "report:  $here/run/report.html"
echo "picture: $here/trajectory.svg"
