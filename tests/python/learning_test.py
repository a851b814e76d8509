# SPDX-License-Identifier: MIT
"""Every learner learns the maze, through run_episodes and by hand."""

import unittest

import numpy as np

import sspql
from every import CLASSES, steps
from maze import Maze

# At best 12 moves lead to the goal; with the slips that takes 13.4 steps, a random walk 400.
SEEDS = range(1, 6)


class Learning(unittest.TestCase):
    def test_every_learner_learns_the_maze(self):
        for cls in CLASSES:
            with self.subTest(cls.__name__):
                first, last = [], []
                for seed in SEEDS:
                    learner = cls.for_env(Maze(), seed=seed)
                    went = sspql.run_episodes(Maze(), learner, 60, seed=1000 * seed, max_steps=5000)
                    first.append(went[0].steps)
                    last.append(np.mean(steps(went[-10:])))
                # Measured: at most 24 (Rtdp), and 190 or more in the first episode.
                self.assertLess(np.mean(last), 40.0, (first, last))
                self.assertGreater(np.mean(first), 100.0, (first, last))

    def test_the_way_without_exploration_is_the_best(self):
        for cls in CLASSES:
            with self.subTest(cls.__name__):
                learner = cls.for_env(Maze(slip=0), seed=2)
                sspql.run_episodes(Maze(slip=0), learner, 100, max_steps=5000)
                env = Maze(slip=0)
                state, _ = env.reset(seed=0)
                taken, done = 0, False
                while not done and taken < 100:
                    state, _, done, _, _ = env.step(learner.best(state))
                    taken += 1
                self.assertLessEqual(taken, 16)  # two detours at most

    def test_by_hand_as_run_episodes_does(self):
        by_hand = sspql.PrioritizedSweeping(49, 4, seed=5)
        env = Maze()
        expected = []
        for k in range(10):
            state, _ = env.reset(seed=30 + k)
            action = by_hand.begin(state)
            count, done = 0, False
            while not done:
                state, reward, done, _, _ = env.step(action)
                count += 1
                if done:
                    by_hand.end(reward, state, True)
                else:
                    action = by_hand.step(reward, state)
            expected.append(count)
        learner = sspql.PrioritizedSweeping(49, 4, seed=5)
        self.assertEqual(steps(sspql.run_episodes(Maze(), learner, 10, seed=30)), expected)
        self.assertEqual(learner.to_bytes(), by_hand.to_bytes())

    def test_seeds_decide(self):
        for cls in CLASSES:
            with self.subTest(cls.__name__):
                runs = []
                for seed in (1, 1, 2):
                    learner = cls.for_env(Maze(), seed=seed)
                    runs.append(steps(sspql.run_episodes(Maze(), learner, 5)))
                self.assertEqual(runs[0], runs[1])
                self.assertNotEqual(runs[0], runs[2])

    def test_the_parameters_count(self):
        patient = sspql.QLearning(49, 4, seed=1, gamma=0.99, initial_q=1.0)
        plain = sspql.QLearning(49, 4, seed=1)
        self.assertEqual(patient.q.min(), 1.0)
        self.assertNotEqual(steps(sspql.run_episodes(Maze(), patient, 5)), steps(sspql.run_episodes(Maze(), plain, 5)))
        self.assertLess(plain.q[0].max(), patient.q[0].max())

    def test_another_goal_needs_no_relearning(self):
        learner = sspql.AdaptiveSspql.for_env(Maze(slip=0), seed=1)
        sspql.run_episodes(Maze(slip=0), learner, 30)
        learner.set_goals([42])  # the lower left corner
        state, taken = 0, 0
        while state != 42 and taken < 50:
            env = Maze(slip=0)
            env.reset()
            env.cell = state
            state = env.step(learner.best(state))[0]
            taken += 1
        self.assertEqual(state, 42)
        learner.set_goals([(42, 0.0), (48, 2.5)])
        learner.set_goals([])

    def test_teachers(self):
        told = sspql.QLearning(49, 4, seed=1)
        told.teach(0, 1, 2.0)
        self.assertEqual(told.terms(0, 1).hint, 2.0)
        self.assertEqual(told.begin(0), 1)
        told.replace_action(3)
        self.assertEqual((told.running, told.state, told.action), (True, 0, 3))
        told.end(0.0, 1, False)
        self.assertEqual((told.running, told.state, told.action), (False, None, None))
        self.assertEqual(told.visits()[0].tolist(), [0, 0, 0, 1])
        told.observe(5, 2, 1.0, 6, True)
        self.assertEqual(told.q[5, 2], 0.8)  # alpha = 0.8
        told.demonstrate(7, 1, 0.0, 5, False)
        self.assertAlmostEqual(told.q[7, 1], 0.8 * 0.8 * 0.8)  # alpha gamma Q(5, 2)
        self.assertEqual(told.terms(7, 1).hint, 1.0)
        terms = told.terms(7, 1)
        self.assertEqual(terms.sum(), terms.q + terms.ssp + terms.exploration + terms.hint)
        self.assertEqual(repr(terms), "ActionTerms(q=0.512, ssp=0, exploration=0, hint=1, n=1)")


if __name__ == "__main__":
    unittest.main()
