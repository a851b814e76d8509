# SPDX-License-Identifier: MIT
"""What is wrong is refused with a Python exception that says so, and nothing has changed then."""

import math
import unittest

import numpy as np

import sspql
from every import CLASSES

INTEGERS = (np.int8, np.uint16, np.int32, np.int64, np.uint64, int)


class Construction(unittest.TestCase):
    def refused(self, exception, text, cls, *arguments, **keywords):
        with self.assertRaisesRegex(exception, text):
            cls(*arguments, **keywords)

    def test_sizes_and_seeds(self):
        for cls in CLASSES:
            self.refused(ValueError, "number of states must lie between 1 and 4294967294, got 0", cls, 0, 2)
            self.refused(ValueError, "number of states .* got -1", cls, -1, 2)
            self.refused(ValueError, "number of actions .* got 0", cls, 3, 0)
            self.refused(ValueError, "number of actions .* got -7", cls, 3, -7)
            self.refused(ValueError, r"seed must lie between 0 and 2\^64 - 1, got -1", cls, 3, 2, seed=-1)
            self.refused(ValueError, "seed", cls, 3, 2, seed=2**64)
            self.refused(TypeError, "float", cls, 3.5, 2)
            self.refused(TypeError, "float", cls, 3, 2, seed=1.0)
            cls(3, 2, seed=2**64 - 1)
            cls(np.int32(3), np.uint8(2), seed=np.int64(5))

    def test_the_base_class_is_none_to_make(self):
        self.refused(TypeError, "AdaptiveSspql", sspql.Learner, 3, 2)

    def test_unknown_parameters(self):
        for cls in CLASSES:
            self.refused(TypeError, f"{cls.__name__} has no parameter 'gama'; it has gamma, ", cls, 3, 2, gama=0.9)
        self.refused(TypeError, "has no parameter 'trust.cop'; .* trust.cap", sspql.AdaptiveSspql, 3, 2, trust={"cop": 1})
        self.refused(TypeError, "trust must be a dict of its members, got 3", sspql.AdaptiveSspql, 3, 2, trust=3)
        self.refused(TypeError, "has no parameter 'gamma.x'", sspql.AdaptiveSspql, 3, 2, gamma={"x": 1})

    def test_values_of_another_type(self):
        self.refused(TypeError, "gamma must be a number, got '0.9'", sspql.QLearning, 3, 2, gamma="0.9")
        self.refused(TypeError, "gamma must be a number, got True", sspql.QLearning, 3, 2, gamma=True)
        self.refused(TypeError, "gamma must be a number, got None", sspql.QLearning, 3, 2, gamma=None)
        self.refused(TypeError, "expected must be True or False, got 1", sspql.Sarsa, 3, 2, expected=1)
        self.refused(TypeError, "planning_steps must be a whole number, got 1.5", sspql.DynaQ, 3, 2, planning_steps=1.5)
        self.refused(TypeError, r"budget must be two whole numbers \(per_step, bank\), got 40", sspql.AdaptiveSspql, 3, 2,
                     budget=40)
        self.refused(TypeError, "alpha must be a number, a VisitDecay or an ExponentialDecay, got 'x'", sspql.QLearning,
                     3, 2, alpha="x")
        self.refused(TypeError, "replay must be 'from_counts' or 'last_outcome', got 1", sspql.DynaQ, 3, 2, replay=1)
        sspql.QLearning(3, 2, gamma=np.float32(0.5), alpha=1, bonus=np.int64(2))
        self.assertIs(sspql.Sarsa(3, 2, expected=np.bool_(True)).parameters["expected"], True)

    def test_values_out_of_range(self):
        self.refused(ValueError, r"gamma must lie in \[0, 1\], got 1.5", sspql.QLearning, 3, 2, gamma=1.5)
        self.refused(ValueError, "noise must be finite and > 0, got 0", sspql.QLearning, 3, 2, noise=0)
        self.refused(ValueError, "got nan", sspql.QLearning, 3, 2, initial_q=math.nan)
        self.refused(ValueError, "planning_steps must lie between 0 and .*, got -1", sspql.DynaQ, 3, 2, planning_steps=-1)
        self.refused(ValueError, "replay must be 'from_counts' or 'last_outcome', got 'x'", sspql.DynaQ, 3, 2, replay="x")
        self.refused(ValueError, "trust.cap must lie in", sspql.AdaptiveSspql, 3, 2, trust={"cap": -1})
        self.refused(ValueError, "lambda must be finite and >= 0, got -1", sspql.Sspql, 3, 2, lambda_=-1)
        self.refused(ValueError, "exponent p of a visit decay must be finite and >= 0, got -1", sspql.VisitDecay, -1)
        self.refused(ValueError, "start of an exponential decay", sspql.ExponentialDecay, 0.1, 0.1, 0.2)
        self.refused(ValueError, "preset must be one of with_bonus, without_bonus, .* got sarsa", sspql.Sspql, 3, 2,
                     preset="sarsa")
        self.refused(ValueError, "preset must not be given", sspql.Sarsa, 3, 2, preset="sarsa")

    def test_presets_and_what_is_given_besides(self):
        parameters = sspql.PrioritizedSweeping(3, 2, preset="optimistic", cap=7).parameters
        self.assertEqual([parameters[name] for name in ("initial_q", "cap", "kappa")], [1.0, 7.0, 0.05])

    def test_schedules(self):
        decay = sspql.ExponentialDecay(rate=0.5)
        self.assertEqual(decay, sspql.ExponentialDecay(1.0, 0.5, 0.0))
        self.assertNotEqual(decay, sspql.ExponentialDecay(1.0, 0.6, 0.0))
        self.assertEqual({decay: 1}[sspql.ExponentialDecay(rate=0.5)], 1)
        self.assertNotEqual(sspql.VisitDecay(2), decay)
        self.assertEqual(repr(decay), "ExponentialDecay(start=1.0, rate=0.5, floor=0.0)")
        self.assertEqual(repr(sspql.VisitDecay(0.5)), "VisitDecay(p=0.5)")
        self.assertEqual(sspql.QLearning(3, 2, alpha=decay).parameters["alpha"], decay)


