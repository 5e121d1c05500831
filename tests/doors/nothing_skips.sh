#!/usr/bin/env bash
# nothing_skips.sh SOURCE-FOLDER
# No test passes by not being run, and no list of suites is kept by hand.
set -euo pipefail
cd "$1"
status=0
refuse() {  # WHY PATTERN FILE-GLOB...
  local why="$1" pattern="$2" found
  shift 2
  found="$(grep -rnE "$pattern" "${@/#/--include=}" tests lumped fem meshes comparisons | grep -v '^tests/doors/' || true)"
  [ -z "$found" ] || { echo "$why:"; echo "$found"; status=1; }
}
refuse 'a test that skips itself cannot fail; let a missing tool end the configuration' \
  'GTEST_SKIP|DISABLED_' '*.cpp' '*.hpp'
refuse 'a test that skips itself cannot fail' '\b(test|it|describe)\.(skip|todo|only)\b|skip: *true' '*.mjs' '*.js'
refuse 'a status or text that counts as skipped hides a failure' \
  'SKIP_RETURN_CODE|SKIP_REGULAR_EXPRESSION|DISABLED' CMakeLists.txt '*.cmake'
refuse 'a filter by hand runs nothing once its suite is renamed; use discover_suites' 'gtest_filter' CMakeLists.txt
exit "$status"
