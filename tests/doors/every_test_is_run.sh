#!/usr/bin/env bash
# every_test_is_run.sh BUILD-FOLDER CTEST
# Every test that a built test program lists has a CTest entry that runs it: by its own name, or
# by a filter on its suite. Fails where one has none, and where an entry's filter selects nothing.
set -euo pipefail
build="$1" ctest="$2"
cd "$build"
# One line "program filter" for each entry of a GoogleTest program.
entries="$("$ctest" --show-only=json-v1 | grep -oE '"[^"]*(/|--gtest_filter=)[^"]*"' | tr -d '"' |
  awk '/^--gtest_filter=/ { sub(/^--gtest_filter=/, ""); print program, $0; next } { program = $0 }' | sort -u)"
[ -n "$entries" ] || { echo "CTest knows no GoogleTest entry"; exit 1; }

programs=0 status=0
for program in "$build"/test_* "$build"/unit_* "$build"/verify_* "$build"/cli_*; do
  [ -f "$program" ] && [ -x "$program" ] || continue
  programs=$((programs + 1))
  # Suite and test, without the comments on types and parameters.
  listed="$("$program" --gtest_list_tests | awk '
    /^[^ ].*\./ { sub(/[ \t]*#.*/, ""); suite = $0; next }
    /^  / { sub(/[ \t]*#.*/, ""); sub(/^ +/, ""); print suite $0 }')"
  [ -n "$listed" ] || { echo "$program lists no test"; status=1; continue; }
  awk -v program="$program" '
    NR == FNR { if ($1 == program) { if ($2 ~ /\.\*$/) suites[substr($2, 1, length($2) - 1)] = 1; else names[$2] = 1 } next }
    { suite = $0; sub(/\..*/, ".", suite); seen[suite] = 1
      if (!($0 in names) && !(suite in suites)) { print program ": no entry runs " $0; bad = 1 } }
    END { for (s in suites) if (!(s in seen)) { print program ": no test is in the suite " s; bad = 1 }
          exit bad }' <(printf '%s\n' "$entries") <(printf '%s\n' "$listed") || status=1
done
[ "$programs" -gt 0 ] || { echo "no test program is built in $build"; exit 1; }
echo "$programs programs"
exit "$status"
