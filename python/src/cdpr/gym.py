"""An environment of Gymnasium for machines in time (extra ``cdpr[gym]``)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium import spaces

from ._arrays import Array
from ._errors import Error
from ._plant import Plant, PlantState

__all__ = ["PlantEnv"]


class PlantEnv(gymnasium.Env[npt.NDArray[np.float64], npt.NDArray[np.float64]]):
    """A machine whose cable lengths an agent changes.

    An observation is pose (7: x, y, z, qx, qy, qz, qw), twist (6) and tensions (m); an action is a rate of paid-out length for each cable
    (m/s), within ``±rate``. A step of the environment takes ``substeps`` steps of ``dt`` seconds. ``reward(observation, action)`` rates each;
    an episode ends early, ``terminated``, where a step cannot be taken.
    """

    metadata: dict[str, Any] = {"render_modes": []}

    def __init__(
        self,
        plant: Plant,
        start: PlantState,
        *,
        reward: Callable[[Array, Array], float],
        dt: float = 0.001,
        substeps: int = 10,
        rate: float = 0.5,
        displacement: float = 0.0,
    ) -> None:
        """Makes the environment. ``displacement`` (m): lengths of the start are drawn within it at every reset."""
        self.plant, self.start, self.state = plant, start, start.copy()
        self.reward, self.dt, self.substeps, self.displacement = reward, dt, substeps, displacement
        cables = plant.model.robot.cable_count
        self.observation_space = spaces.Box(-np.inf, np.inf, (13 + cables,), np.float64)
        self.action_space = spaces.Box(-rate, rate, (cables,), np.float64)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Array, dict[str, Any]]:
        """Returns the first observation of an episode."""
        super().reset(seed=seed)
        self.state = self.start.copy()
        if self.displacement > 0.0:
            lengths = self.start.lengths
            lengths += self.np_random.uniform(-self.displacement, self.displacement, lengths.size)
            self.plant.step(self.state, lengths, self.dt)
        return self._observed(), {}

    def step(self, action: Array) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """Returns observation, reward, whether the episode ended, whether it was cut short (never), and the reason of an end."""
        rates = np.asarray(action, dtype=float)
        info: dict[str, Any] = {}
        try:
            for _ in range(self.substeps):
                self.plant.step(self.state, rates, self.dt, "speeds")
        except Error as error:
            info["reason"] = error.message
        observation = self._observed()
        return observation, float(self.reward(observation, rates)), bool(info), False, info

    def _observed(self) -> Array:
        return self.state.observe(np.empty(self.observation_space.shape or ()))