class Calls(unittest.TestCase):
    def setUp(self):
        self.learners = [cls(5, 3, seed=1) for cls in CLASSES]

    def refused(self, exception, text, call):
        for learner in self.learners:
            before = learner.to_bytes()
            with self.subTest(type(learner).__name__):
                with self.assertRaisesRegex(exception, text):
                    call(learner)
                self.assertEqual(learner.to_bytes(), before)

    def test_ids_outside(self):
        for outside in (5, -1, 2**31, 2**32, 2**32 + 1, -(2**63)):
            text = f"state must be below the number of states 5, got {outside}"
            self.refused(ValueError, text, lambda learner: learner.begin(outside))
            self.refused(ValueError, text, lambda learner: learner.best(outside))
            self.refused(ValueError, text, lambda learner: learner.terms(outside, 0))
            self.refused(ValueError, text, lambda learner: learner.observe(outside, 0, 0.0, 0, False))
            self.refused(ValueError, f"next {text}", lambda learner: learner.observe(0, 0, 0.0, outside, False))
            self.refused(ValueError, text, lambda learner: learner.set_legal_actions(outside, [1, 1, 1]))
            self.refused(ValueError, "goal must be", lambda learner: learner.set_goals([0, outside]))
            text = f"action must be below the number of actions 3, got {outside}"
            self.refused(ValueError, text, lambda learner: learner.terms(0, outside))
            self.refused(ValueError, text, lambda learner: learner.teach(0, outside))
        self.refused(TypeError, "state: int", lambda learner: learner.begin(1.0))
        self.refused(TypeError, "state: int", lambda learner: learner.begin("1"))
        self.refused(TypeError, "state: int", lambda learner: learner.begin(2**70))

    def test_any_whole_number_is_an_id(self):
        for learner in self.learners:
            for integer in INTEGERS:
                self.assertIs(type(learner.begin(integer(4))), int)
                learner.step(np.float32(0.5), integer(3))
                learner.end(integer(1), np.array(2), np.bool_(True))

    def test_order_of_calls(self):
        self.refused(RuntimeError, r"step\(\) before begin\(\)", lambda learner: learner.step(0.0, 1))
        self.refused(RuntimeError, r"end\(\) before begin\(\)", lambda learner: learner.end(0.0, 1, True))
        self.refused(RuntimeError, r"replace_action\(\) before begin\(\)", lambda learner: learner.replace_action(1))
        for learner in self.learners:
            learner.begin(0)
        self.refused(RuntimeError, r"begin\(\) during an episode", lambda learner: learner.begin(0))
        for learner in self.learners:
            learner.abort()
            learner.begin(0)

    def test_rewards_and_weights(self):
        for learner in self.learners:
            learner.begin(0)
        self.refused(ValueError, "reward must be finite, got nan", lambda learner: learner.step(math.nan, 1))
        self.refused(ValueError, "reward must lie in", lambda learner: learner.end(1e101, 1, True))
        self.refused(ValueError, "weight must lie in", lambda learner: learner.step(0.0, 1, weight=0.0))
        self.refused(ValueError, "strength", lambda learner: learner.teach(0, 0, math.inf))

    def test_masks_and_goals(self):
        self.refused(ValueError, "mask .* allow an action", lambda learner: learner.set_legal_actions(0, [0, 0, 0]))
        self.refused(ValueError, "mask .* allow an action", lambda learner: learner.set_legal_actions(0, []))
        self.refused(ValueError, "size of the mask must be 3, got 2", lambda learner: learner.set_legal_actions(0, [1, 0]))
        self.refused(ValueError, "True or False .* got 2", lambda learner: learner.set_legal_actions(0, [0, 1, 2]))
        self.refused(TypeError, "a goal must be a state or a pair .* got 'x'", lambda learner: learner.set_goals(["x"]))
        self.refused(TypeError, "a goal must be", lambda learner: learner.set_goals([(1, 2, 3)]))
        self.refused(TypeError, "goals: Iterable", lambda learner: learner.set_goals(3))
        self.refused(ValueError, "got -1", lambda learner: learner.set_goals([(1, -1.0)]))
        for learner in self.learners:
            learner.set_legal_actions(1, np.array([0, 1, 0], dtype=np.int8))
            self.assertEqual(learner.legal_actions(1).tolist(), [False, True, False])
            self.assertEqual(learner.legal_actions(2).tolist(), [True, True, True])
            self.assertEqual((learner.best(1), learner.begin(1)), (1, 1))
            learner.set_goals(np.array([2, 3]))


if __name__ == "__main__":
    unittest.main()
