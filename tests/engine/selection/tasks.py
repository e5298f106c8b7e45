"""Tasks of a load found another way than the product does: from samples, and from an inertia alone."""

import math

import numpy as np

from engine.selection.catalogue import Motors
from engine.selection.task import Task


def motors_of(rated, inertia, fastest):
    """Motors of these rated torques (Nm), inertias (kg m²) and largest speeds (rad/s)."""
    names = tuple(f"M{k}" for k in range(np.broadcast(rated, inertia, fastest).size))
    return Motors(names, inertia, rated, np.inf, fastest)


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


def rms_torque(task, motor_inertia, ratio, efficiency=1.0, reducer_inertia=0.0):
    """RMS torque of motors that always drive (Nm), (J_M + J_T) ω̇_L/τ + τ T*_L/η, squared and averaged.

    Source: S5, 'Model of dynamic system', with the squares it leaves out; step 7 for η and J_T.
    """
    inertia, tau, eta = np.asarray(motor_inertia) + reducer_inertia, np.asarray(ratio), np.asarray(efficiency)
    load, own = tau * task.torque_rms / eta, inertia * task.acceleration_rms / tau
    return np.sqrt(np.maximum(load**2 + own**2 + 2.0 * inertia * task.power_rate_mean / eta, 0.0))
