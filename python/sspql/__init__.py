# SPDX-License-Identifier: MIT
"""Learners for worlds that are expensive to try things in, on integer states and actions.

    import sspql

    learner = sspql.AdaptiveSspql.for_env(env, seed=1)     # any environment with Gymnasium's reset() and step()
    for episode in sspql.run_episodes(env, learner, 30, max_steps=1000):
        print(episode.steps, episode.total_reward)
    learner.q[state]                                       # a NumPy view of Q, not a copy
    learner.save("robot.sspql")                            # sspql.load("robot.sspql") goes on to the bit

Without an environment class: action = learner.begin(state), learner.step(reward, state), learner.end(reward, state,
terminated). The same seed gives the same actions as in C++.
"""

from ._core import ActionTerms, Explanation, ExponentialDecay, VisitDecay, __version__
from .episodes import EpisodeResult, run_episode, run_episodes
from .learners import (
    AdaptiveSspql,
    DynaQ,
    DynaQPlus,
    Learner,
    PrioritizedSweeping,
    QLearning,
    RMax,
    Rtdp,
    Sarsa,
    Sspql,
    load,
)

__all__ = [
    "ActionTerms",
    "AdaptiveSspql",
    "DynaQ",
    "DynaQPlus",
    "EpisodeResult",
    "Explanation",
    "ExponentialDecay",
    "Learner",
    "PrioritizedSweeping",
    "QLearning",
    "RMax",
    "Rtdp",
    "Sarsa",
    "Sspql",
    "VisitDecay",
    "load",
    "run_episode",
    "run_episodes",
]
