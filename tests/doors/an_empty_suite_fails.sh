#!/usr/bin/env bash
# an_empty_suite_fails.sh SOURCE-FOLDER SCRATCH-FOLDER CMAKE CTEST
# Entries made by comparisons/setup/cmake/list_suites.cmake follow a renamed suite; one whose filter selects nothing
# fails, and so does a program that lists none.
set -euo pipefail
source="$1" scratch="$2" cmake="$3" ctest="$4"
rm -rf "$scratch" && mkdir -p "$scratch" && cd "$scratch"
# A program of one suite, named in suite.txt, that answers as GoogleTest does.
cat >program <<'PROGRAM'
#!/usr/bin/env bash
suite="$(cat "$(dirname "$0")/suite.txt")"
case "$1" in
  --gtest_list_tests) [ -z "$suite" ] || printf '%s.\n  Test\n' "$suite" ;;
  "--gtest_filter=$suite.*") echo '[==========] 1 test from 1 test suite ran.' ;;
  *) echo '[==========] 0 tests from 0 test suites ran.' ;;
esac
PROGRAM
chmod +x program
list() {
  "$cmake" -DNAME=verify -DPROGRAM="$scratch/program" -DOUTPUT="$scratch/CTestTestfile.cmake" \
    -DLABELS=fast "-DLONG=${1:-}" -DTIMEOUT=10 -P "$source/comparisons/setup/cmake/list_suites.cmake" >/dev/null 2>&1
}
fail() { echo "$*" >&2; exit 1; }

echo Impact >suite.txt
list || fail 'one suite was refused'
"$ctest" --no-tests=error >ctest.log || fail 'an entry that runs its test failed'
grep -q 'verify.Impact' ctest.log || fail 'the suite has no entry'
! list Vanished || fail 'a long suite that the program does not list was accepted'
list Impact
"$ctest" --no-tests=error -L long >ctest.log || fail 'a suite that is named long has no such label'
echo Collision >suite.txt
! "$ctest" --no-tests=error >ctest.log || fail 'the entry of a suite that was renamed away passed'
list
"$ctest" --no-tests=error >ctest.log || fail 'the renamed suite failed'
grep -q 'verify.Collision' ctest.log || fail 'the renamed suite has no entry'
: >suite.txt
! list || fail 'a program without a suite was accepted'
