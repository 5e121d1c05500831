"""The Python module against the program that was built beside it.

In the environment: REBOUND_PROGRAM; PYTHONPATH holds the module's folder.
"""
import json
import subprocess
import time
import unittest

import numpy as np
import rebound_impact as ri
from program import CORE, PROGRAM, WithExamples, printed, without_times


class LumpedTest(WithExamples):
    def test_numbers_are_those_of_the_command(self):
        file = self.folder / "lumped.toml"
        self.assertEqual(without_times(ri.lumped(file).as_dict()),
                         without_times(printed("lumped", file)))

    def test_file_text_and_keywords_are_one_problem(self):
        file = self.folder / "lumped.toml"
        expected = without_times(ri.lumped(file).as_dict())
        self.assertEqual(without_times(ri.lumped(text=file.read_text()).as_dict()), expected)
        self.assertEqual(without_times(ri.lumped(**CORE).as_dict()), expected)

    def test_arrays(self):
        result = ri.lumped(**CORE)
        for values in (result.time, result.force, result.deflection):
            self.assertEqual(values.shape, (401,))
            self.assertEqual(values.dtype, np.float64)
            self.assertFalse(values.flags.writeable)
        self.assertEqual(result.time[-1], result.contact_time)
        self.assertAlmostEqual(result.force.max() / result.peak_force, 1.0, places=4)

    def test_arrays_outlive_the_result(self):
        force = ri.lumped(**CORE).force
        expected = force.copy()
        others = [ri.lumped(**CORE) for _ in range(20)]
        self.assertEqual(len(others), 20)
        np.testing.assert_array_equal(force, expected)

    def test_effects_act(self):
        model = dict(CORE["model"], effect=[{"name": "relaxation", "size": 0.4}])
        self.assertLess(ri.lumped(**dict(CORE, model=model)).restitution,
                        ri.lumped(**CORE).restitution - 0.01)

    def test_replaced_numbers_are_those_of_a_file_with_them(self):
        slow = ri.LumpedProblem(**CORE).replace({"impact.speed": 5.0, "model.stiffness": 2e6})
        model = dict(CORE["model"], stiffness="2e6 N/m^1.5")
        expected = ri.lumped(**dict(CORE, impact={"speed": "5 m/s"}, model=model))
        self.assertEqual(slow.simulate().restitution, expected.restitution)
        self.assertEqual(slow.numbers["impact.speed"], 5.0)

    def test_damping_from_a_restitution_follows_a_replaced_mass(self):
        model = {"law": "hunt-crossley", "stiffness": 3.5e6, "restitution": 0.6,
                 "damping_formula": "exact"}
        problem = ri.LumpedProblem(**dict(CORE, model=model))
        heavy = problem.replace({"sphere.mass": 0.12, "impact.speed": 8.0})
        self.assertAlmostEqual(heavy.simulate().restitution, 0.6, places=5)


