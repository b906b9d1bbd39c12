#!/usr/bin/env bash
# Builds the image and draws a map in it as the Dockerfile promises: no network, a root that cannot be
# written, a user whom the image does not know; with a cache and without. Prints what it found.
#
#   containers/check.sh [BASE]      debian:12 unless another is named, as ubuntu:24.04
#
# Environment:
#   ENGINE    docker unless another is named, as "podman --runtime runc"; split at blanks
#   OPTIONS   more options for build and run, as "--ulimit nofile=4096:4096"; split at blanks
#   BUILD     more options for build alone, as "--network host"; split at blanks
set -euo pipefail

base=${1:-debian:12}
read -ra engine <<<"${ENGINE:-docker}"
read -ra options <<<"${OPTIONS:-}"
read -ra build <<<"${BUILD:-} ${OPTIONS:-}"
readonly user=1234 image=sunbeam-check
home=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 777 "$work"

stop() {
    printf 'containers/check.sh: %s\n' "$*" >&2
    exit 1
}

run() { # options of the engine, --, arguments of Sunbeam
    local own=()
    while [[ $1 != -- ]]; do own+=("$1") && shift; done
    "${engine[@]}" run --rm --read-only --network none --tmpfs /tmp:mode=1777 --user $user:$user -v "$work:/work" \
        ${options[@]+"${options[@]}"} ${own[@]+"${own[@]}"} $image "${@:2}"
}

"${engine[@]}" build ${build[@]+"${build[@]}"} -f "$home/containers/Dockerfile" --build-arg "BASE=$base" \
    -t $image "$home"

[[ $(run --entrypoint id -- -u) == "$user" ]] || stop "the user is not $user"
[[ $(run --entrypoint ls -- /sys/class/net) == lo ]] || stop "there is a network"
if run --entrypoint touch -- /opt/written 2>/dev/null; then stop "the root can be written"; fi

run -- brdf-map --patch blaze --output without-cache.png
run --tmpfs /cache:mode=1777 -- brdf-map --patch blaze --output with-cache.png
run -- inspect --patch blaze --output inspected.png
drawn=$(ls -A "$work")
[[ $drawn == $'inspected.png\nwith-cache.png\nwithout-cache.png' ]] || stop "more or less than was drawn: $drawn"
cmp "$work/without-cache.png" "$work/with-cache.png" || stop "the cache changes the map"
echo "$base: three pictures drawn without network, on a root that cannot be written, as user $user"
