# SPDX-License-Identifier: MIT
"""The learners: a Python class for each, around the compiled one."""

import inspect
import operator
import textwrap

import numpy as np

from . import _core
from .spaces import discrete


class Learner(_core.Learner):
    """What all learners share. States are 0 to states - 1, actions 0 to actions - 1.

    An episode is

        action = learner.begin(state)
        action = learner.step(reward, state)  ...
        learner.end(reward, state, terminated)

    Every call checks what it is given before anything changes. Errors: ValueError for an id outside, a number out of
    range or not finite; RuntimeError for calls in a wrong order; TypeError for a parameter that does not exist.
    Learners can be pickled and copied. One thread at a time.
    """

    _kind = None

    def __init__(self, states, actions, *, seed=0, preset=None, **parameters):
        if self._kind is None:
            raise TypeError("Learner is what the learners share; make one of them, such as AdaptiveSspql")
        seed = operator.index(seed)
        if not 0 <= seed < 2**64:
            raise ValueError(f"seed must lie between 0 and 2^64 - 1, got {seed}")
        super().__init__(
            self._kind, operator.index(states), operator.index(actions), seed, preset or "", parameters
        )

    def __init_subclass__(cls, **keywords):
        super().__init_subclass__(**keywords)
        if "_kind" in vars(cls):
            _describe(cls)
        elif "__init__" in vars(cls):  # a user's class has a signature of its own
            own = inspect.signature(cls.__init__)
            cls.__signature__ = own.replace(parameters=list(own.parameters.values())[1:])

    @classmethod
    def for_env(cls, env, **keywords):
        """A learner for the spaces of `env`, which must be discrete: observation_space.n states, action_space.n
        actions. Keywords are the constructor's."""
        return cls(discrete(env, "observation_space").n, discrete(env, "action_space").n, **keywords)

    def copy(self):
        """Another learner that goes on from here as this one would."""
        return self.__copy__()

    def __copy__(self):
        other = type(self).__new__(type(self))
        _core.Learner.__init__(other, self)
        other.__dict__.update(self.__dict__)
        return other

    def __reduce__(self):
        return _restore, (type(self), self.to_bytes()), self.__dict__ or None

    def __repr__(self):
        return f"{type(self).__name__}(states={self.states}, actions={self.actions})"


class _Counting(Learner):
    def counts(self):
        """What was observed: an array with a row for each (state, action, next state), ascending, a copy.

        Its fields: s, a, next; n, how often (a fraction where old observations fade); weight, the mean weight of
        (s, next); terminal, whether the last observation ended the episode; and, for all learners but Sspql, reward_sum,
        so that reward_sum / n is the mean reward. The same as save_npy writes in C++.
        """
        whole, rewards, s, a, next_, n, weight, terminal, reward_sum = self._counts()
        fields = [("s", "<i8"), ("a", "<i8"), ("next", "<i8"), ("n", "<i8" if whole else "<f8")]
        fields += [("weight", "<f8"), ("terminal", "?")]
        if rewards:
            fields.append(("reward_sum", "<f8"))
        counts = np.empty(len(s), dtype=fields)
        columns = (s, a, next_, n, weight, terminal, reward_sum)
        for (name, _), column in zip(fields, columns):
            counts[name] = column
        return counts

    def goals(self):
        """The goals that hold now: a list of pairs (state, offset), told ones or those that rewards tell of."""
        return self._goals()

    def shortest_paths(self):
        """The shortest paths to the goals that the counts know of: distance and next state by state, two arrays of shape
        (states,), copies.

        The distance is in expected steps (weights, where steps had any), infinite where no path is known; next is -1
        there and at goals. For Sspql they are the paths it uses, by its own costs, as of its last update.
        """
        return self._paths()


