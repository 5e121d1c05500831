#!/usr/bin/env bash
# run_readme.sh README BUILD-FOLDER SCRATCH-FOLDER
# Runs each line of the README's ```sh blocks, as a user would type them, and checks that
# the restitution the text names is the one the lumped example prints.
set -euo pipefail
readme="$1" build="$2" scratch="$3"

rm -rf "$scratch" && mkdir -p "$scratch" && cd "$scratch"
ln -s "$build" build
export HOME="$scratch/home"  # what is installed below ~ stays here
mkdir "$HOME"
commands="$(awk '/^```sh$/ {inside = 1; next} /^```$/ {inside = 0} inside' "$readme")"
[ -n "$commands" ] || { echo 'the README holds no sh block' >&2; exit 1; }

printed=''
while IFS= read -r command; do
  echo "\$ $command"
  output="$(eval "$command")" || { echo "ended with $?: $command" >&2; exit 1; }
  printf '%s\n' "$output"
  case "$command" in *'rebound lumped'*) printed="$output" ;; esac
done <<<"$commands"

claimed="$(sed -n 's/.*`restitution \([0-9.]*\)`.*/\1/p' "$readme")"
[ -n "$claimed" ] || { echo 'the README names no restitution' >&2; exit 1; }
awk -v claimed="$claimed" '$1 == "restitution" {
  found = sprintf("%.*f", length(claimed) - 2, $2)
  if (found != claimed) { print "README says " claimed ", printed " $2 > "/dev/stderr"; exit 1 }
  agrees = 1
} END { exit !agrees }' <<<"$printed"
