# SPDX-License-Identifier: MIT
"""What is a view and what a copy, and that no view outlives its memory."""

import gc
import os
import tempfile
import unittest

import numpy as np

import sspql
from every import CLASSES
from maze import Maze


def learnt(cls, episodes=5, **keywords):
    learner = cls.for_env(Maze(), seed=3, **keywords)
    sspql.run_episodes(Maze(), learner, episodes, max_steps=2000)
    return learner


class Views(unittest.TestCase):
    def test_q_is_one_array_in_one_place(self):
        for cls in CLASSES:
            with self.subTest(cls.__name__):
                learner = learnt(cls)
                q = learner.q
                self.assertEqual((q.shape, q.dtype), ((49, 4), np.dtype(np.float64)))
                self.assertTrue(q.flags.c_contiguous)
                self.assertFalse(q.flags.owndata)
                self.assertEqual(q.ctypes.data, learner.q.ctypes.data)
                self.assertTrue(np.shares_memory(q, learner.q))

    def test_q_shows_what_is_learnt_later(self):
        for cls in CLASSES:
            with self.subTest(cls.__name__):
                learner = learnt(cls, 2)
                q = learner.q
                place = q.ctypes.data
                before = q.copy()
                sspql.run_episodes(Maze(), learner, 10, seed=50, max_steps=2000)
                learner.set_legal_actions(3, [1, 1, 1, 0])
                learner.teach(2, 1)
                self.assertFalse(np.array_equal(q, before))
                self.assertEqual(learner.q.ctypes.data, place)
                np.testing.assert_array_equal(q, learner.q)
                learner.set_goals([12])  # values start over, in the same place
                self.assertEqual(learner.q.ctypes.data, place)
                np.testing.assert_array_equal(q, learner.q)

    def test_q_holds_what_terms_say(self):
        learner = learnt(sspql.QLearning)
        for s in range(learner.states):
            for a in range(learner.actions):
                self.assertEqual(learner.q[s, a], learner.terms(s, a).q)
        np.testing.assert_array_equal(learner.policy(), learner.q.argmax(axis=1))

    def test_q_cannot_be_written_to(self):
        q = learnt(sspql.Sarsa).q
        with self.assertRaises(ValueError):
            q[0, 0] = 1.0
        with self.assertRaises(ValueError):
            q.setflags(write=True)

    def test_a_view_keeps_the_learner_alive(self):
        for cls in CLASSES:
            with self.subTest(cls.__name__):
                learner = learnt(cls)
                q = learner.q
                row = learner.q[44:]  # a view of a view
                expected = q.copy()
                del learner
                gc.collect()
                clutter = [np.full(196, 9.0) for _ in range(50)]  # would land in freed memory
                np.testing.assert_array_equal(q, expected)
                del q
                gc.collect()
                clutter += [np.full(196, 8.0) for _ in range(50)]
                np.testing.assert_array_equal(row, expected[44:])

    def test_after_load_a_view_stays_what_it_was(self):
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "q.sspql")
            learner = learnt(sspql.QLearning, 1)
            learner.save(path)
            sspql.run_episodes(Maze(), learner, 9)
            old = learner.q
            expected = old.copy()
            learner.load(path)
            gc.collect()
            clutter = [np.full(196, 9.0) for _ in range(50)]
            np.testing.assert_array_equal(old, expected)
            self.assertFalse(np.array_equal(learner.q, old))
            self.assertEqual(len(clutter), 50)


class Copies(unittest.TestCase):
    def test_counts_are_what_happened(self):
        seen = {}

        class Watched(Maze):
            def step(self, action):
                before = self.cell
                outcome = super().step(action)
                key = (before, action, self.cell)
                n, rewards, _ = seen.get(key, (0, 0.0, False))
                seen[key] = (n + 1, rewards + outcome[1], outcome[2])
                return outcome

        learner = sspql.DynaQ.for_env(Maze(), seed=3)
        sspql.run_episodes(Watched(), learner, 5)
        counts = learner.counts()
        rows = {(int(r["s"]), int(r["a"]), int(r["next"])): (r["n"], r["reward_sum"], r["terminal"]) for r in counts}
        self.assertEqual(rows, seen)
        self.assertEqual(list(rows), sorted(rows))
        np.testing.assert_array_equal(counts["weight"], 1.0)
        visits = np.zeros((49, 4), dtype=int)
        np.add.at(visits, (counts["s"], counts["a"]), counts["n"].astype(int))
        np.testing.assert_array_equal(learner.visits(), visits)

    def test_counts_of_a_learner_with_whole_counts(self):
        learner = learnt(sspql.Sspql)
        counts = learner.counts()
        self.assertEqual(counts.dtype.names, ("s", "a", "next", "n", "weight", "terminal"))
        self.assertEqual(counts["n"].dtype, np.dtype(np.int64))
        self.assertEqual(counts["n"].sum(), learner.visits().sum())

    def test_learners_without_a_model_have_no_counts(self):
        for cls in (sspql.QLearning, sspql.Sarsa, sspql.DynaQPlus):
            self.assertFalse(hasattr(cls, "counts"), cls)

    def test_copies_do_not_change(self):
        learner = learnt(sspql.AdaptiveSspql, 2)
        copies = [learner.counts(), learner.visits(), learner.policy(), *learner.shortest_paths(), learner.legal_actions(0)]
        before = [copy.copy() for copy in copies]
        sspql.run_episodes(Maze(), learner, 5, seed=20)
        for copy, was in zip(copies, before):
            np.testing.assert_array_equal(copy, was)
            self.assertTrue(copy.flags.writeable)

    def test_shortest_paths_lead_to_the_goal(self):
        for cls in CLASSES:
            if not hasattr(cls, "counts"):
                self.assertFalse(hasattr(cls, "shortest_paths"))
                continue
            with self.subTest(cls.__name__):
                learner = learnt(cls, 10)
                self.assertEqual(learner.goals(), [(48, 0.0)])
                distance, next_ = learner.shortest_paths()
                self.assertEqual((len(distance), len(next_)), (49, 49))
                self.assertEqual((distance[48], next_[48]), (0.0, -1))
                state, hops = 0, 0
                while state != 48:
                    self.assertGreater(distance[state], distance[next_[state]])
                    state, hops = int(next_[state]), hops + 1
                self.assertEqual(hops, 12)
                self.assertTrue(np.isinf(distance[3]) and next_[3] == -1)  # a wall

    def test_told_goals(self):
        learner = learnt(sspql.AdaptiveSspql)
        learner.set_goals([(42, 1.5), 6])
        self.assertEqual(sorted(learner.goals()), [(6, 0.0), (42, 1.5)])
        self.assertEqual(learner.shortest_paths()[0][42], 1.5)
        learner = learnt(sspql.Sspql)
        learner.set_goals([6])
        learner.update_paths()
        self.assertEqual(learner.goals(), [(6, 0.0)])
        self.assertEqual(learner.shortest_paths()[0][6], 0.0)

    def test_adaptive_status(self):
        learner = learnt(sspql.AdaptiveSspql)
        status = learner.status()
        self.assertEqual(status["steps"], learner.visits().sum())
        self.assertEqual(status["pairs_tried"], (learner.visits() > 0).sum())
        self.assertIs(status["goal_known"], True)


if __name__ == "__main__":
    unittest.main()