def _describe(cls):
    """Gives a class the signature and the table of parameters that the compiled part has."""
    keyword = inspect.Parameter.KEYWORD_ONLY
    arguments = [
        inspect.Parameter("states", inspect.Parameter.POSITIONAL_OR_KEYWORD),
        inspect.Parameter("actions", inspect.Parameter.POSITIONAL_OR_KEYWORD),
        inspect.Parameter("seed", keyword, default=0),
        inspect.Parameter("preset", keyword, default=None),
    ]
    defaults = {}
    lines = []
    for name, default, text in _core.parameters(cls._kind):
        group, _, member = name.partition(".")
        if member:
            defaults.setdefault(group, {})[member] = default
        else:
            defaults[name] = default
        head = f"{name} = {default!r}"
        first = f"{head:<26}  " if len(head) <= 26 else f"{head}\n{'':28}"
        lines.append(first + textwrap.fill(text, 116 - 28 - 8, subsequent_indent=" " * 28))
    arguments += [inspect.Parameter(name, keyword, default=default) for name, default in defaults.items()]
    cls.__signature__ = inspect.Signature(arguments)
    if cls.__doc__ is None:  # python -OO
        return

    text = inspect.cleandoc(cls.__doc__) + "\n\n"
    text += "seed: of what the learner draws. The same seed gives the same actions, here and in C++.\n"
    presets = _core.presets(cls._kind)
    if presets:
        text += f"preset: other defaults: {', '.join(map(repr, presets))}.\n"
    text += "Parameters:\n\n" + textwrap.indent("\n".join(lines), "    ")
    if any(isinstance(default, dict) for default in defaults.values()):
        text += "\n\nThose with a dot are given in a dict: trust={'cap': 20.0}."
    cls.__doc__ = text


class AdaptiveSspql(_Counting):
    """The adaptive planner, the recommended learner: one set of parameters for every task.

    It counts what actions lead to, plans on these counts with every step, is hopeful about what it has not tried, and
    notices when the world has changed. Goals pay or steps cost. `q` is 0 where an action was never tried; what is hoped
    of it then is terms(state, action).q.
    """

    _kind = "AdaptiveSspql"

    def status(self):
        """What it has come to believe: a dict of numbers (steps, states_known, pairs_tried, edge_touches, alarms,
        goal_known, typical_cost, optimism, noise, kappa)."""
        status = self._status()
        for name in ("steps", "states_known", "pairs_tried", "edge_touches", "alarms"):
            status[name] = int(status[name])
        status["goal_known"] = bool(status["goal_known"])
        return status


class Sspql(_Counting):
    """Stochastic shortest path-based Q-learning, as published by Kwon, Suh and Lee (2011).

    Actions are chosen by w_q Q + w_ssp(N) Q_SSP + w_exp Q_EXP plus noise. Q_SSP comes from the shortest paths to the
    goals over the counts, renewed when an episode ends.
    """

    _kind = "Sspql"

    def update_paths(self):
        """Renews the shortest paths now instead of at the episode's end."""
        self._update_paths()


class QLearning(Learner):
    """Q-learning (Watkins 1989), without a model: the baseline. set_goals() means starting over."""

    _kind = "QLearning"


class Sarsa(Learner):
    """Sarsa (Rummery and Niranjan 1994): learns the value of what it does, exploration included. With expected=True
    it backs up the mean over the next actions. set_goals() means starting over."""

    _kind = "Sarsa"


class DynaQ(_Counting):
    """Dyna-Q (Sutton 1990): Q-learning that replays what it has seen, planning_steps times a step."""

    _kind = "DynaQ"


class DynaQPlus(Learner):
    """Dyna-Q+ (Sutton 1990), for worlds that change: what was not tried for long earns a bonus in planning."""

    _kind = "DynaQPlus"


class PrioritizedSweeping(_Counting):
    """Prioritized sweeping (Moore and Atkeson 1993): after each step, full backups where values are most out of date.
    The preset 'optimistic' is the strong baseline for goals that pay 1."""

    _kind = "PrioritizedSweeping"


class Rtdp(_Counting):
    """Adaptive real-time dynamic programming (Barto, Bradtke and Singh 1995): backs up the state just left."""

    _kind = "Rtdp"


class RMax(_Counting):
    """R-Max (Brafman and Tennenholtz 2002): what was tried fewer than known_after times is worth the most there is."""

    _kind = "RMax"


_CLASSES = {cls._kind: cls for cls in (
    AdaptiveSspql, Sspql, QLearning, Sarsa, DynaQ, DynaQPlus, PrioritizedSweeping, Rtdp, RMax)}


def load(path):
    """The learner that was saved to `path`, by Python or by C++: of its class, with its parameters and its size.

    OSError where the file cannot be read, RuntimeError where it is no sound checkpoint.
    """
    data = _core.read_file(path)
    name = _core.path_text(path)
    return _restore(_CLASSES[_core.kind_of(data, name)], data, name)


def _restore(cls, data, name="in memory"):
    learner = cls.__new__(cls)
    _core.Learner.__init__(learner, data, name)
    return learner
