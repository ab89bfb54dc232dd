#!/usr/bin/env bash
# solve_mpi.sh JOINTID MPIRUN FOLDER: several processes get the joint of one, a mistake is told once, and Ctrl-C leaves the best
# values so far.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/mpirun.sh"
jointid=$1 folder=$3
mpirun=("$2" --allow-run-as-root --oversubscribe)
rm -rf "$folder" && mkdir -p "$folder" && cd "$folder"
fail() { echo "FAILED: $*" >&2; exit 1; }
values() { grep -oE '"(value|std_error|lines|iterations)": *[-0-9.e+]+' "$1" | sed 's/.*: *//'; }

# Largest relative difference of the numbers of two files, at most 1e-9.
same_numbers() {
  paste <(values "$1") <(values "$2") | LC_ALL=C awk -v files="$1 $2" '
    NF != 2 { print "FAILED: not as many numbers in " files; exit 1 }
    { ++n; d = $1 - $2; d = d < 0 ? -d : d; s = $1 < 0 ? -$1 : $1 }
    d > 1e-9 * s { print "FAILED: " $1 " and " $2 " in " files; exit 1 }
    END { if (n < 20) { print "FAILED: " n + 0 " numbers in " files; exit 1 } }' >&2
}

"$jointid" problem write A1 a1 > /dev/null
for method in likelihood one auto; do
  "$jointid" problem write A1 a1_$method --method $method > /dev/null
  "$jointid" solve a1_$method/A1.toml --json $method.json > /dev/null
  for ranks in 2 3; do
    "${mpirun[@]}" -n $ranks "$jointid" solve a1_$method/A1.toml --threads 1 --json ${method}_$ranks.json > text 2> err ||
      fail "$method: $(cat err)"
    [[ $(grep -c 'run time' text) == 1 ]] || fail "$method, $ranks processes: the text is there $(grep -c 'run time' text) times"
    same_numbers $method.json ${method}_$ranks.json
  done
done

# fails_once CODE PATTERN SOLVE-ARGUMENTS …
fails_once() {
  local expected=$1 pattern=$2 code=0
  shift 2
  "${mpirun[@]}" -n 3 "$jointid" solve "$@" > out 2> err || code=$?
  [[ $code == "$expected" ]] || fail "$*: exit code $code instead of $expected: $(cat err)"
  [[ $(grep -c 'jointid: error' err) == 1 ]] || fail "$*: not told once: $(cat err)"
  grep -q "jointid: error.*$pattern" err || fail "$*: $(cat err)"
  [[ ! -s out ]] || fail "$*: printed $(cat out)"
}
fails_once 2 'absent.toml' absent.toml
fails_once 2 "'--trails'" a1/A1.toml --trails 3
fails_once 2 '9:+Y' a1/A1.toml --plot 9:+Y/9:+Y
"$jointid" problem write A1 newton --method newton > /dev/null
sed -i '/^equations/d' newton/A1.toml
fails_once 2 'several processes cannot share' newton/A1.toml
cp -r a1_one broken && head -c 100 a1/A1_assembly.h5 > broken/A1_assembly.h5
fails_once 3 'A1_assembly.h5' broken/A1.toml

# Ctrl-C of mpirun, which gives no code of ours: what the leader had so far is there, and marked.
"$jointid" problem write bolts bolts --method likelihood > /dev/null
kept=no
for seconds in 2 4 8 16 32; do
  "${mpirun[@]}" -n 2 "$jointid" solve bolts/bolts.toml --threads 1 --json stopped.json > /dev/null 2>&1 &
  process=$!
  sleep $seconds
  kill -INT $process 2> /dev/null || fail "the solution had ended"
  end_of $process && fail "mpirun ended well after Ctrl-C"
  [[ -e stopped.json ]] && grep -q 'Interrupted after [1-9]' stopped.json && kept=yes && break
done
[[ $kept == yes ]] || fail "nothing was kept"
echo "the same joint by 1, 2 and 3 processes; mistakes told once; the best values after Ctrl-C"
