#!/usr/bin/env bash
# manual_pages.sh BUILD SOURCE: every command has its page, every option of --help is on it, the
# pages are in order (mandoc and man, where they are), and their examples work.
set -euo pipefail
build=$1 source=$2

fail() { echo "FAILED: $*" >&2; exit 1; }
order='^NAME;SYNOPSIS;DESCRIPTION;(COMMANDS;)?OPTIONS;EXIT STATUS;(FILES;)?EXAMPLES;SEE ALSO;$'
sections() { grep -oP '^\.SH \K.*' "$1" | tr '\n' ';'; }
plain() { sed 's/\\-/-/g; s/\\e/\\/g'; }

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export PATH="$build:$PATH"
pages=$build/pages

mapfile -t commands < <(sir --help | sed -n '/^Subcommands:/,$ s/^  \([a-z]*\) .*/\1/p')
((${#commands[@]} >= 17)) || fail "--help lists ${#commands[@]} commands"
for command in '' "${commands[@]}"; do
  page=$pages/sir${command:+-$command}.1
  [[ -s $page ]] || fail "no page $page"
  mapfile -t options < <(sir ${command:+"$command"} --help | grep -oP '^  \K-[^ {]+' | tr ',' '\n')
  ((${#options[@]} >= 2)) || fail "${command:-sir} --help has no options"
  for option in "${options[@]}"; do
    grep -qF "\\fB${option//-/\\-}\\fR" "$page" || fail "$page lacks $option"
  done
  [[ $(sections "$page") =~ $order ]] ||
    fail "the sections of $page: $(sections "$page")"
  grep -q thesis "$page" || fail "$page does not say what of the thesis it is"
  for other in $(grep -oP '^\.BR sir\K[^ ]*' "$page" | plain); do
    [[ -s $pages/sir$other.1 ]] || fail "$page refers to sir$other"
  done
  # Where mandoc is missing, the pages' language goes unchecked.
  if command -v mandoc >/dev/null; then
    said=$(mandoc -T lint -W warning "$page") || fail "$said"
  fi
  if command -v man >/dev/null; then
    said=$(LC_ALL=C.UTF-8 man --warnings -l -Tutf8 -Z "$page" 2>&1 >/dev/null)
    [[ -z $said ]] || fail "$page: $said"
  fi
done

# The examples, in a folder with the scenes; those of `render` first, whose planes others take.
cp -r "$source/images" "$scratch"
cd "$scratch"
for command in render '' "${commands[@]}"; do
  page=$pages/sir${command:+-$command}.1
  sed -n '/^\.SH EXAMPLES/,$ p' "$page" | sed -n '/^\.EX/,/^\.EE/ { /^\./! p }' | plain >examples
  [[ -s examples ]] || fail "$page has no example"
  bash -euo pipefail examples >said 2>&1 </dev/null || {
    cat examples said
    fail "an example of $page"
  }
done
