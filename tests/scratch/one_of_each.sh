#!/usr/bin/env bash
# one_of_each.sh SOURCE-FOLDER BUILD-FOLDER SCRATCH-FOLDER CMAKE
#
# Copies the sources, adds a law, a material, an effect, a damping formula and a command with
# comparisons/setup/new (nothing else is touched), builds the program, the FE module and the
# batteries, and runs the new things. Objects that no changed file went into are taken over from
# BUILD-FOLDER (tests/support/reuse_object.py); the others are compiled without optimisation.
set -euo pipefail
export DONE_SOURCE="$1" DONE_BUILD="$2"
scratch="$3" cmake="$4"
export NEW_SOURCE="$scratch/source" NEW_BUILD="$scratch/build"
fail() { echo "one_of_each: $*" >&2; exit 1; }

rm -rf "$scratch"
mkdir -p "$NEW_SOURCE"
cd "$DONE_SOURCE"
# The files of the project, as they are now; without git the whole folder but its builds.
if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then git ls-files -co --exclude-standard -z; else
  find . -name 'build*' -prune -o -name results -prune -o -type f -print0; fi |
  while IFS= read -r -d '' file; do [ ! -e "$file" ] || printf '%s\0' "$file"; done |
  tar -c --null -T - | tar -x -C "$NEW_SOURCE"

cd "$NEW_SOURCE"
bash comparisons/setup/new law my-spring
bash comparisons/setup/new material my-solid
bash comparisons/setup/new effect my-effect
bash comparisons/setup/new damping-formula my-formula
bash comparisons/setup/new command my-command
if bash comparisons/setup/new law my-spring 2>/dev/null; then fail 'a name that is taken was accepted'; fi

# Configured as BUILD-FOLDER was, so that objects have the same names and flags.
option() { sed -n "s#^$1:[A-Z]*=##p" "$DONE_BUILD/CMakeCache.txt" | head -n 1; }
arguments=()
for name in CMAKE_BUILD_TYPE CMAKE_CXX_COMPILER CMAKE_CXX_FLAGS CMAKE_CXX_FLAGS_DEBUG CMAKE_UNITY_BUILD \
  REBOUND_UNITY CMAKE_DISABLE_PRECOMPILE_HEADERS REBOUND_FEM REBOUND_BENCHMARKS; do
  value="$(option "$name")"
  [ -z "$value" ] || arguments+=("-D$name=$value")
done
"$cmake" -S "$NEW_SOURCE" -B "$NEW_BUILD" -G Ninja "${arguments[@]}" -DREBOUND_TESTS=ON \
  -DCMAKE_CXX_COMPILER_LAUNCHER="/usr/bin/python3;-B;$DONE_SOURCE/tests/support/reuse_object.py" >"$scratch/configure.log" 2>&1 ||
  { tail -20 "$scratch/configure.log"; fail 'the scratch copy does not configure'; }
: >"$NEW_BUILD/compiled.txt"
programs=(rebound test_lumped unit_effects cli_tests)
[ "$(option REBOUND_FEM)" = OFF ] || programs+=(rebound_fem test_fem_parts verify_fem)
ninja -C "$NEW_BUILD" "${programs[@]}" >"$scratch/build.log" 2>&1 ||
  { grep -E 'error|FAILED' "$scratch/build.log" | head -20; fail 'the scratch copy does not build'; }
echo "compiled $(wc -l <"$NEW_BUILD/compiled.txt") units of $(grep -c 'Building' "$scratch/build.log")"

exec bash "$DONE_SOURCE/tests/scratch/use_one_of_each.sh" "$NEW_BUILD" "$scratch/run" "$(option REBOUND_FEM)"