class ManyTest(WithExamples):
    def test_rows_are_those_of_single_impacts(self):
        problem = ri.LumpedProblem(**CORE)
        speeds = [2.0, 7.5, 21.0]
        many = ri.simulate_many([problem.replace({"impact.speed": v}) for v in speeds])
        self.assertEqual(many["force"].shape, (3, 401))
        self.assertEqual(many["restitution"].dtype, np.float64)
        for row, speed in enumerate(speeds):
            one = problem.replace({"impact.speed": speed}).simulate()
            self.assertAlmostEqual(many["restitution"][row], one.restitution, places=6)
            np.testing.assert_allclose(many["force"][row], one.force, atol=1e-5 * one.peak_force)

    def test_threads_change_nothing(self):
        problem = ri.LumpedProblem(**CORE)
        problems = [problem.replace({"impact.speed": v}) for v in np.linspace(1, 30, 200)]
        alone, together = (ri.simulate_many(problems, threads=n) for n in (1, 2))
        for name, values in alone.items():
            np.testing.assert_array_equal(values, together[name])

    def test_ten_thousand_traces(self):
        problem = ri.LumpedProblem(**CORE)
        problems = [problem.replace({"impact.speed": v}) for v in np.linspace(1, 30, 10_000)]
        processor = time.process_time()
        many = ri.simulate_many(problems)
        processor = time.process_time() - processor
        self.assertEqual(many["force"].shape, (10_000, 401))
        self.assertTrue((np.diff(many["restitution"]) < 0).all())  # faster loses more
        print(f"10000 traces in {processor:.2f} s of processor time")
        # Machines differ; a trace by CVODE, or one parsed anew, costs a millisecond and more.
        self.assertLess(processor, 10.0)

    def test_unequal_samples_are_refused(self):
        problem = ri.LumpedProblem(**CORE)
        with self.assertRaises(ri.Error) as caught:
            ri.simulate_many([problem, problem.replace({"controls.samples": 100})])
        self.assertEqual(caught.exception.key, "controls.samples")

    def test_interruption(self):
        fine = ri.LumpedProblem(**CORE).replace({"controls.relative_tolerance": 1e-13})
        waited = self.interrupted_after(
            1.0, lambda: ri.simulate_many([fine] * 1_000_000, traces=False))
        self.assertLess(waited, 1.0)


class ErrorTest(WithExamples):
    def refusal(self, work, *arguments, **keywords):
        with self.assertRaises(ri.Error) as caught:
            work(*arguments, **keywords)
        return caught.exception

    def test_attributes_are_those_of_the_command(self):
        file = self.folder / "bad.toml"
        file.write_text((self.folder / "lumped.toml").read_text().replace('"15 m/s"', '"-15 m/s"'))
        error = self.refusal(ri.lumped, file)
        run = subprocess.run([PROGRAM, "lumped", file, "--json"], capture_output=True)
        expected = json.loads(run.stdout)["error"]
        for name in ("file", "line", "column", "key", "value", "allowed", "message"):
            self.assertEqual(getattr(error, name), expected[name], name)
        self.assertEqual(error.exit_code, run.returncode)
        self.assertEqual(error.exit_code, 2)

    def test_keywords_have_a_key_and_no_line(self):
        error = self.refusal(ri.lumped, **dict(CORE, impact={"speed": -1.0}))
        self.assertEqual((error.key, error.file, error.line), ("impact.speed", None, None))
        self.assertIn("1000 m/s", error.allowed)
        self.assertIn("impact.speed", str(error))

    def test_a_misspelt_key_gets_the_near_one(self):
        self.assertIn("stiffness", str(self.refusal(
            ri.lumped, **dict(CORE, model=dict(CORE["model"], stifness=1.0)))))

    def test_a_plain_number_in_a_text_needs_its_unit(self):
        text = (self.folder / "lumped.toml").read_text().replace('"15 m/s"', "15")
        self.assertEqual(self.refusal(ri.lumped, text=text).key, "impact.speed")

    def test_what_no_file_can_hold_is_refused(self):
        error = self.refusal(ri.lumped, **dict(CORE, impact={"speed": object()}))
        self.assertEqual(error.key, "impact.speed")

    def test_replacing_what_is_not_there_names_what_is(self):
        error = self.refusal(ri.LumpedProblem(**CORE).replace, {"impact.sped": 1.0})
        self.assertEqual(error.key, "impact.sped")
        self.assertIn("impact.speed", error.allowed)

    def test_a_replaced_number_out_of_range_is_refused(self):
        error = self.refusal(ri.LumpedProblem(**CORE).replace, {"impact.speed": float("nan")})
        self.assertEqual(error.key, "impact.speed")

    def test_nothing_and_too_much_are_refused(self):
        self.refusal(ri.lumped)
        self.refusal(ri.lumped, self.folder / "lumped.toml", text="schema = 1")

    def test_a_missing_file(self):
        self.assertEqual(self.refusal(ri.lumped, self.folder / "gone.toml").exit_code, 4)


