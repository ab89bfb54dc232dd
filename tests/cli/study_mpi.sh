#!/usr/bin/env bash
# study_mpi.sh PART JOINTID MPIRUN TRAP FOLDER: a part of the tests of studies by several processes. wrong_starts: told once and with the
# right code; interrupted: Ctrl-C of mpirun loses nothing; laws: the same of friction laws, and what is not shared is done once;
# not_started: without mpirun MPI is not initialised (TRAP is a library that ends the process where it is).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/mpirun.sh"
part=$1 jointid=$2 trap=$4 folder=$5
mpirun=("$3" --allow-run-as-root --oversubscribe)
rm -rf "$folder" && mkdir -p "$folder" && cd "$folder"
fail() { echo "FAILED: $*" >&2; exit 1; }
"$jointid" problem write A1 a1 --clean > /dev/null
"$jointid" problem write sdof-iwan iwan > /dev/null
study=("$jointid" study a1/A1.toml --seed 5 --threads 1)

# fails_once CODE PATTERN MPIRUN-ARGUMENTS …
fails_once() {
  local expected=$1 pattern=$2 code=0
  shift 2
  "${mpirun[@]}" "$@" > out 2> err || code=$?
  [[ $code == "$expected" ]] || fail "$*: exit code $code instead of $expected: $(cat err)"
  [[ $(grep -c 'jointid: error' err) == 1 ]] || fail "$*: not told once: $(cat err)"
  grep -q "jointid: error.*$pattern" err || fail "$*: $(cat err)"
  [[ ! -s out ]] || fail "$*: printed $(cat out)"
}

wrong_starts() {
  fails_once 2 'absent.toml' -n 3 "$jointid" study absent.toml
  fails_once 2 "'--trails'" -n 3 "$jointid" study a1/A1.toml --trails 3
  fails_once 2 'SCENE' -n 3 "$jointid" study
  fails_once 2 '--trials' -n 3 "$jointid" study a1/A1.toml --trials 0
  fails_once 3 'absent/a.h5' -n 3 "$jointid" study a1/A1.toml --out absent/a.h5
  fails_once 3 'absent/a.csv' -n 3 "$jointid" study iwan/sdof-iwan.toml --trials 2 --out absent/a.csv
  cp -r a1 broken && head -c 100 a1/A1_assembly.h5 > broken/A1_assembly.h5
  fails_once 3 'A1_assembly.h5' -n 3 "$jointid" study broken/A1.toml
  fails_once 2 'absent.toml' -n 1 "$jointid" study a1/A1.toml : -n 1 "$jointid" study absent.toml
  [[ ! -e A1.study.h5 ]] || fail "a study ran without one of its processes"
}

# It gives no code of ours.
interrupted() {
  "${study[@]}" --trials 2000 --out whole.h5 > /dev/null
  "${mpirun[@]}" -n 2 "${study[@]}" --trials 1000000 --out stopped.h5 > /dev/null 2>&1 &
  process=$!
  until [[ -e stopped.h5.partial ]] && (($(stat -c %s stopped.h5.partial) > 5000)); do sleep 0.02; done
  kill -INT $process
  end_of $process && fail "mpirun ended well after Ctrl-C"
  "${mpirun[@]}" -n 2 "${study[@]}" --trials 2000 --out stopped.h5 --resume > resumed.txt
  cmp whole.h5 stopped.h5 || fail "the file after Ctrl-C of mpirun differs"
}

# The answers of a JSON result: without how it was made.
answers() { sed '/^  "provenance": {/,$d' "$1"; }

# One law: quick.
laws() {
  sed -i 's/^law = .*/law = "iwan"/' iwan/sdof-iwan.toml
  laws=("$jointid" study iwan/sdof-iwan.toml --seed 3 --threads 1)
  "${laws[@]}" --trials 4 --json one.json --out one.csv
  "${mpirun[@]}" -n 2 "${laws[@]}" --trials 4 --json two.json --out two.csv
  cmp <(answers one.json) <(answers two.json) || fail "a study of laws differs by the processes"
  [[ $(sort one.csv) == "$(sort two.csv)" ]] || fail "its trials do"
  "${mpirun[@]}" -n 2 "${laws[@]}" --trials 1000 --out half.csv > /dev/null 2>&1 &
  process=$!
  until [[ -e half.csv ]] && (($(wc -l < half.csv) > 4)); do sleep 0.02; done
  kill -INT $process
  end_of $process && fail "mpirun of a study of laws ended well after Ctrl-C"
  "${mpirun[@]}" -n 2 "${laws[@]}" --trials 4 --json two.json --out half.csv --resume
  cmp <(answers one.json) <(answers two.json) || fail "a study of laws after Ctrl-C of mpirun differs"

  # What is not shared is done once.
  "${mpirun[@]}" -n 3 "${laws[@]/study/compare}" --trials 1 > out 2> err || fail "compare: $(cat err)"
  [[ $(grep -c 'not shared by the 3 processes' err) == 1 ]] || fail "compare: not told once: $(cat err)"
  [[ $(grep -c 'friction limit' out) == 1 ]] || fail "compare: not done once: $(cat out)"
}

not_started() {
  "${study[@]}" --trials 2000 --out whole.h5 > /dev/null
  # The trap itself is tried first.
  local code=0
  OMPI_COMM_WORLD_SIZE=2 ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD=$trap "${study[@]}" --out trap.h5 > /dev/null 2> err || code=$?
  [[ $code == 99 ]] && grep -q 'MPI_Init_thread was called' err || fail "the trap catches nothing: $code, $(cat err)"
  export ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD=$trap
  "${study[@]}" --trials 2000 --out plain.h5 > /dev/null || fail "a plain study: $?"
  "$jointid" solve a1/A1.toml > /dev/null || fail "a plain solve: $?"
  "$jointid" --version > /dev/null || fail "--version: $?"
  unset LD_PRELOAD
  cmp whole.h5 plain.h5
}

"$part"
