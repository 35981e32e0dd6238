#!/usr/bin/env bash
# Installs what is missing (Debian packages) and builds Release into build/. Sourced by quickstart.sh and tests/run.sh:
#   build_regolab [extra cmake arguments] -- [targets]
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

packages=(g++ cmake ninja-build ccache mold
  libgrpc-dev libgrpc++-dev protobuf-compiler protobuf-compiler-grpc libprotobuf-dev libsqlite3-dev libeigen3-dev
  libspdlog-dev libfmt-dev libgtest-dev libgmock-dev libyaml-cpp-dev libudunits2-dev libcli11-dev nlohmann-json3-dev
  libboost-dev libnlopt-cxx-dev librandom123-dev libssl-dev)

install_missing() {
  local missing
  missing=$(for p in "${packages[@]}"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$p" 2>/dev/null)" = installed ] || echo "$p"
  done)
  [ -z "$missing" ] && return 0
  local sudo=
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null || { echo "missing packages (not root and no sudo) install them: $(echo $missing)" >&2; return 1; }
    sudo=sudo
  fi
  # shellcheck disable=SC2086,SC2116
  echo "installing: $(echo $missing)" >&2
  $sudo apt-get update -qq >&2 || return 1
  # shellcheck disable=SC2086
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >&2
}

build_regolab() {
  local options=()
  while [ $# -gt 0 ] && [ "$1" != -- ]; do options+=("$1"); shift; done
  [ "${1:-}" = -- ] && shift
  cmake -S "$root" -B "$root/build" -G Ninja -DCMAKE_BUILD_TYPE=Release ${options[@]+"${options[@]}"} >/dev/null || return 1
  cmake --build "$root/build" --parallel "$(nproc)" ${1:+--target "$@"}
}
