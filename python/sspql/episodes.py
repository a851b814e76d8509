# SPDX-License-Identifier: MIT
"""Episodes of a learner in an environment with Gymnasium's interface: reset(seed=...) -> (observation, info),
step(action) -> (observation, reward, terminated, truncated, info), and discrete observation_space and action_space."""

import operator
from typing import NamedTuple

from .spaces import discrete


class EpisodeResult(NamedTuple):
    """How one episode went."""

    steps: int
    total_reward: float  # not discounted
    last_reward: float  # that of the last step
    terminated: bool  # the task itself ended
    truncated: bool  # cut short, by the environment or by max_steps


def run_episode(env, learner, *, seed=None, max_steps=None, legal_actions=False):
    """One learning episode; see run_episodes. `seed` is given to env.reset()."""
    if max_steps is not None and operator.index(max_steps) < 1:
        raise ValueError(f"max_steps must be at least 1, got {max_steps}")
    states = discrete(env, "observation_space")
    first_action = discrete(env, "action_space").start
    _require_size(env, learner)

    def state_of(observation):
        try:
            return operator.index(observation) - states.start
        except TypeError:
            raise TypeError(f"observations must be whole numbers, got {observation!r}") from None

    def told(state, info):
        if legal_actions:
            learner.set_legal_actions(state, _mask_in(info))
        return state

    steps = 0
    total = 0.0
    try:
        observation, info = _reset(env, seed)
        action = learner.begin(told(state_of(observation), info))
        while True:
            observation, reward, terminated, truncated, info = _outcome(env.step(action + first_action))
            reward = float(reward)
            steps += 1
            total += reward
            terminated = bool(terminated)
            truncated = bool(truncated) or (steps == max_steps and not terminated)
            state = state_of(observation)
            if terminated or truncated:
                learner.end(reward, state, terminated)
                return EpisodeResult(steps, total, reward, terminated, truncated)
            action = learner.step(reward, told(state, info))
    except BaseException:
        learner.abort()
        raise


def run_episodes(env, learner, episodes, *, seed=0, max_steps=None, legal_actions=False, on_episode=None):
    """Learning episodes; returns a list of EpisodeResult.

    env        anything with Gymnasium's reset() and step() and with discrete spaces. Observations and actions may
               start at another number than 0 (the space's `start`); the learner's states always start at 0.
    learner    a learner for as many states and actions
    seed       the k-th episode (from 0) calls env.reset(seed=seed + k), as in C++; None: env.reset(), for environments
               that are seeded by other means
    max_steps  episodes are cut after so many steps; None: the environment does that itself
    legal_actions  True: `info` of reset() and step() has an "action_mask", which tells the actions of that state
    on_episode  on_episode(result, learner) is called after each

    If the environment raises, the episode is aborted, what was learnt before stays, and the exception passes on.
    """
    results = []
    for k in range(operator.index(episodes)):
        results.append(run_episode(env, learner, seed=None if seed is None else operator.index(seed) + k,
                                   max_steps=max_steps, legal_actions=legal_actions))
        if on_episode is not None:
            on_episode(results[-1], learner)
    return results


def _require_size(env, learner):
    for which, has in (("observation_space", learner.states), ("action_space", learner.actions)):
        needs = discrete(env, which).n
        if needs != has:
            what = "states" if which == "observation_space" else "actions"
            raise ValueError(f"the environment's {which} has {needs} {what}, the learner {has}")


def _reset(env, seed):
    answer = env.reset() if seed is None else env.reset(seed=seed)
    if not (isinstance(answer, tuple) and len(answer) == 2 and isinstance(answer[1], dict)):
        raise TypeError(
            f"reset() must return (observation, info), as since Gym 0.26 and in Gymnasium; it returned {answer!r}"
        )
    return answer


def _outcome(answer):
    if isinstance(answer, tuple) and len(answer) == 5:
        return answer
    if isinstance(answer, tuple) and len(answer) == 4:
        raise TypeError(
            "step() returned 4 values, as Gym did before 0.26; it must return (observation, reward, terminated, "
            "truncated, info), so that a goal and a time limit can be told apart"
        )
    raise TypeError(f"step() must return (observation, reward, terminated, truncated, info); it returned {answer!r}")


def _mask_in(info):
    try:
        return info["action_mask"]
    except KeyError:
        raise ValueError('legal_actions=True, but info has no "action_mask"') from None
