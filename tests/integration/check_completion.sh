#!/usr/bin/env bash
# check_completion.sh MANUAL_DIR PROGRAM: completion and manual pages are there, valid and know every command and option.
set -euo pipefail
dir=$1
program=$2
failed=0
complain() {
  echo "$1" >&2
  failed=1
}

# Reads to the end, unlike grep -q: the writer of a pipe must not meet a closed one.
has() {
  grep "$@" >/dev/null
}

# shellcheck disable=SC1091  # made by the build
source "$dir/completion.bash"
completed() { # words of a command line, the last one to be completed
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  COMPREPLY=()
  _hybridfusion
  printf '%s\n' "${COMPREPLY[@]}"
}

mapfile -t commands < <("$program" completion commands)
[ "${#commands[@]}" -ge 10 ] || complain "only ${#commands[@]} commands"
for command in "${commands[@]}"; do
  completed hybridfusion "${command:0:3}" | has -x "$command" || complain "bash does not complete '$command'"
  grep -q "^    $command) _arguments " "$dir/completion.zsh" || complain "zsh does not know '$command'"
  page=$dir/man1/hybridfusion-$command.1.gz
  if [ -d "$dir/man1" ] && [ -e "$dir/man1/hybridfusion.1.gz" ]; then
    zgrep -q "^hybridfusion-$command \\\\- ." "$page" || complain "no manual page of '$command'"
  fi
  for option in $("$program" "$command" --help | grep -oE '^  (-h,)?--[a-z-]+' | grep -oE -- '--[a-z-]+'); do
    completed hybridfusion "$command" "$option" | has -x -- "$option" || complain "bash: $command $option"
    grep -q -- "'$option\[" "$dir/completion.zsh" || complain "zsh: $command $option"
    if [ -e "$page" ]; then
      zcat "$page" | sed 's/\\-/-/g' | has -- "$option" || complain "manual: $command $option"
    fi
  done
done
completed hybridfusion register --method pa | has -x paper || complain "bash does not complete a value"
completed hybridfusion simulate --preset '' | has -x city || complain "bash does not list the values"
cd "$dir"
completed hybridfusion map --bag completion.z | has -x completion.zsh || complain "bash does not complete a file"
if command -v zsh >/dev/null; then zsh -n completion.zsh || complain "zsh: not valid"; fi
exit "$failed"
