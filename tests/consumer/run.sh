# SPDX-License-Identifier: MIT
# run.sh KIND CMAKE SOURCE BUILD GENERATOR COMPILER
# Builds and runs a project of somebody else's, outside this tree, that uses sspql in one of the ways a user may: see the
# cases at the end. Each with COMPILER and, where installed, clang++, as C++17 and as C++20.
set -eu
kind=$1 cmake=$2 source=$3 build=$4 generator=$5 compiler=$6
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp -R "$source/tests/consumer" "$scratch/projects"

for_each_compiler_and_standard() { # command, to which both are added
    for cxx in $(printf '%s\n' "$compiler" "$(command -v clang++ || :)" | sort -u); do
        for standard in 17 20; do
            echo "==== $kind: $cxx, C++$standard"
            "$@" "$cxx" "$standard"
        done
    done
}

# Installs to one prefix and moves it to another: the package must not remember where it was.
install_and_move() {
    "$cmake" --install "$build" --prefix "$scratch/first" >/dev/null
    mkdir "$scratch/moved"
    mv "$scratch/first" "$scratch/moved/prefix"
    prefix=$scratch/moved/prefix
}

# Somebody's warnings are errors, in our headers too.
configure() { # project, options
    project=$1
    shift
    rm -rf "$scratch/build"
    "$cmake" -S "$scratch/projects/$project" -B "$scratch/build" -G "$generator" -D CMAKE_BUILD_TYPE=Debug \
        -D CMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Werror" -D CMAKE_PREFIX_PATH="${prefix-}" "$@"
}

cmake_project() { # project, programs, options, compiler, standard
    configure "$1" $3 -D CMAKE_CXX_COMPILER="$4" -D CMAKE_CXX_STANDARD="$5"
    "$cmake" --build "$scratch/build"
    for program in $2; do
        "$scratch/build/$program"
    done
}

pkg_config_project() { # compiler, standard
    # Unquoted: the flags are words.
    "$1" "-std=c++$2" -Wall -Wextra -Wpedantic -Werror "$scratch/projects/main.cpp" \
        $(pkg-config --cflags --libs sspql) -o "$scratch/consumer"
    "$scratch/consumer"
}

# Builds the Debian package in $scratch/deb: not as root, and where we may say so without a network.
build_package() { # DEB_BUILD_OPTIONS
    as_nobody=
    mkdir -p "$scratch/deb"
    if [ "$(id -u)" -eq 0 ]; then
        as_nobody='runuser -u nobody --'
        if unshare --net true 2>/dev/null; then
            as_nobody="unshare --net $as_nobody"
        fi
        chmod a+x "$scratch"
        chown nobody "$scratch/deb"
    fi
    version=$(sed -n '1s/.*(\(.*\)).*/\1/p' "$source/debian/changelog")
    # A copy: nobody may be unable to read where we are.
    mkdir -p "$scratch/deb/source"
    tar -C "$source" --exclude=./build --exclude=./.git -c . | tar -C "$scratch/deb/source" -x --no-same-owner
    chmod -R a+rX "$scratch/deb/source"
    $as_nobody env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEB_BUILD_OPTIONS="$1" "$cmake" -D DEB_SOURCE="$scratch/deb/source" \
        -D DEB_DIR="$scratch/deb/out" -D VERSION="$version" -P "$scratch/deb/source/cmake/deb.cmake" >"$scratch/deb.log" 2>&1 ||
        { cat "$scratch/deb.log"; return 1; }
}

list_contents() {
    dpkg --contents "$scratch"/deb/out/*.deb
}

case $kind in
add_subdirectory)
    for_each_compiler_and_standard cmake_project add_subdirectory consumer "-D SSPQL_SOURCE=$source"
    ;;
fetch_content)
    # As the project's own repository would be fetched, from a copy that holds only what is under version control.
    git -C "$source" rev-parse >/dev/null 2>&1 || { echo "SKIP: no git repository"; exit 77; }
    git clone --quiet --no-hardlinks "$source" "$scratch/sspql"
    for_each_compiler_and_standard cmake_project fetch_content consumer "-D SSPQL_REPOSITORY=$scratch/sspql"
    ;;
find_package)
    install_and_move
    for_each_compiler_and_standard cmake_project find_package consumer -DCMAKE_DISABLE_FIND_PACKAGE_box2d=ON
    ;;
find_package_sim)
    install_and_move
    for_each_compiler_and_standard cmake_project find_package "consumer consumer_sim" "-D WITH_SIM=ON"
    ;;
missing_box2d) # asking for the simulation without Box2D names the package to install
    install_and_move
    if configure find_package -D CMAKE_CXX_COMPILER="$compiler" -D WITH_SIM=ON \
        -D CMAKE_DISABLE_FIND_PACKAGE_box2d=ON >"$scratch/log" 2>&1; then
        echo "sspql's component sim was found without Box2D"
        exit 1
    fi
    cat "$scratch/log"
    grep -q libbox2d-dev "$scratch/log"
    ;;
pkg_config)
    command -v pkg-config >/dev/null || { echo "SKIP: no pkg-config"; exit 77; }
    install_and_move
    export PKG_CONFIG_PATH="$prefix/share/pkgconfig"
    for_each_compiler_and_standard pkg_config_project
    ;;
deb) # built by nobody, offline and homeless; installed by dpkg into an empty root, used there, removed without a trace
    command -v dpkg-buildpackage >/dev/null || { echo "SKIP: no dpkg-buildpackage"; exit 77; }
    build_package nocheck
    list_contents | grep -q '/usr/share/doc/libsspql-dev/examples/01_first_steps.cpp$'
    list_contents | grep -q '/usr/share/doc/libsspql-dev/README.md$'
    if command -v lintian >/dev/null; then
        tags=$(TMPDIR=$scratch lintian --allow-root --pedantic --info --display-experimental "$scratch"/deb/out/*.changes)
        [ -z "$tags" ] || { printf 'lintian:\n%s\n' "$tags"; exit 1; }
    fi

    root=$scratch/root
    mkdir -p "$root/var/lib/dpkg/info" "$root/var/lib/dpkg/updates"
    : >"$root/var/lib/dpkg/status"
    dpkg_there() {
        dpkg --root="$root" --force-not-root --force-depends --log=/dev/null "$@"
    }
    files_there() {
        find "$root" ! -path "$root/var/lib/dpkg*" | sort
    }
    files_there >"$scratch/before"
    dpkg_there --install "$scratch"/deb/out/*.deb
    prefix=$root/usr
    for_each_compiler_and_standard cmake_project find_package "consumer consumer_sim" "-D WITH_SIM=ON"
    dpkg_there --purge libsspql-dev
    files_there | diff "$scratch/before" -

    build_package 'nocheck nodoc'
    if list_contents | grep '/usr/share/doc/libsspql-dev/.*\.\(md\|cpp\)$'; then
        echo "the package holds documentation in spite of nodoc"
        exit 1
    fi
    ;;
*)
    echo "unknown kind $kind"
    exit 1
    ;;
esac
