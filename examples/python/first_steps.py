# /usr/bin/python3 examples/python/first_steps.py      with PYTHONPATH=build/release/python; see docs/python.md
import os
import random
import tempfile

import numpy as np
import sspql


class Numbers:
    """A discrete space: the numbers 0 to n - 1, as gymnasium.spaces.Discrete."""

    def __init__(self, n):
        self.n = n


class Room:
    """8 x 8 cells, the charger in the far corner; one move in ten goes astray. Made like a Gymnasium environment."""

    observation_space = Numbers(64)
    action_space = Numbers(4)

    def reset(self, *, seed=None, options=None):
        self.chance = random.Random(seed)
        self.row = self.column = 0
        return 0, {}

    def step(self, action):
        if self.chance.random() < 0.1:
            action = self.chance.randrange(4)
        self.row = min(max(self.row + (0, 0, 1, -1)[action], 0), 7)
        self.column = min(max(self.column + (1, -1, 0, 0)[action], 0), 7)
        home = self.row == self.column == 7
        return 8 * self.row + self.column, float(home), home, False, {}


room = Room()
for kind in (sspql.AdaptiveSspql, sspql.Sspql, sspql.QLearning):
    robot = kind.for_env(room, seed=1)
    episodes = sspql.run_episodes(room, robot, 12, max_steps=5000)
    print(*(episode.steps for episode in episodes), kind.__name__)

# Look inside: Q is a NumPy array that nobody copied. The values of the four rows next to the charger:
print(np.round(robot.q.max(axis=1).reshape(8, 8)[4:], 2))

# Save what was learnt, and go on tomorrow as if nothing had happened.
robot = sspql.AdaptiveSspql.for_env(room, seed=1)
sspql.run_episodes(room, robot, 5, seed=1)
with tempfile.TemporaryDirectory() as directory:
    robot.save(os.path.join(directory, "robot.sspql"))
    again = sspql.load(os.path.join(directory, "robot.sspql"))
assert sspql.run_episodes(room, again, 3, seed=6) == sspql.run_episodes(room, robot, 3, seed=6)

# Why does it go there?
print(robot.explain(54, states=lambda s: f"({s // 8}, {s % 8})", actions=["right", "left", "down", "up"]))
