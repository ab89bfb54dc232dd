#!/usr/bin/env bash
# two_programs.sh JOINTID JOINTID-ALL DIR: what `jointid` says alone, and that with `jointid-all` beside it nobody sees that they are two.
set -euo pipefail
jointid=$1 all=$2 dir=$3
rm -rf "$dir"
mkdir -p "$dir/alone" "$dir/beside"
cp "$jointid" "$dir/alone/jointid"
cp "$jointid" "$dir/beside/jointid"
ln -s "$(realpath "$all")" "$dir/beside/jointid-all"
ln -s beside/jointid "$dir/link"
cd "$dir"

fail() {
  echo "two_programs: $1" >&2
  exit 1
}

# expect CODE WHAT COMMAND…: the exit code, and a part of what is printed.
expect() {
  local code=$1 what=$2 printed got=0
  shift 2
  printed=$("$@" 2>&1) || got=$?
  [[ $got == "$code" ]] || fail "$* ended with $got in place of $code: $printed"
  [[ $printed == *"$what"* ]] || fail "$* did not say '$what' but: $printed"
}

same() {
  local one two
  one=$("beside/jointid" "$@" 2>&1) || true
  two=$("$all" "$@" 2>&1) || true
  [[ -n $one && $one == "$two" ]] || fail "jointid and jointid-all differ about $*: $one; $two"
}

"$all" problem write sdof-iwan laws >/dev/null
remedy="scripts/build release"

expect 2 "'study' is no command of \`jointid\`; see \`jointid --help\`; for more commands, build all of jointid: $remedy" alone/jointid study x
expect 0 "$remedy" alone/jointid --help
expect 0 "$remedy" alone/jointid problem list
expect 2 "did you mean A1?; for more of them, build all of jointid: $remedy" alone/jointid problem write A1x out
expect 2 "scene of friction laws or of a joint at every line, which this part of jointid does not solve; build all of jointid: $remedy" alone/jointid solve laws/sdof-iwan.toml
expect 2 "scene of friction laws" alone/jointid plan laws/sdof-iwan.toml --bound
expect 0 "next: jointid solve" alone/jointid problem write A1 a1
expect 0 "K(1,1)" alone/jointid solve a1/A1.toml

for words in "--help" "study --help" "solve --help" "problem list" "solv" "study" "solve a1/A1.toml --jsn" "plan laws/sdof-iwan.toml" "--version"; do
  same $words
done
expect 0 "next: jointid loading-curve" beside/jointid problem write table2.1-1 curve
expect 0 "predicted at the bound" ./link plan laws/sdof-iwan.toml --bound
expect 2 "scenes of friction laws have no plan but the bound" beside/jointid plan /dev/stdin <laws/sdof-iwan.toml
expect 0 "K(1,1)" beside/jointid solve a1/A1.toml
rm beside/jointid-all
printf 'no program' >beside/jointid-all
expect 2 "jointid-all: cannot be started" beside/jointid study x
