#!/usr/bin/env bash
# pod_mpi.sh JOINTID MPIRUN FOLDER: several processes share the samples of a record and get the modes of one; a mistake is told once.
set -euo pipefail
jointid=$1 folder=$3
mpirun=("$2" --allow-run-as-root --oversubscribe)
rm -rf "$folder" && mkdir -p "$folder" && cd "$folder"
fail() { echo "FAILED: $*" >&2; exit 1; }

LC_ALL=C awk 'BEGIN { print "time,a,b,c"; for (i = 0; i < 997; ++i) printf "%d,%.15g,%.15g,%.15g\n", i, sin(i), cos(1.7 * i), sin(0.3 * i) * sin(i) }' > run.csv
# One number a line, of the modes alone: the libraries behind them are others under mpirun, and have versions in their names.
numbers() { sed '/"provenance"/,$d' "$1" | tr ',' '\n' | grep -oE -- '-?[0-9]+\.[0-9e+-]+'; }

"$jointid" pod run.csv --json one.json > /dev/null
for ranks in 2 3; do
  "${mpirun[@]}" -n $ranks "$jointid" pod run.csv --threads 1 --json $ranks.json > text 2> err || fail "$(cat err)"
  [[ $(grep -c '997 samples of 3 channels' text) == 1 ]] || fail "$ranks processes: the text is there $(grep -c 'samples of' text) times"
  paste <(numbers one.json) <(numbers $ranks.json) |
    LC_ALL=C awk 'NF != 2 { exit 1 } { ++n; d = $1 - $2; if (d < 0) d = -d; if (d > 1e-9) { print $1, $2; exit 1 } } END { if (n < 10) exit 1 }' ||
    fail "$ranks processes have other numbers"
done
code=0
"${mpirun[@]}" -n 3 "$jointid" pod absent.csv > out 2> err || code=$?
[[ $code == 3 ]] || fail "exit code $code instead of 3"
[[ $(grep -c 'jointid: error' err) == 1 ]] || fail "not told once: $(cat err)"
echo "the modes of one by 2 and 3 processes; a mistake told once"
