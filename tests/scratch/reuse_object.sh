#!/usr/bin/env bash
# reuse_object.sh COMPILER ARGUMENT...: compiler launcher of the scratch build.
#
# Takes the object over from the build that is there when nothing it was made from differs in
# the scratch copy; compiles otherwise. Of the environment: SCRATCH_SOURCE, SCRATCH_BUILD, BUILD
# and CHANGED_OBJECTS, a file with the objects that a changed file went into, one a line.
set -euo pipefail
object='' dependencies='' source='' before=''
for argument in "$@"; do
  case "$before" in -o) object="$argument" ;; -MF) dependencies="$argument" ;; -c) source="$argument" ;; esac
  before="$argument"
done
compiler="$1"; shift
# Without optimisation, for it is used for seconds. Kernels keep theirs: unoptimised, inline functions
# of one instruction set would be shared with another.
compile() {
  echo "$object" >>"$SCRATCH_BUILD/compiled.txt"
  case "$source" in */fem/kernel/* | '') exec "$compiler" "$@" ;; esac
  exec "$compiler" "$@" -O0
}
{ [ -n "$object" ] && [ -f "$BUILD/$object" ]; } || compile "$@"
! grep -qxF "$object" "$CHANGED_OBJECTS" || compile "$@"
# A file that CMake wrote (several sources in one) is compared with paths made the same.
case "$source" in
  "$SCRATCH_BUILD"/*)
    cmp -s <(sed "s#$SCRATCH_BUILD#BUILD#g; s#$SCRATCH_SOURCE#SOURCE#g" "$source") \
           <(sed "s#$BUILD#BUILD#g; s#$SOURCE#SOURCE#g" "$BUILD/${source#"$SCRATCH_BUILD"/}") || compile "$@" ;;
esac
cp "$BUILD/$object" "$object"
[ -z "$dependencies" ] || printf '%s:\n' "$object" >"$dependencies"
