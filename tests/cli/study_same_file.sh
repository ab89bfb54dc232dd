#!/usr/bin/env bash
# study_same_file.sh JOINTID MPIRUN|none FOLDER: the result file of a study has the same bytes for any number of threads and
# processes, after being killed at any moment, and after Ctrl-C.
set -euo pipefail
jointid=$1 mpirun=$2 folder=$3
rm -rf "$folder" && mkdir -p "$folder" && cd "$folder"
fail() { echo "FAILED: $*" >&2; exit 1; }

trials=3000
study=("$jointid" study a1/A1.toml --trials $trials --seed 5)
"$jointid" problem write A1 a1 --clean > /dev/null
"${study[@]}" --threads 1 --out one.h5 --json one.json > one.txt
"${study[@]}" --threads 2 --out two.h5 > /dev/null
cmp one.h5 two.h5 || fail "1 and 2 threads differ"
[[ ! -e one.h5.partial ]] || fail "the journal is left over"

if [[ $mpirun != none ]]; then
  for ranks in 2 3; do
    "$mpirun" --allow-run-as-root --oversubscribe -n $ranks "${study[@]}" --threads 1 --out ranks.h5 > /dev/null
    cmp one.h5 ranks.h5 || fail "$ranks processes differ"
  done
fi

# Killed at moments that differ from run to run; each time it goes on from where it was.
kills=0
resume=()
until [[ -e killed.h5 ]]; do
  "${study[@]}" --threads 2 --out killed.h5 "${resume[@]}" > /dev/null 2>&1 &
  process=$!
  sleep "0.$((RANDOM % 3))$((RANDOM % 10))"
  kill -9 $process 2> /dev/null && kills=$((kills + 1))
  wait $process 2> /dev/null || true
  resume=(--resume)
  ((kills < 300)) || fail "no end after $kills kills"
done
"${study[@]}" --out killed.h5 --resume > /dev/null
cmp one.h5 killed.h5 || fail "the file after $kills kills differs"

# A record that was cut short counts as not there.
"${study[@]}" --threads 2 --out cut.h5 > /dev/null 2>&1 &
process=$!
sleep 0.2
kill -9 $process 2> /dev/null || true
wait $process 2> /dev/null || true
if [[ -e cut.h5.partial ]]; then
  truncate -s -50 cut.h5.partial
  "${study[@]}" --out cut.h5 --resume > /dev/null
fi
cmp one.h5 cut.h5 || fail "the file after a cut record differs"

# Ctrl-C: exit code 130, a line that says how to go on, and nothing lost.
"$jointid" study a1/A1.toml --trials 1000000 --seed 5 --threads 2 --out stopped.h5 > /dev/null 2> stopped.txt &
process=$!
until [[ -s stopped.h5.partial ]] && (($(stat -c %s stopped.h5.partial) > 5000)); do sleep 0.02; done
kill -INT $process
code=0
wait $process || code=$?
[[ $code == 130 ]] || fail "exit code $code after Ctrl-C"
grep -q 'keeps [1-9][0-9]* of 1000000 trials.*--resume continues' stopped.txt || fail "nothing kept: $(cat stopped.txt)"
code=0
"$jointid" study a1/A1.toml --seed 5 --out stopped.h5 > /dev/null 2> refused.txt || code=$?
[[ $code == 2 ]] && grep -q -- '--resume' refused.txt || fail "a fresh run over a journal"
code=0
"$jointid" study a1/A1.toml --seed 6 --out stopped.h5 --resume > /dev/null 2> refused.txt || code=$?
[[ $code == 2 ]] && grep -q 'another seed' refused.txt || fail "a journal of another seed"
"${study[@]}" --out stopped.h5 --resume > resumed.txt
grep -q "^$trials trials in" resumed.txt && fail "--resume took up nothing"
cmp one.h5 stopped.h5 || fail "the file after Ctrl-C differs"
echo "same file for 1, 2 threads, 2, 3 processes, after $kills kills and Ctrl-C"
