"""What every command prints under --json against the schema that `rebound schema NAME --output` gives.

usage: output_schema_test.py PROGRAM TRIAL-GENERATOR STUDY
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import jsonschema
from cases import Outputs

PROGRAM, TRIAL_GENERATOR, STUDY = sys.argv[1:]


def commands():
    printed = subprocess.run([PROGRAM, "--help"], capture_output=True, check=True, text=True).stdout
    listed = printed.split("Subcommands:\n")[1].split("\n\n")[0]
    return [line.split()[0] for line in listed.splitlines()]


def validator(name):
    schema = json.loads(subprocess.run([PROGRAM, "schema", name, "--output"], capture_output=True, check=True).stdout)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def complaints(valid, printed):
    return [f"{'/'.join(map(str, error.absolute_path))}: {error.message[:300]}" for error in valid.iter_errors(printed)]


def with_a_key_renamed(value):
    """Copies of an object, in each of which one key of one object has another name."""
    if isinstance(value, list):
        for place, inner in enumerate(value[:1]):
            for changed in with_a_key_renamed(inner):
                yield value[:place] + [changed] + value[place + 1:]
    elif isinstance(value, dict):
        for key, inner in value.items():
            yield {(name + "_renamed" if name == key else name): other for name, other in value.items()}
            for changed in with_a_key_renamed(inner):
                yield {**value, key: changed}


# Objects whose keys are names of the data, so that any key may stand there: renaming one is no fault.
FREE = {"init", "schema"}
FREE_KEYS = {"sensitivities", "regions", "scalars", "numbers", "origins", "controls", "confusion", "confusion_by_name",
             "rates", "false_alarms_by_noise", "not_wrong_by_form", "rules", "parameters"}


def without_free(value):
    """The object with those whose keys are data left out."""
    if isinstance(value, list):
        return [without_free(inner) for inner in value]
    if isinstance(value, dict):
        return {key: {} if key in FREE_KEYS and isinstance(inner, dict) else without_free(inner)
                for key, inner in value.items()}
    return value


def keys_of(schema, root, found, path="", depth=0):
    """Paths of all keys that a schema names, `[]` for each of a list."""
    if "$ref" in schema:
        return  # of another command, looked at there
    for name, inner in schema.get("properties", {}).items():
        found.add(f"{path}.{name}")
        keys_of(inner, root, found, f"{path}.{name}", depth + 1)
    if isinstance(schema.get("items"), dict):
        keys_of(schema["items"], root, found, path + "[]", depth + 1)


def printed_keys(value, found, path=""):
    if isinstance(value, dict):
        for key, inner in value.items():
            found.add(f"{path}.{key}")
            printed_keys(inner, found, f"{path}.{key}")
    elif isinstance(value, list):
        for inner in value:
            printed_keys(inner, found, path + "[]")


# Keys that need data which take minutes to diagnose, or a run of all verifications.
RARE = {
    "diagnose": (".curve", ".curves", ".nearest_formulas", ".contradictions", ".next_experiments", ".excluded_above", ".in_fem", ".fem_with_nothing_hidden", ".law_alone", ".fem_balls", ".gap_of_shots_in_fem"),
    "inspect": (".contradictions",),
    "verify": (".seeded_faults",),
    "trials": (".in_fem.", ".fem_believed"),
    "study": (".experiments", ".cores[].simulation.effects[].parameters[]", ".joint_simulation.effects[].variants[].cores[].parameters[]"),
}


class OutputSchemas(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.outputs = Outputs(PROGRAM, TRIAL_GENERATOR, STUDY, pathlib.Path(folder.name))

    def test_every_command_prints_what_its_schema_says(self):
        for command in commands():
            valid, cases = validator(command), self.outputs.of(command)
            self.assertTrue(cases, f"no case of {command}")
            for case, printed in cases:
                with self.subTest(" ".join(case)):
                    self.assertEqual(complaints(valid, printed), [])

    def test_a_renamed_key_is_noticed(self):
        renamed = 0
        for command in commands():
            if command in FREE:
                continue
            valid = validator(command)
            for case, printed in self.outputs.of(command):
                plain = without_free(printed)
                if complaints(valid, plain):  # what was left out is required to hold something
                    plain = {key: value for key, value in printed.items() if not isinstance(value, (dict, list))}
                before = len(complaints(valid, plain))
                for changed in with_a_key_renamed(plain):
                    renamed += 1
                    self.assertGreater(len(complaints(valid, changed)), before, f"{case}: {changed}"[:2000])
        self.assertGreater(renamed, 1000)
        print(f"{renamed} renamed keys were noticed")

    def test_every_key_of_a_schema_is_printed_by_some_case(self):
        for command in commands():
            if command == "schema":
                continue
            named, printed = set(), set()
            schema = validator(command).schema
            keys_of(schema, schema, named)
            for _, output in self.outputs.of(command):
                printed_keys(output, printed)
            never = {key for key in named - printed if not key.startswith(RARE.get(command, ()) or ("-",))}
            with self.subTest(command):
                self.assertEqual(never, set())

    def test_errors_have_one_form(self):
        valid = validator("error")
        for arguments in (["lumped", "fem.toml"], ["fem", "nowhere.toml"], ["lumped"], ["bounce"]):
            printed = self.outputs.run(arguments, expected=(2, 4))
            self.assertEqual(complaints(valid, printed), [], arguments)
        several = self.outputs.folder / "several.toml"
        several.write_text("schema = 1\n[impact]\nspeed = 15\n[sphere]\nmass = 3\n", encoding="utf-8")
        printed = self.outputs.run(["lumped", "several.toml"], expected=(2,))
        self.assertGreater(len(printed["errors"]), 1)
        self.assertEqual(complaints(valid, printed), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
