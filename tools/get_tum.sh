#!/bin/sh
# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause
# Downloads and unpacks sequences of TUM's RGB-D benchmark (CC BY 4.0; some 300 MB to 1.3 GB each).
# Usage: tools/get_tum.sh [--to FOLDER] NAME...
#   NAME: fr3_walking_xyz, or rgbd_dataset_freiburg3_walking_xyz in full; `people` stands for the seven of fr3 with people.
# What is there already is left alone; an interrupted download goes on where it ended.
# Written from the addresses that the benchmark names; it could not be tried where it was written. Where they have moved,
# set YORB_TUM_URL to the folder that holds freiburg1/, freiburg2/ and freiburg3/.
set -eu
url=${YORB_TUM_URL:-https://cvg.cit.tum.de/rgbd/dataset}
people='walking_xyz walking_halfsphere walking_rpy walking_static sitting_xyz sitting_halfsphere sitting_static'
folder=.

refuse() {
  echo "get_tum.sh: $1" >&2
  exit 2
}

usage() {
  sed -n '4,10s/^# //p' "$0"
}

# The full name of a sequence.
full_name() {
  case $1 in
    rgbd_dataset_freiburg[123]_?*) echo "$1" ;;
    fr[123]_?*) echo "rgbd_dataset_freiburg${1#fr}" ;;
    *) refuse "$1 is no sequence of TUM's; names look like fr3_walking_xyz" ;;
  esac
}

download() {
  if command -v curl >/dev/null 2>&1; then
    curl --fail --location --retry 3 --continue-at - --output "$2" "$1"
  elif command -v wget >/dev/null 2>&1; then
    wget --continue --tries 3 --output-document "$2" "$1"
  else
    refuse "neither curl nor wget is installed; apt-get install curl"
  fi
}

get() {
  name=$1
  number=${name#rgbd_dataset_freiburg}
  number=${number%%_*}
  if [ -d "$folder/$name" ]; then
    echo "$folder/$name is there already"
    return
  fi
  archive=$folder/$name.tgz
  download "$url/freiburg$number/$name.tgz" "$archive.part" || {
    echo "get_tum.sh: $url/freiburg$number/$name.tgz could not be downloaded; is the name right?" >&2
    exit 1
  }
  mv "$archive.part" "$archive"
  rm -rf "$folder/.$name.part"
  mkdir -p "$folder/.$name.part"
  tar -xzf "$archive" -C "$folder/.$name.part" || {
    echo "get_tum.sh: $archive cannot be unpacked; remove it and try again" >&2
    exit 1
  }
  mv "$folder/.$name.part/$name" "$folder/$name"
  rmdir "$folder/.$name.part"
  rm "$archive"
  echo "$folder/$name"
}

[ $# -gt 0 ] || { usage >&2; exit 2; }
case $1 in
  -h | --help) usage; exit 0 ;;
  --to)
    [ $# -ge 3 ] || refuse "--to needs a folder and names"
    folder=$2
    shift 2
    mkdir -p "$folder"
    ;;
esac
names=
for word in "$@"; do
  if [ "$word" = people ]; then
    for one in $people; do names="$names rgbd_dataset_freiburg3_$one"; done
  else
    one=$(full_name "$word")
    names="$names $one"
  fi
done
for one in $names; do get "$one"; done
