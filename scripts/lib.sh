# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
# Shared by run.sh, test.sh and .ci/run: what to install, how to build. Sourced, not run.

esm_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

esm_say() { printf '\033[1m== %s\033[0m\n' "$*"; }
esm_die() { printf 'error: %s\n' "$*" >&2; exit 1; }

# What building and running need, what testing needs besides, what only the checks of .ci/run need.
esm_build_packages=(g++ cmake ninja-build ccache libeigen3-dev libassimp-dev zlib1g-dev libcli11-dev nlohmann-json3-dev
  qt6-base-dev libqt6opengl6-dev qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-translations-l10n libgl-dev
  libqcustomplot-dev libgl1-mesa-dri libmeshoptimizer-dev libcoin-dev libusb-1.0-0-dev libgtest-dev libgmock-dev libbenchmark-dev python3)
esm_show_packages=(xvfb xauth fonts-dejavu-core)
esm_test_packages=(libfuzzylite-dev python3-jsonschema xdotool imagemagick x11-apps assimp-utils locales git
  tetgen gmsh python3-vtk9 pkg-config libumockdev-dev umockdev qemu-system-x86 busybox-static) # driven by tests, or compared with
esm_bench_packages=(libfuzzylite-dev libsundials-dev libsuitesparse-dev libopenblas0-serial python3-matplotlib
  calculix-ccx python3-numpy) # competitors, pictures, the finite-element reference
esm_check_packages=(clang-format clang-tidy clang libclang-rt-14-dev) # the last two for libFuzzer

# Installs those of the named packages that are missing; says what it does; quiet and quick when there is nothing to do.
esm_install() {
  local missing=() package
  for package in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  local sudo=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || esm_die "missing packages: ${missing[*]}; run this as root, or install sudo"
    sudo=(sudo)
  fi
  command -v apt-get >/dev/null || esm_die "this needs Debian 12 or a relative of it (apt-get); install by hand: ${missing[*]}"
  esm_say "Installing ${#missing[@]} packages: ${missing[*]}"
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
}

# esm_build PRESET [TARGET...]: configures if need be, builds, shows ninja's progress.
esm_build() {
  local preset=$1
  shift
  # The same object for the same source, whichever checkout it lies in.
  export CCACHE_NOHASHDIR=1 CCACHE_BASEDIR=$esm_root
  if [ ! -f "$esm_root/build/$preset/build.ninja" ]; then
    esm_say "Configuring ($preset)"
    (cd "$esm_root" && cmake --preset "$preset" >"/tmp/esm-configure.$$" 2>&1) ||
      { cat "/tmp/esm-configure.$$"; rm -f "/tmp/esm-configure.$$"; esm_die "configuring failed"; }
    rm -f "/tmp/esm-configure.$$"
  fi
  esm_say "Building ($preset)"
  cmake --build "$esm_root/build/$preset" ${1:+--target "$@"}
}
