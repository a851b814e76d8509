# SPDX-License-Identifier: MIT
# install.sh BUILD EXTRACTED CMAKE GENERATOR COMPILER: the project that docs/install.md shows finds the installed
# library, builds and runs. EXTRACTED is what extract.awk made of the pages.
set -eu
build=$1 extracted=$2 cmake=$3 generator=$4 compiler=$5
scratch=$build/docs/install
rm -rf "$scratch"
mkdir -p "$scratch/project"

"$cmake" --install "$build" --prefix "$scratch/prefix" >/dev/null
cp "$extracted/files/CMakeLists.txt" "$extracted/files/my_robot.cpp" "$scratch/project/"
cd "$scratch/project"
"$cmake" -S . -B build -G "$generator" -D CMAKE_CXX_COMPILER="$compiler" -D CMAKE_BUILD_TYPE=Release \
    -D CMAKE_PREFIX_PATH="$scratch/prefix"
"$cmake" --build build --config Release
build/my_robot | tee "$scratch/printed"
grep -q 'is here, with 10 states' "$scratch/printed"
