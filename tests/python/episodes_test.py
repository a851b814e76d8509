# SPDX-License-Identifier: MIT
"""run_episodes with environments that look like Gymnasium's, and its refusals of those that do not."""

import unittest

import numpy as np

import sspql
from every import steps
from maze import Maze, Space


class Corridor:
    """Cells 0 to 5, the goal is 5; action 1 goes on, action 0 back. Notes what it was asked."""

    def __init__(self, *, number=int, reward=1.0):
        self.observation_space = Space(6)
        self.action_space = Space(2)
        self.number = number
        self.reward = reward
        self.seeds = []

    def reset(self, **keywords):
        self.seeds.append(keywords)
        self.cell = 0
        return self.number(0), {"action_mask": np.array([0, 1], dtype=np.int8)}

    def step(self, action):
        self.cell = max(0, self.cell + 2 * action - 1)
        home = self.cell == 5
        mask = np.array([1, 1], dtype=np.int8)
        return self.number(self.cell), self.reward if home else 0.0, home, False, {"action_mask": mask}


class Episodes(unittest.TestCase):
    def test_results(self):
        learner = sspql.AdaptiveSspql.for_env(Corridor(), seed=1)
        results = sspql.run_episodes(Corridor(), learner, 20)
        self.assertEqual(len(results), 20)
        self.assertEqual(results[-1], sspql.EpisodeResult(5, 1.0, 1.0, True, False))
        self.assertEqual(sum(steps(results)), learner.visits().sum())

    def test_seeds_of_the_environment(self):
        env = Corridor()
        learner = sspql.QLearning.for_env(env)
        sspql.run_episodes(env, learner, 3, seed=np.int64(40))
        sspql.run_episodes(env, learner, 2)
        sspql.run_episodes(env, learner, 1, seed=None)
        sspql.run_episode(env, learner)
        self.assertEqual(env.seeds, [{"seed": 40}, {"seed": 41}, {"seed": 42}, {"seed": 0}, {"seed": 1}, {}, {}])

    def test_limits(self):
        env = Corridor()
        learner = sspql.QLearning.for_env(env, initial_q=0.0)
        result = sspql.run_episode(env, learner, max_steps=4)  # the goal is 5 steps off
        self.assertEqual(result, sspql.EpisodeResult(4, 0.0, 0.0, False, True))
        learner.teach(0, 1, 9.0), learner.teach(1, 1, 9.0), learner.teach(2, 1, 9.0)
        learner.teach(3, 1, 9.0), learner.teach(4, 1, 9.0)
        result = sspql.run_episode(env, learner, max_steps=5)
        self.assertEqual(result, sspql.EpisodeResult(5, 1.0, 1.0, True, False))
        for wrong in (0, -1):
            with self.assertRaisesRegex(ValueError, "max_steps must be at least 1"):
                sspql.run_episode(env, learner, max_steps=wrong)

    def test_a_truncated_episode_keeps_its_future(self):
        class Truncating(Corridor):
            def step(self, action):
                observation, _, _, _, info = super().step(1)
                return observation, 1.0, False, True, info

        learner = sspql.QLearning.for_env(Truncating(), initial_q=1.0)
        result = sspql.run_episode(Truncating(), learner)
        self.assertEqual((result.terminated, result.truncated), (False, True))
        # alpha (r + gamma max Q - Q), the future included: 1 + 0.8 (1 + 0.8 - 1)
        self.assertAlmostEqual(learner.q[0].max(), 1.64)

    def test_numbers_of_numpy(self):
        expected = None
        for number in (int, np.int64, np.int32, np.uint8, np.array):
            learner = sspql.DynaQ.for_env(Corridor(), seed=1)
            results = sspql.run_episodes(Corridor(number=number, reward=np.float32(1.0)), learner, 8)
            self.assertIs(type(results[0].total_reward), float)
            expected = expected or results
            self.assertEqual(results, expected)

    def test_spaces_that_start_elsewhere(self):
        plain = sspql.AdaptiveSspql.for_env(Maze(), seed=1)
        shifted = sspql.AdaptiveSspql.for_env(Maze(start=10), seed=1)
        self.assertEqual(sspql.run_episodes(Maze(), plain, 5), sspql.run_episodes(Maze(start=10), shifted, 5))
        self.assertEqual(plain.to_bytes(), shifted.to_bytes())

    def test_legal_actions(self):
        env = Corridor()
        learner = sspql.QLearning.for_env(env)
        sspql.run_episode(env, learner, legal_actions=True)
        self.assertEqual(learner.legal_actions(0).tolist(), [False, True] if learner.visits()[1, 0] == 0 else [True, True])
        learner = sspql.QLearning.for_env(env)
        sspql.run_episode(env, learner, max_steps=1, legal_actions=True)
        self.assertEqual(learner.legal_actions(0).tolist(), [False, True])
        self.assertEqual(learner.visits()[0].tolist(), [0, 1])
        with self.assertRaisesRegex(ValueError, 'info has no "action_mask"'):
            sspql.run_episode(Maze(), sspql.QLearning.for_env(Maze()), legal_actions=True)

    def test_callback(self):
        learner = sspql.QLearning.for_env(Corridor())
        called = []
        results = sspql.run_episodes(Corridor(), learner, 3, on_episode=lambda *what: called.append(what))
        self.assertEqual(called, [(result, learner) for result in results])

    def test_an_environment_that_raises(self):
        class Broken(Corridor):
            def step(self, action):
                raise OSError("the motor is off")

        learner = sspql.QLearning.for_env(Corridor())
        with self.assertRaisesRegex(OSError, "the motor is off"):
            sspql.run_episodes(Broken(), learner, 1)
        self.assertFalse(learner.running)
        sspql.run_episodes(Corridor(), learner, 1)


