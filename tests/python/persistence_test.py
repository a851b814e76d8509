# SPDX-License-Identifier: MIT
"""A learner that was saved, pickled or copied goes on as if nothing had happened, to the bit."""

import copy
import multiprocessing
import os
import pathlib
import pickle
import tempfile
import unittest
import zlib

import sspql
from every import CLASSES, steps
from maze import Maze


def started(cls, seed=4):
    """In the middle of an episode, at state 8."""
    learner = cls.for_env(Maze(), seed=seed)
    sspql.run_episodes(Maze(), learner, 4, max_steps=2000)
    learner.set_legal_actions(2, [True, False, True, True])
    learner.teach(1, 1, 0.5)
    learner.begin(7)
    learner.step(0.0, 8)
    return learner


def go_on(learner):
    learner.end(0.0, 8, False)
    return steps(sspql.run_episodes(Maze(), learner, 6, seed=70, max_steps=2000)), learner.to_bytes()


class Tired(sspql.Sarsa):
    """A user's own, with an attribute and another constructor."""

    def __init__(self, name):
        super().__init__(49, 4, seed=4)
        self.name = name


class Persistence(unittest.TestCase):
    def ways(self, learner, directory):
        path = os.path.join(directory, "learner.sspql")
        learner.save(path)
        yield "load", sspql.load(path)
        other = type(learner)(49, 4, seed=99, gamma=0.5)
        other.load(pathlib.Path(path))
        yield "member load", other
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            yield f"pickle {protocol}", pickle.loads(pickle.dumps(learner, protocol))
        yield "copy", copy.copy(learner)
        yield "deepcopy", copy.deepcopy(learner)
        yield "member copy", learner.copy()

    def test_goes_on_to_the_bit(self):
        for cls in CLASSES:
            learner = started(cls)
            with tempfile.TemporaryDirectory() as directory:
                others = list(self.ways(learner, directory))
            before = learner.to_bytes()
            expected = go_on(learner)
            for way, other in others:
                with self.subTest(f"{cls.__name__}: {way}"):
                    self.assertIs(type(other), cls)
                    self.assertEqual(other.to_bytes(), before)
                    self.assertEqual(other.parameters, learner.parameters)
                    self.assertEqual(go_on(other), expected)

    def test_a_copy_goes_its_own_way(self):
        learner = started(sspql.AdaptiveSspql)
        before = learner.to_bytes()
        go_on(learner.copy())
        self.assertEqual(learner.to_bytes(), before)

    def test_a_class_of_ones_own(self):
        mine = Tired("Robbie")
        mine.begin(3)
        for other in (copy.copy(mine), pickle.loads(pickle.dumps(mine)), copy.deepcopy(mine)):
            self.assertIs(type(other), Tired)
            self.assertEqual((other.name, other.state, other.action), ("Robbie", 3, mine.action))

    def test_processes(self):
        learners = [started(cls, seed) for seed in (1, 2) for cls in (sspql.AdaptiveSspql, sspql.DynaQ)]
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            there = pool.map(go_on, learners)
        self.assertEqual(there, [go_on(learner) for learner in learners])

    def test_parameters_come_with_the_checkpoint(self):
        learner = sspql.AdaptiveSspql(5, 3, trust={"cap": 20}, budget=(10, 100), gamma=0.9)
        self.assertEqual(learner.parameters["trust"]["cap"], 20.0)
        self.assertEqual(learner.parameters["budget"], (10, 100))
        again = sspql.AdaptiveSspql(5, 3, **learner.parameters)
        self.assertEqual(again.to_bytes(), learner.to_bytes())
        for cls in CLASSES:
            with self.subTest(cls.__name__):
                learner = cls(5, 3, seed=2)
                self.assertEqual(cls(5, 3, seed=2, **learner.parameters).to_bytes(), learner.to_bytes())

    def test_a_forged_size_asks_for_no_memory(self):
        data = bytearray(sspql.QLearning(3, 2).to_bytes())
        begin = 20  # the section "type": name (16), chunk length (4), "Q-learning" (8 + 10), states (8), ...
        at = begin + 16 + 4 + 8 + len("Q-learning")
        self.assertEqual(data[at : at + 8], (3).to_bytes(8, "little"))
        data[at : at + 8] = (2**31).to_bytes(8, "little")
        end = at + 8 + 8 + 1 + 4
        data[end : end + 4] = zlib.crc32(data[begin:end]).to_bytes(4, "little")
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "forged.sspql")
            pathlib.Path(path).write_bytes(data)
            with self.assertRaisesRegex(RuntimeError, "forged.sspql: .*more states than the file has room for"):
                sspql.load(path)

    def test_refusals_change_nothing(self):
        learner = started(sspql.QLearning)
        before = learner.to_bytes()
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "x.sspql")
            sspql.Sarsa(49, 4).save(path)
            with self.assertRaisesRegex(RuntimeError, "the file has the learner 'Sarsa', this learner 'Q-learning'"):
                learner.load(path)
            sspql.QLearning(48, 4).save(path)
            with self.assertRaisesRegex(RuntimeError, "the file has 48 states, this learner 49"):
                learner.load(path)
            with open(path, "r+b") as file:
                file.seek(60)
                file.write(b"\xff")
            with self.assertRaisesRegex(RuntimeError, "x.sspql: section '.*' is damaged"):
                sspql.load(path)
            with self.assertRaises(FileNotFoundError) as missing:
                learner.load(os.path.join(directory, "none"))
            self.assertEqual(missing.exception.filename, os.path.join(directory, "none"))
            with self.assertRaises(FileNotFoundError):
                learner.save(os.path.join(directory, "none", "x"))
            with self.assertRaises(IsADirectoryError):
                sspql.load(directory)
        with self.assertRaises(TypeError):
            learner.load(3)
        self.assertEqual(learner.to_bytes(), before)


if __name__ == "__main__":
    unittest.main()
