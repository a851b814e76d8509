# SPDX-License-Identifier: MIT
"""What an environment's discrete spaces are, without asking for a library they come from."""

import operator
from typing import NamedTuple


class Discrete(NamedTuple):
    """The numbers start to start + n - 1."""

    n: int
    start: int


def discrete(env, which):
    """The space `which` ("observation_space", "action_space") of `env`: something with n and, perhaps, start.

    TypeError for any other space.
    """
    try:
        space = getattr(env, which)
    except AttributeError:
        raise TypeError(f"the environment {type(env).__name__} has no {which}") from None
    try:
        return Discrete(operator.index(space.n), operator.index(getattr(space, "start", 0)))
    except (AttributeError, TypeError):
        raise TypeError(
            f"{which} must be discrete, with a whole number n; {space!r} is not. Wrap the environment in one whose "
            "observations and actions are whole numbers"
        ) from None