class Refused(unittest.TestCase):
    def refused(self, exception, text, env, learner=None):
        learner = learner or sspql.QLearning(6, 2)
        with self.assertRaisesRegex(exception, text):
            sspql.run_episodes(env, learner, 1)
        self.assertFalse(learner.running)

    def test_old_interfaces(self):
        class OldReset(Corridor):
            def reset(self, **keywords):
                return 0

        class OldStep(Corridor):
            def step(self, action):
                return super().step(action)[:4]

        class NoStep(Corridor):
            def step(self, action):
                return 3

        self.refused(TypeError, r"reset\(\) must return \(observation, info\).*Gymnasium; it returned 0", OldReset())
        self.refused(TypeError, r"step\(\) returned 4 values, as Gym did before 0.26", OldStep())
        self.refused(TypeError, r"step\(\) must return .*; it returned 3", NoStep())

    def test_spaces_that_are_not_discrete(self):
        class Box:
            shape = (2,)

            def __repr__(self):
                return "Box(2,)"

        env = Corridor()
        env.observation_space = Box()
        self.refused(TypeError, r"observation_space must be discrete, .*; Box\(2,\) is not", env)
        with self.assertRaisesRegex(TypeError, "observation_space must be discrete"):
            sspql.QLearning.for_env(env)
        with self.assertRaisesRegex(TypeError, "object has no observation_space"):
            sspql.QLearning.for_env(object())

    def test_sizes(self):
        self.refused(ValueError, "observation_space has 6 states, the learner 7", Corridor(), sspql.QLearning(7, 2))
        self.refused(ValueError, "action_space has 2 actions, the learner 3", Corridor(), sspql.QLearning(6, 3))

    def test_observations(self):
        self.refused(TypeError, r"observations must be whole numbers, got 0.0", Corridor(number=float))
        self.refused(TypeError, r"observations must be whole numbers, got \(0,\)", Corridor(number=lambda n: (n,)))
        self.refused(ValueError, "state must be below the number of states 6, got 100", Corridor(number=lambda n: 100))


if __name__ == "__main__":
    unittest.main()
