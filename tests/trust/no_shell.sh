#!/usr/bin/env bash
# no_shell.sh SOURCE-FOLDER
# Text of a user never reaches a shell: the program and its tools start none. (The tests do.) The generator of
# blind trials alone starts a program, the one that its --fem names, by a list of arguments.
set -euo pipefail
cd "$1"
found="$(grep -rnE '\b(std::system|popen|posix_spawnp?|exec[lv]p?e?)\(|[^.>a-z_]system\("|shell *= *True|os\.system' \
  --include='*.cpp' --include='*.hpp' --include='*.inl' --include='*.py' lumped fem meshes comparisons |
  grep -v '^comparisons/discrepancy/trials/generator/fem_program\.cpp:.*::posix_spawn(' || true)"
[ -z "$found" ] || { echo "a shell or another program is started:"; echo "$found"; exit 1; }
