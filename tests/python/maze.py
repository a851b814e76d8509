# SPDX-License-Identifier: MIT
"""A small environment with Gymnasium's interface, the same as Maze in parity.cpp."""

MAP = (
    "S..#...",
    ".#.#.#.",
    ".#...#.",
    ".###.#.",
    "...#.#.",
    ".#...#.",
    "...#..G",
)


class Space:
    def __init__(self, n, start=0):
        self.n = n
        self.start = start


class Maze:
    """7 x 7 cells, the goal pays 1, one move in ten goes astray. `start` is added to observations and actions."""

    def __init__(self, start=0, slip=10):
        self.observation_space = Space(49, start)
        self.action_space = Space(4, start)
        self.slip = slip
        self.chance = 0
        self.cell = None

    def _draw(self, n):
        self.chance = (self.chance * 6364136223846793005 + 1442695040888963407) % 2**64
        return (self.chance >> 33) % n

    def reset(self, *, seed=None, options=None):
        if seed is not None:
            self.chance = seed
        self.cell = 0
        return self.cell + self.observation_space.start, {}

    def step(self, action):
        move = action - self.action_space.start
        assert 0 <= move < 4, action
        if self._draw(100) < self.slip:
            move = self._draw(4)
        row, column = divmod(self.cell, 7)
        row += (-1, 1, 0, 0)[move]
        column += (0, 0, -1, 1)[move]
        if 0 <= row < 7 and 0 <= column < 7 and MAP[row][column] != "#":
            self.cell = 7 * row + column
        home = self.cell == 48
        return self.cell + self.observation_space.start, 1.0 if home else 0.0, home, False, {}
