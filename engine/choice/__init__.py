"""Choice of motor and reducer from catalogues, by the seven steps of S5. SI units; τ = ω_L/ω_M throughout."""

from engine.choice.catalogue import Motors, Reducers
from engine.choice.pair import LoadSamples, Pair
from engine.choice.pairs import Criterion, Pairs, rank, usable
from engine.choice.task import Task

__all__ = ["Criterion", "LoadSamples", "Motors", "Pair", "Pairs", "Reducers", "Task", "rank", "usable"]
