#!/usr/bin/env bash
# a_missing_tool_fails.sh SOURCE-FOLDER SCRATCH-FOLDER CMAKE
# A tool that tests need and that is missing ends the configuration; and every command that
# packages-tests.txt names is looked for that way, so that no test need ask.
set -euo pipefail
source="$1" scratch="$2" cmake="$3"
rm -rf "$scratch" && mkdir -p "$scratch"
cat >"$scratch/script.cmake" <<SCRIPT
cmake_minimum_required(VERSION 3.25)
include($source/comparisons/setup/cmake/require_tool.cmake)
require_tool(FOUND \${TOOL} some-package)
message(STATUS "found \${FOUND}")
SCRIPT
"$cmake" -DTOOL=bash -P "$scratch/script.cmake" >/dev/null
if "$cmake" -DTOOL=no-such-program-anywhere -P "$scratch/script.cmake" >"$scratch/log" 2>&1; then
  echo 'a missing tool was accepted' >&2; exit 1
fi
grep -q 'some-package' "$scratch/log" || { echo 'the package is not named' >&2; exit 1; }
status=0
while read -r _ command; do
  [ -n "$command" ] || continue
  grep -rqE "(require_tool\([A-Z_]+ $command |find_program\([A-Z_]+ NAMES ([a-z]+ )*$command\b)" \
    --include=CMakeLists.txt "$source/tests" ||
    { echo "packages-tests.txt lists $command, and no CMakeLists.txt of the tests requires it" >&2; status=1; }
done < <(sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$source/comparisons/setup/packages-tests.txt")
exit "$status"
