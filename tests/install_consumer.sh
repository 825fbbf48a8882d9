#!/usr/bin/env bash
# install_consumer.sh BUILD SOURCE CXX FLAGS VERSION: what `cmake --install` leaves works
# wherever it is moved to: the program, its pages, completion and scenes, and the libraries for a program of
# somebody else's (tests/consumer), whose numbers are those of `sir` itself.
set -euo pipefail
build=$1 source=$2 cxx=$3 flags=$4 version=$5

fail() { echo "FAILED: $*" >&2; exit 1; }
same() { [[ $2 == "$3" ]] || fail "$1: expected $2, got $3"; }

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# Moved as a whole: nothing may remember where it was installed, or where it was built.
cmake --install "$build" --prefix "$scratch/first" >/dev/null
mkdir "another place"
mv first "another place/sir"
P="$scratch/another place/sir"
export PATH="$P/bin:$PATH"
grep -rIlF -e "$source" -e "$scratch" "$P/lib" "$P/share" "$P/include" &&
  fail "files name the place where they were made"

same "sir --version" "sir $version" "$(sir --version | head -n 1)"
for command in $(sir --help | sed -n '/^Subcommands:/,$ s/^  \([a-z]*\) .*/\1/p'); do
  gzip -t "$P/share/man/man1/sir-$command.1.gz" || fail "no manual page of $command"
done
gzip -t "$P/share/man/man1/sir.1.gz"
bash -c 'source "$1" && complete -p sir' - "$P/share/bash-completion/completions/sir" >/dev/null ||
  fail "the completion defines none"
for scene in whitted calice luminar piramide lcg; do
  [[ -e $P/share/sir/images/$scene.model ]] || fail "no $scene.model"
  sir -q render "$P/share/sir/images/$scene" --size 160x120 --out out
done
[[ -s $P/share/doc/sir/copyright ]] || fail "no copyright"

# Every header that an installed one asks for is there.
while read -r header; do
  [[ -e $P/include/sir/$header ]] || fail "no header $header, which an installed one includes"
done < <(grep -rhoP '^#include "\K[^"]+' "$P/include/sir" | sort -u)

cmake -G Ninja -S "$source/tests/consumer" -B consumer -D CMAKE_CXX_COMPILER="$cxx" \
  -D CMAKE_CXX_FLAGS="$flags" -D CMAKE_PREFIX_PATH="$P" -D CMAKE_BUILD_TYPE=Debug \
  >configured 2>&1 ||
  { cat configured; fail "find_package"; }
cmake --build consumer --verbose >built 2>&1 || { cat built; fail "the consumer does not build"; }
grep -q -e '-Werror' built && fail "our warnings are the consumer's errors"
grep -q -e '-ffp-contract=off' built || fail "the headers' arithmetic may be contracted"

base=$P/share/sir/images/calice
consumer/consumer "$base" >said
# The same by the program. JSON's numbers are compared as they were printed there.
sir lut out/calice --size 160x120 --json >lut.json
sir show out/calice --size 160x120 --trace trace --png screen.png >/dev/null
sir show out/calice --size 160x120 --crop --png shown.png >/dev/null
sir replay trace --json >replay.json
sir metrics out/calice shown.png --size 160x120 --json >metrics.json
sir -q export "$base" --pov scene.pov
member() { grep -oP "\"$2\":\"?\K[^,\"}]+" "$1" | head -n 1; }
said() { sed -n "s/^$1 //p" said; }
same cells_rgb "$(member lut.json cells_rgb)" "$(said cells_rgb)"
same cells_hsv "$(member lut.json cells_hsv)" "$(said cells_hsv)"
same entries "$(member lut.json entries)" "$(said entries)"
same "the screen" "$(member replay.json hash)" "$(said hash)"
same psnr "$(printf %.6f "$(member metrics.json psnr)")" "$(said psnr)"
same de_mean "$(printf %.6f "$(member metrics.json de_mean)")" "$(said de_mean)"
same "the scene for POV-Ray" "$(wc -c <scene.pov)" "$(said pov)"
same "the modeler's list" "$(printf 'load solid "%s"\nlist\n' "$base" | sir model)" \
  "$(sed '0,/^pov /d' said)"
