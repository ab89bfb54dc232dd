# zsh try_completion.zsh FOLDER: completes words of jointid as at a prompt, with the functions of FOLDER.
zmodload zsh/zpty
failed=0

# What is typed before the tab, and what has to appear.
try() {
  zpty shell zsh -f -i
  zpty -w shell "PS1=; fpath=($folder \$fpath); autoload -U compinit; compinit -u -D; print rea\"\"dy"
  zpty -r -m shell text '*ready*'
  zpty -w -n shell "$1"$'\t'
  local all= piece
  for i in {1..50}; do
    zpty -r -t shell piece && all+=$piece
    [[ $all == *$2* ]] && break
    sleep 0.2
  done
  zpty -d shell
  [[ $all == *$2* ]] || { print -r -- "zsh does not complete $1: ${(q)all}"; failed=1 }
}

folder=$1
try 'jointid so' 'jointid solve'
try 'jointid study --mer' '--merge'
try 'jointid problem wr' 'problem write'
exit $failed
