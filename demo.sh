#!/bin/sh
# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause
# From a fresh Debian 12 to SLAM on a rendered sequence, its evaluation and a picture of both.
set -eu
cd "$(dirname "$0")"
tools/install_packages.sh
exec make --no-print-directory demo
