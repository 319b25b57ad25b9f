#!/bin/sh
# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause
# Runs all steps of `make check` but the release tests, the quick ones first, and stops at the first that fails.
set -eu
cd "$(dirname "$0")/.."
start=$(date +%s)
for step in format-check layers headers werror install-check asan tsan; do
  step_start=$(date +%s)
  echo "== make $step"
  make --no-print-directory "$step" || { echo "yorb: make $step failed" >&2; exit 1; }
  now=$(date +%s)
  echo "== make $step: done in $((now - step_start)) s, $((now - start)) s in all"
done
