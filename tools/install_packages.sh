#!/bin/sh
# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing of tools/packages.txt, and touches nothing where nothing is missing.
# Usage: tools/install_packages.sh [GROUP]     GROUP "check" adds the packages of `make check`, "train" those of yorb-train.
set -eu
group=${1:-}
list=$(dirname "$0")/packages.txt

if ! command -v dpkg-query >/dev/null 2>&1; then
  echo "yorb: this is no Debian; install the counterparts of $list by hand where the build misses them" >&2
  exit 0
fi

missing=
while read -r package for_group; do
  case $package in '' | '#'*) continue ;; esac
  [ -z "$for_group" ] || [ "$for_group" = "$group" ] || continue
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing="$missing $package"
done <"$list"
[ -n "$missing" ] || exit 0

if [ "$(id -u)" -eq 0 ]; then
  as_root=
elif command -v sudo >/dev/null 2>&1; then
  as_root=sudo
else
  echo "yorb: packages are missing, and there is neither root nor sudo to install them; as root: apt-get install$missing" >&2
  exit 1
fi

echo "Installing Debian packages:$missing"
apt() {
  # Standard input is closed: a question would stop an unattended run.
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get -y -o Acquire::Retries=3 -o Dpkg::Use-Pty=0 "$@" </dev/null
}
# shellcheck disable=SC2086  # one word a package
if ! { apt -q update && apt -q install --no-install-recommends $missing; }; then
  echo "yorb: apt-get could not install$missing; see its message above" >&2
  exit 1
fi
