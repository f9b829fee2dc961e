"""Fixtures for the tests of the Python package. The environment variables HRT_LIBRARY and HRT_BINDINGS name the library
and the folder plugin/bindings."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import haptic_retargeting as hrt

BINDINGS = Path(os.environ["HRT_BINDINGS"])
ROOT = BINDINGS.parent.parent


@pytest.fixture
def session() -> Iterator[hrt.Session]:
    """Creates a session with the controller of the paper, for a person with known parameters."""
    with hrt.Session(
        guidance=hrt.Guidance.FIXED_DIRECTION, adaptation=hrt.Adaptation.OFF, tactile_weight=0.15
    ) as session:
        session.add_real("cylinder", direction_deg=-5)
        session.add_virtual("cup", direction_deg=5)
        yield session


@pytest.fixture
def straight() -> np.ndarray:
    """Returns samples of a finger that moves 10 cm straight ahead in 3 s."""
    positions = np.zeros((271, 3))
    positions[:, 2] = np.linspace(0.05, -0.05, 271)
    return hrt.samples(np.arange(271) * 11_111_111, position_m=positions)
