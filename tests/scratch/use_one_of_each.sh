#!/usr/bin/env bash
# use_one_of_each.sh BUILD-FOLDER RUN-FOLDER ON|OFF
# Runs what one_of_each.sh has added: my-spring, my-solid, my-effect, my-formula, my-command.
set -euo pipefail
build="$1" run="$2" fem="$3"
rebound="$build/rebound"
rm -rf "$run" && mkdir -p "$run" && cd "$run"
fail() { echo "use_one_of_each: $*" >&2; exit 1; }
says() { "$rebound" "${@:2}" >said.txt 2>said_wrong.txt || { cat said_wrong.txt >&2; fail "rebound ${*:2}"; }
         grep -q -- "$1" said.txt || fail "'rebound ${*:2}' does not say $1"; }
battery() { "$build/$1" --gtest_filter="$2" >battery.txt || { cat battery.txt >&2; fail "$1 $2"; }
            ! grep -q '0 tests from 0 test suites ran' battery.txt || fail "$1 has no test $2"
            sed -n 's/^\[  PASSED  \]/&/p' battery.txt; }

# The lists: help and schema.
says my-command --help
says 'Says a word back' my-command --help
says '"word": "hello"' my-command hello --json
says 'rebound my-command' schema my-command --output
for word in my-spring my-effect my-formula; do says "$word" lumped --help; says "$word" schema lumped; done
for word in my-solid my-effect; do says "$word" fem --help; says "$word" schema fem; done
says my-spring calibrate --help
says my-spring benchmark --help
says my-effect synthesize --help

# The law and the effect, lumped; the law is calibrated, scored and converted.
impact='schema = 1
[impact]
speed = "15 m/s"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "lumped"
'
printf '%s' "$impact" 'law = "my-spring"
stiffness = "2.5e5 N/m"
damping = "60 N.s/m"
' >law.toml
says restitution lumped law.toml --out reference
says sensitivit lumped law.toml --sensitivities
cp law.toml effect.toml
printf '[[model.effect]]\nname = "my-effect"\nsize = 0.2\n' >>effect.toml
says restitution lumped effect.toml --out stiffer
peak() { sed -n 's/.*"peak_force_N": \([0-9.e+]*\).*/\1/p' "$1/result.json" | head -n 1; }
awk -v plain="$(peak reference)" -v stiffer="$(peak stiffer)" \
  'BEGIN { exit !(plain > 0 && stiffer > 1.05 * plain) }' || fail 'the effect does not move the peak force'
printf '%s' "$impact" 'law = "hunt-crossley"
stiffness = "3.5e6 N/m^1.5"
restitution = 0.6
damping_formula = "my-formula"
' >formula.toml
says restitution lumped formula.toml
printf 'schema = 1\n[[law]]\nlabel = "mine"\nlaw = "my-spring"\n[[law]]\nlabel = "other"\nlaw = "hunt-crossley"\n[[reference]]\nfolder = "reference"\n' >benchmark.toml
says mine benchmark benchmark.toml
printf 'schema = 1\n[impact]\nspeed = "15 m/s"\n[sphere]\nmass = "89.6 g"\ndiameter = "66.2 mm"\n[given]\nconvention = "law"\nlaw = "my-spring"\n[given.parameters]\nstiffness = "2.5e5 N/m"\ndamping = "60 N.s/m"\n' >convert.toml
says 'hunt-crossley/my-formula' convert convert.toml

# The batteries.
battery test_lumped '*LawBattery*/myspring'
battery test_lumped 'DampingFormulasTest.*'
battery unit_effects '*EffectBattery*/my_effect'
battery unit_effects 'EffectCompositionTest.*'
battery cli_tests 'HelpTest.*'

[ "$fem" = OFF ] && exit 0
fem_file() { printf '%s' 'schema = 1
[impact]
speed = "15 m/s"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "fem"
cells = 250
'; printf '%s' "$1"; printf '[model.material]\nelastic = "my-solid"\nyoungs_modulus = "10 MPa"\npoisson_ratio = 0.4\n'; }
fem_file '' >material.toml
says restitution fem material.toml --out fem_plain
fem_file $'[[model.effect]]\nname = "my-effect"\nsize = 0.2\n' >fem_effect.toml
says restitution fem fem_effect.toml --out fem_stiffer
awk -v plain="$(peak fem_plain)" -v stiffer="$(peak fem_stiffer)" \
  'BEGIN { exit !(plain > 0 && stiffer > 1.05 * plain) }' || fail 'the effect does not move the FE peak force'
# One of its cells does the work of four; unoptimised, 250 would take minutes.
fem_file $'scheme = "implicit"\n' | sed 's/^cells = 250/cells = 60/' >implicit.toml
says restitution fem implicit.toml
battery test_fem_parts 'MaterialBattery*'
battery test_fem_parts 'MaterialLimits*:UniaxialTest*'
battery verify_fem 'EffectImpact.EveryFormRunsAndMovesAsItsCardSays'
