"""FE impacts of the Python module against the program."""
import unittest

import numpy as np
import rebound_impact as ri
from program import CORE, WithExamples, printed, without_times


class FemTest(WithExamples):
    def test_numbers_are_those_of_the_command(self):
        file = self.folder / "fem.toml"
        result = ri.fem(file)
        self.assertEqual(without_times(result.as_dict()), without_times(printed("fem", file)))
        self.assertEqual(result.energies["stored"].shape, result.time.shape)
        self.assertEqual(result.force.dtype, np.float64)

    def test_keywords(self):
        result = ri.fem(sphere=CORE["sphere"], impact={"speed": 5}, model={
            "cells": 200,
            "material": {"elastic": "neo-hookean", "youngs_modulus": 10e6, "poisson_ratio": 0.4}})
        self.assertGreater(result.restitution_momentum, 0.9)

    def test_interruption(self):
        text = (self.folder / "fem.toml").read_text().replace("cells = 1000", "cells = 60000")
        waited = self.interrupted_after(1.0, lambda: ri.fem(text=text))
        self.assertLess(waited, 1.0)


if __name__ == "__main__":
    unittest.main()
