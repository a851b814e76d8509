# SPDX-License-Identifier: MIT
"""The same seeds give the same steps, values, counts and checkpoints as in C++, to the bit."""

import glob
import os
import subprocess
import tempfile
import unittest

import numpy as np

import sspql
from every import CLASSES, body, steps
from maze import Maze


def learners():
    """Those of parity.cpp."""
    return {
        "AdaptiveSspql": sspql.AdaptiveSspql(49, 4, seed=7),
        "Sspql": sspql.Sspql(49, 4, seed=7, preset="without_bonus"),
        "QLearning": sspql.QLearning(49, 4, seed=7, alpha=sspql.VisitDecay(0.5), gamma=0.95),
    }


def in_cpp(*arguments):
    """By learner: the steps that the program printed."""
    done = subprocess.run([os.environ["SSPQL_PARITY"], *arguments], capture_output=True, text=True, check=True)
    lines = [line.split() for line in done.stdout.splitlines()]
    return {line[0]: [int(word) for word in line[1:]] for line in lines}


class Parity(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    def check(self, name, learner):
        """What C++ wrote of this learner is what it is."""
        path = os.path.join(self.directory, name)
        with open(path + ".sspql", "rb") as file:
            self.assertEqual(file.read(), learner.to_bytes())
        self.assertEqual(np.load(path + ".q.npy").tobytes(), learner.q.tobytes())
        if hasattr(learner, "counts"):
            counts = np.load(path + ".counts.npy")
            self.assertEqual(counts.dtype, learner.counts().dtype)
            self.assertEqual(counts.tobytes(), learner.counts().tobytes())

    def test_the_same_steps_and_checkpoints(self):
        expected = in_cpp(self.directory)
        self.assertEqual(set(expected), set(learners()))
        for name, learner in learners().items():
            with self.subTest(name):
                self.assertEqual(steps(sspql.run_episodes(Maze(), learner, 20, seed=100)), expected[name])
                self.check(name, learner)

    def test_cpp_goes_on_from_what_python_saved_and_the_reverse(self):
        started = learners()
        for name, learner in started.items():
            sspql.run_episodes(Maze(), learner, 3, seed=100)
            learner.save(os.path.join(self.directory, name + ".python.sspql"))
        expected = in_cpp(self.directory, "go on")
        for name, learner in started.items():
            with self.subTest(name):
                self.assertEqual(steps(sspql.run_episodes(Maze(), learner, 20, seed=200)), expected[name])
                self.check(name, sspql.load(os.path.join(self.directory, name + ".sspql")))

    def test_checkpoints_written_long_ago(self):
        directory = os.path.join(os.environ["SSPQL_SOURCE"], "tests", "io", "data", "format-1")
        seen = set()
        for path in sorted(glob.glob(os.path.join(directory, "*.sspql"))):
            if os.path.basename(path) == "agent.sspql":  # of a learner that grows
                continue
            with self.subTest(path), open(path, "rb") as file:
                learner = sspql.load(path)
                self.assertEqual(body(learner.to_bytes()), body(file.read()))
                seen.add(type(learner))
        self.assertEqual(seen, set(CLASSES))
        with self.assertRaisesRegex(RuntimeError, "agent.sspql: .*the states of this learner grow in number"):
            sspql.load(os.path.join(directory, "agent.sspql"))


if __name__ == "__main__":
    unittest.main()
