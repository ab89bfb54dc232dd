#!/usr/bin/env bash
# command_files.sh PYTHON JOINTID OUT: man pages and completion as packages have them, tried with the shells that are here.
set -euo pipefail
sources=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
python=$1 command=$2 out=$3
rm -rf "$out"
mkdir -p "$out/bin"
PYTHONDONTWRITEBYTECODE=1 "$python" "$sources/packaging/command_files.py" "$command" 2026-01-01 "$out"
ln -s "$command" "$out/bin/jointid"
export PATH=$out/bin:$PATH

failed() {
  echo "$*" >&2
  exit 1
}

# Of a line that bash completes: what is offered.
in_bash() {
  bash -c 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _jointid; echo "${COMPREPLY[*]}"' - "$out/bash-completion/completions/jointid" "$@"
}
[[ $(in_bash jointid so) == solve ]] || failed "bash: jointid so"
[[ $(in_bash jointid study --mer) == --merge ]] || failed "bash: jointid study --mer"
[[ $(in_bash jointid problem wr) == write ]] || failed "bash: jointid problem wr"
if command -v fish >/dev/null; then
  in_fish() { fish -c "source $out/fish/vendor_completions.d/jointid.fish; complete -C '$1'" | cut -f1; }
  [[ $(in_fish "jointid so") == solve ]] || failed "fish: jointid so"
  [[ $(in_fish "jointid study --mer") == --merge ]] || failed "fish: jointid study --mer"
fi
if command -v zsh >/dev/null; then
  zsh "$sources/packaging/try_completion.zsh" "$out/zsh/vendor-completions" || failed "zsh"
fi
pages=("$out"/man/man1/*.1.gz)
((${#pages[@]} > 20)) || failed "${#pages[@]} man pages"
for page in "${pages[@]}"; do
  if command -v man >/dev/null && [[ -n $(man --warnings -l -Tutf8 "$page" 2>&1 >/dev/null) ]]; then failed "man warns of $page"; fi
done
echo "${#pages[@]} man pages; completion of bash$(command -v fish >/dev/null && echo , fish)$(command -v zsh >/dev/null && echo , zsh)"