class CardsTest(unittest.TestCase):
    def test_laws(self):
        laws = {law["name"]: law for law in ri.laws()}
        numbers = [p["name"] for p in laws["hunt-crossley"]["parameters"]]
        self.assertEqual(numbers, ["exponent", "stiffness", "damping"])
        self.assertEqual(laws["hunt-crossley"]["parameters"][0]["highest"], 5.0)
        self.assertEqual(laws["hunt-crossley"]["parameters"][1]["unit"], "N/m^1.5")

    def test_effects(self):
        effects = {effect["name"]: effect for effect in ri.effects()}
        self.assertEqual(effects["relaxation"]["acts_on"], ["lumped", "fem"])
        self.assertEqual(effects["relaxation"]["parameters"][0]["unit"], "s")


class ExperimentTest(WithExamples):
    def test_synthesis_is_that_of_the_command(self):
        file = self.folder / "synthesis.toml"
        dataset, truth = ri.synthesize(file, out=self.folder / "made")
        out = self.folder / "printed"
        printed("synthesize", file, "--out", out)
        self.assertEqual(truth["effects"], json.loads((out / "truth.json").read_text())["effects"])
        command = ri.read_dataset(out / "data")
        written = ri.read_dataset(self.folder / "made")
        self.assertEqual(len(dataset.shots), 3)
        for made, read, again in zip(dataset.shots, command.shots, written.shots):
            self.assertEqual(made.speed, read.speed)
            np.testing.assert_array_equal(made.force, read.force)
            np.testing.assert_array_equal(made.force, again.force)
            self.assertEqual((made.force.dtype, made.force.ndim), (np.float64, 1))
            self.assertGreater(made.force.size, 300)

    def test_shots_outlive_their_dataset(self):
        dataset, _ = ri.synthesize(self.folder / "synthesis.toml")
        force = dataset.shots[1].force
        expected = force.copy()
        del dataset
        np.testing.assert_array_equal(force, expected)

    def test_scalars_have_their_uncertainty(self):
        shot = ri.read_dataset(self.folder / "dataset").shots[0]
        self.assertEqual(shot.restitution, (0.527, 0.01))
        self.assertIsNone(shot.peak_force)

    def test_diagnosis_is_that_of_the_command(self):
        out = self.folder / "experiment"
        printed("synthesize", self.folder / "synthesis.toml", "--out", out)
        model = self.folder / "lumped.toml"
        expected = printed("diagnose", out / "data", "--model", model, "--no-bootstrap",
                           "--out", self.folder / "diagnosis")
        found = ri.diagnose(out / "data", model, bootstrap=False)
        self.assertEqual(found["verdict"], "missing")
        for key in ("verdict", "effects", "gap", "held_out_speed_m_s"):
            if key in expected:
                self.assertEqual(found[key], expected[key], key)
        self.assertEqual(set(found), set(expected) - {"extended_models"} | {"extended_model"})
        alone = ri.diagnose(out / "data", model, bootstrap=False, ask_fem=False)
        self.assertEqual(alone["verdict"], "missing")
        self.assertEqual(alone["effects"][0]["tiers"]["fem"], "not-run")

    def test_interrupted_diagnosis(self):
        dataset, _ = ri.synthesize(self.folder / "synthesis.toml")
        waited = self.interrupted_after(
            1.0, lambda: [ri.diagnose(dataset, self.folder / "lumped.toml") for _ in range(100)])
        self.assertLess(waited, 1.0)

    def test_calibration_is_that_of_the_command(self):
        printed("lumped", self.folder / "lumped.toml", "--out", self.folder / "reference")
        file = self.folder / "calibrate.toml"
        self.assertEqual(ri.calibrate(file), printed("calibrate", file))


if __name__ == "__main__":
    unittest.main()
