# SPDX-License-Identifier: MIT
# run.sh KIND CMAKE SOURCE BUILD GENERATOR COMPILER
# Builds and runs a project of somebody else's that uses sspql in one of the ways a user may: see the cases at the end.
set -eu
kind=$1 cmake=$2 source=$3 build=$4 generator=$5 compiler=$6
here=$source/tests/consumer
scratch=$build/consumer/$kind
rm -rf "$scratch"
mkdir -p "$scratch"

# Installs to one prefix and moves it to another: the package must not remember where it was.
install_and_move() {
    "$cmake" --install "$build" --prefix "$scratch/first" >/dev/null
    mkdir "$scratch/moved"
    mv "$scratch/first" "$scratch/moved/prefix"
}

configure() { # project, options
    project=$1
    shift
    "$cmake" -S "$here/$project" -B "$scratch/build" -G "$generator" -D CMAKE_CXX_COMPILER="$compiler" \
        -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH="$scratch/moved/prefix" "$@"
}

build_and_run() { # programs
    "$cmake" --build "$scratch/build" --config Release
    for program in "$@"; do
        "$scratch/build/$program"
    done
}

case $kind in
add_subdirectory)
    configure add_subdirectory -D SSPQL_SOURCE="$source"
    build_and_run consumer
    ;;
find_package)
    install_and_move
    configure find_package -D CMAKE_DISABLE_FIND_PACKAGE_box2d=ON
    build_and_run consumer
    ;;
find_package_sim)
    install_and_move
    configure find_package -D WITH_SIM=ON
    build_and_run consumer consumer_sim
    ;;
missing_box2d) # asking for the simulation without Box2D names the package to install
    install_and_move
    if configure find_package -D WITH_SIM=ON -D CMAKE_DISABLE_FIND_PACKAGE_box2d=ON >"$scratch/log" 2>&1; then
        echo "sspql's component sim was found without Box2D"
        exit 1
    fi
    cat "$scratch/log"
    grep -q libbox2d-dev "$scratch/log"
    ;;
pkg_config)
    command -v pkg-config >/dev/null || { echo "SKIP: no pkg-config"; exit 77; }
    install_and_move
    PKG_CONFIG_PATH=$scratch/moved/prefix/share/pkgconfig
    export PKG_CONFIG_PATH
    # Unquoted: the flags are words.
    "$compiler" -std=c++17 "$here/main.cpp" $(pkg-config --cflags --libs sspql) -o "$scratch/consumer"
    "$scratch/consumer"
    ;;
*)
    echo "unknown kind $kind"
    exit 1
    ;;
esac
