#!/usr/bin/env bash
# completion.sh SCRIPT SIR: what bash offers for `sir`, with and without the package
# bash-completion; and that each word offered for an option is one that the program takes.
set -euo pipefail
script=$1 sir=$2
package=/usr/share/bash-completion/bash_completion

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
mkdir -p images/old 'two words'
touch images/{a,b}.{CSG,CAM,LUZ,SUP} images/a.{R,G,B,LUT,png} images/c.model images/old/x.CSG \
  'my scene.CSG' lower.csg

failures=0
# offered WORD...: the completions of the last word, sorted, in one line.
offered() {
  bash -c '
    set -u
    [[ -z $1 ]] || { set +u; source "$1"; set -u; }
    source "$2"
    shift 2
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMP_LINE="$*" COMP_POINT=$((${#COMP_LINE}))
    _sir sir "${COMP_WORDS[-1]}" "${COMP_WORDS[-2]}"
    printf "%s\n" "${COMPREPLY[@]}"' - "$loaded" "$script" "$@" | sort -u | paste -sd ' '
}
# expect WANTED WORD...
expect() {
  local wanted=$1 found
  shift
  found=$(offered "$@")
  [[ $found == "$wanted" ]] && return
  echo "FAILED (${loaded:-no package}): $*: expected \"$wanted\", got \"$found\"" >&2
  failures=1
}

check() {
  expect 'render replay' sir re
  expect '--version' sir --ver
  expect 'render replay' sir -q re
  expect 'best frequency median' sir lut a --method ''
  expect 'median' sir lut a --method m
  expect 'median' sir lut a --method = m
  expect 'best frequency median' sir lut a --method =
  expect 'hsv rgb' sir lut --space ''
  expect 'envelopes gates roth' sir render a --engine ''
  expect 'envelopes gates roth' sir -v render a --engine ''
  expect 'adaptive none random' sir render --antialias ''
  expect 'reflection refraction' sir render --effects re
  expect 'shadow,reflection shadow,refraction' sir render --effects shadow,re
  expect 'de_max= de_mean= de_p95=' sir metrics a b --fail-above de
  expect 'method' sir cost a --only me
  expect 'auto blocks sixel' sir show a --terminal =
  expect 'images/a images/a.png images/b images/old' sir show a --terminal images/
  expect '--past-limit --precision --progressive' sir render a --p
  expect 'images/a images/b images/old' sir render images/
  expect 'images/old/x' sir render images/old/
  expect 'my scene' sir render my
  expect 'lower' sir check l
  expect 'images/a images/a.png images/b images/old' sir lut images/
  expect 'images/a.LUT images/old' sir show a --lut images/
  expect 'images/a.png images/old' sir show a --png images/
  expect 'images/c.model images/old' sir model images/
  expect 'images two words' sir render a --out ''
  expect '' sir render a --depth ''
  expect '' sir nothing ''
}
loaded=
check
if [[ -e $package ]]; then
  loaded=$package
  check
fi

# Every option of --help is offered, and no other; the program takes every word that is.
loaded=
for command in $("$sir" --help | sed -n '/^Subcommands:/,$ s/^  \([a-z]*\) .*/\1/p'); do
  expect "$("$sir" "$command" --help | grep -oP '^  \K-[^ {]+' | tr ',' '\n' |
    { cat; printf '%s\n' -q -v; } | sort -u | paste -sd ' ')" sir "$command" -
  for option in $("$sir" "$command" --help |
    grep -oP '^  \K-[^ {]+(?= [a-z0-9-]+\|)' | tr ',' '\n'); do
    for word in $(offered sir "$command" "$option" ''); do
      said=$("$sir" "$command" "$option" "$word" 2>&1 </dev/null || true)
      [[ $said != *"\"$word\" is not"* ]] || { echo "FAILED: $said" >&2; failures=1; }
    done
  done
done
exit "$failures"
