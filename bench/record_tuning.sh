#!/bin/sh
# SPDX-License-Identifier: MIT
# record_tuning.sh BUILD OUT [SEEDS]: makes the pictures of docs/tune.md and writes them to OUT, with the numbers they show
# in tune.txt: copy the pictures to docs/images/. BUILD is a build tree (build/release). A few minutes on two cores with 40
# seeds.
set -eu
mkdir -p "$2"
"$1/bench/tuning_pictures" --out "$2" --seeds "${3:-40}" >"$2/tune.txt"
echo "The pictures: $2/tune-*.svg, their numbers: $2/tune.txt"
