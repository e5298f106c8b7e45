"""Tasks of a load found another way than the product does: from samples, and from an inertia alone."""

import math

import numpy as np

from engine.choice import Task


def sampled_task(time, speed, acceleration, torque):
    """The task of samples over a cycle, by the trapezoidal rule."""

    time, speed, acceleration, torque = (np.asarray(values) for values in (time, speed, acceleration, torque))

    def mean(values):
        return float(np.trapezoid(values, time)) / float(time[-1] - time[0])

    fastest = float(np.abs(speed).max())
    return Task(math.sqrt(mean(acceleration**2)), math.sqrt(mean(torque**2)), mean(acceleration * torque), fastest)


def inertial_task(inertia, acceleration_rms, max_speed):
    """The task of a purely inertial load, T*_L = J_L ω̇_L (S5, before eq. (17))."""
    torque = inertia * acceleration_rms
    return Task(acceleration_rms, torque, acceleration_rms * torque, max_speed)
