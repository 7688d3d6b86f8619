#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
# Programs of others (embed/) build with the library and do with it what `esm` does: the same motion to the last bit, and
# a mesh through the worker. The ways: find_package and pkg-config from an installed tree that was moved since, or the
# sources as a part of the other's build.
# usage: test_embed.sh package|pkgconfig|source CMAKE BUILD_FOLDER SOURCE_FOLDER CXX [LAUNCHER]
set -euo pipefail
way=$1 cmake=$2 build=$3 source=$4 cxx=$5 launcher=${6:-}
here=$source/tests/packaging
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
unset ESM_IMPORT_WORKER
cd "$tree"

quiet() { "$@" >log 2>&1 || { cat log; exit 1; }; }
install() {
  for part in development shared import_worker; do
    quiet "$cmake" --install "$build" --prefix "$tree/somewhere" --component $part
  done
  mv somewhere "$1"
}
make() { # FOLDER OPTION...: the programs of embed/ by CMake
  local folder=$1
  shift
  quiet "$cmake" -S "$here/embed" -B "$folder" -G Ninja -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" "$@"
  quiet "$cmake" --build "$folder" --target move look
}

esm=$build/bin/esm
"$esm" import "$source/resources/samples/fallopian_tube.obj" --unit mm -o tube.esm 2>/dev/null
"$esm" apply tube.esm -o tube.esm --fix-box "-1,-1,-1,0.002,1,1" --poke "0.028,0,0.0155,0,0,-0.08,0.005" 2>/dev/null
"$esm" simulate tube.esm --duration 0.1 --frames 60 --mesh expected.obj 2>/dev/null
check() { # FOLDER: its programs do what esm does
  rm -f shape.obj
  "$1/move" tube.esm shape.obj
  cmp shape.obj expected.obj
  [ "$("$1/look" "$here/triangle.ac")" = "1 triangles in $here/triangle.ac" ]
  echo "$way, $1: the same motion, and a mesh through the worker"
}

case $way in
package)
  install "else where"
  make static -DCMAKE_PREFIX_PATH="$tree/else where"
  check static
  make shared -DCMAKE_PREFIX_PATH="$tree/else where" -DBUILD_SHARED_LIBS=ON
  libraries=$(ldd shared/move) # not piped: a grep that ends at its first line would end ldd by a signal
  [[ $libraries == *libesm.so* ]] || { echo "the shared library is not what the program took: $libraries"; exit 1; }
  check shared
  # All public headers in one program, by themselves: none needs a file that is not installed, nor warns.
  (cd "else where"/include/esm-*/ && find . -name '*.h' | sed 's|^\./\(.*\)|#include "\1"|') >headers.cpp
  echo 'int main() { return *esm::version() == 0; }' >>headers.cpp
  [ "$(grep -c include headers.cpp)" -gt 30 ]
  export PKG_CONFIG_PATH=$(dirname "$(find "$tree/else where" -name esm.pc)")
  eval "$cxx -std=c++20 -Wall -Wextra -Werror -fsyntax-only headers.cpp $(pkg-config --cflags esm-meshimport)"
  ;;
pkgconfig)
  install "else where"
  export PKG_CONFIG_PATH=$(dirname "$(find "$tree/else where" -name esm.pc)")
  mkdir plain
  for program in move look; do
    # As a shell takes what pkg-config quotes.
    eval "$cxx -std=c++20 $here/embed/$program.cpp $(pkg-config --cflags --libs esm-meshimport) -o plain/$program"
  done
  export LD_LIBRARY_PATH=$(dirname "$PKG_CONFIG_PATH")
  check plain
  # Eigen frees a matrix in another way where a file is compiled for AVX: that shall not link rather than crash.
  if [ "$(uname -m)" = x86_64 ]; then
    echo 'int main() {}' | cat <(echo '#include "core/geometry/mesh.h"') - >other.cpp
    eval "$cxx -std=c++20 other.cpp $(pkg-config --cflags --libs esm) -o other"
    ! eval "$cxx -std=c++20 -mavx other.cpp $(pkg-config --cflags --libs esm) -o other" 2>log
    grep -q 'EigenMemory<32, 0>' log
  fi
  ;;
source)
  # All of core is compiled, without optimisation; kept, so that the next run compiles what has changed.
  make "$build/embed_source" -DESM_SOURCE="$source" -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=12
  check "$build/embed_source"
  ;;
esac
