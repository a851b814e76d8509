# SPDX-License-Identifier: MIT
"""All learners, for tests that hold for each."""

import sspql

CLASSES = (
    sspql.AdaptiveSspql,
    sspql.Sspql,
    sspql.QLearning,
    sspql.Sarsa,
    sspql.DynaQ,
    sspql.DynaQPlus,
    sspql.PrioritizedSweeping,
    sspql.Rtdp,
    sspql.RMax,
)


def steps(results):
    return [result.steps for result in results]


def body(checkpoint):
    """A checkpoint without its header, which names the version of the library that wrote it."""
    return checkpoint[20:]
