#!/usr/bin/env bash
# one_of_each.sh SOURCE-FOLDER BUILD-FOLDER SCRATCH-FOLDER CMAKE
#
# Copies the sources, adds a law, a material, an effect, a damping formula and a command with
# comparisons/setup/new (nothing else is touched), builds the program, the FE module and the
# batteries, and runs the new things. Objects that no changed file went into are taken over from
# BUILD-FOLDER, so that some eighty units are compiled, without optimisation, and not some four hundred.
set -euo pipefail
export SOURCE="$1" BUILD="$2"
scratch="$3" cmake="$4"
export SCRATCH_SOURCE="$scratch/source" SCRATCH_BUILD="$scratch/build"
export CHANGED_OBJECTS="$scratch/changed_objects.txt"
fail() { echo "one_of_each: $*" >&2; exit 1; }

rm -rf "$scratch"
mkdir -p "$SCRATCH_SOURCE"
cd "$SOURCE"
# The files of the project, as they are now; without git the whole folder but its builds.
if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then git ls-files -co --exclude-standard -z; else
  find . -name 'build*' -prune -o -name results -prune -o -type f -print0; fi |
  while IFS= read -r -d '' file; do [ ! -e "$file" ] || printf '%s\0' "$file"; done |
  tar -c --null -T - | tar -x -C "$SCRATCH_SOURCE"

cd "$SCRATCH_SOURCE"
bash comparisons/setup/new law my-spring
bash comparisons/setup/new material my-solid
bash comparisons/setup/new effect my-effect
bash comparisons/setup/new damping-formula my-formula
bash comparisons/setup/new command my-command
if bash comparisons/setup/new law my-spring 2>/dev/null; then fail 'a name that is taken was accepted'; fi

# Objects that a changed file went into, by what the compiler said of them. A changed file of
# the build folder (a generated header) counts like one of the sources.
changed="$({ diff -rq "$SOURCE" "$SCRATCH_SOURCE" --exclude=.git --exclude='build*' --exclude=results || true; } |
  sed -n "s#^Files $SOURCE/\(.*\) and .*#\1#p")"
[ -n "$changed" ] || fail 'the generator changed nothing'
changed="$changed
generated/lumped/laws/law_headers.hpp
generated/fem/materials/elastic_model_headers.hpp
generated/fem/interface/interface_stamp.hpp
comparisons/app/stored_schemas.cpp"
ninja -C "$BUILD" -t deps | awk -v source="$SOURCE/" -v build="$BUILD/" -v changed="$changed" '
  BEGIN { n = split(changed, list, "\n"); for (i = 1; i <= n; ++i) set[list[i]] = 1 }
  /^[^ ]/ { object = $1; sub(/:$/, "", object); next }
  NF == 1 { file = $1
    if (index(file, build) == 1) file = substr(file, length(build) + 1)
    else if (index(file, source) == 1) file = substr(file, length(source) + 1)
    else sub(/^(\.\.\/)+/, "", file)
    if (file in set) print object }' | sort -u >"$CHANGED_OBJECTS"
[ -s "$CHANGED_OBJECTS" ] || fail "$BUILD holds no object that a list went into: build it first"

# Configured as BUILD was, so that objects have the same names and flags.
option() { sed -n "s#^$1:[A-Z]*=##p" "$BUILD/CMakeCache.txt" | head -n 1; }
arguments=()
for name in CMAKE_BUILD_TYPE CMAKE_CXX_COMPILER CMAKE_CXX_FLAGS CMAKE_CXX_FLAGS_DEBUG CMAKE_UNITY_BUILD \
  REBOUND_UNITY CMAKE_DISABLE_PRECOMPILE_HEADERS REBOUND_FEM REBOUND_BENCHMARKS; do
  value="$(option "$name")"
  [ -z "$value" ] || arguments+=("-D$name=$value")
done
"$cmake" -S "$SCRATCH_SOURCE" -B "$SCRATCH_BUILD" -G Ninja "${arguments[@]}" -DREBOUND_TESTS=ON \
  -DCMAKE_CXX_COMPILER_LAUNCHER="bash;$SOURCE/tests/scratch/reuse_object.sh" >"$scratch/configure.log" 2>&1 ||
  { tail -20 "$scratch/configure.log"; fail 'the scratch copy does not configure'; }
: >"$SCRATCH_BUILD/compiled.txt"
programs=(rebound test_lumped unit_effects cli_tests)
[ "$(option REBOUND_FEM)" = OFF ] || programs+=(rebound_fem test_fem_parts verify_fem)
ninja -C "$SCRATCH_BUILD" "${programs[@]}" >"$scratch/build.log" 2>&1 ||
  { grep -E 'error|FAILED' "$scratch/build.log" | head -20; fail 'the scratch copy does not build'; }
echo "compiled $(wc -l <"$SCRATCH_BUILD/compiled.txt") units of $(grep -c 'Building' "$scratch/build.log")"

exec bash "$SOURCE/tests/scratch/use_one_of_each.sh" "$SCRATCH_BUILD" "$scratch/run" "$(option REBOUND_FEM)"
