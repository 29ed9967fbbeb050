# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads contact problems (docs/reference/contact-problem.md) from files, and judges impulses by the equations alone.

This module is independent of every solver. M are the masses, and H maps velocities of the bodies to velocities of the
contacts. Impulses p are a solution if, with v = v_free + M^-1 H^T p and u = H v + bias, every contact obeys Signorini's
condition, 0 <= p_n, 0 <= u_n, p_n u_n = 0, and Coulomb's law for its tangential and its rolling part.
"""

from dataclasses import dataclass

import h5py
import numpy as np

NORMAL, TANGENTIAL, ROLLING = range(3)


@dataclass
class ContactProblem:
    """N bodies and M contacts. `to_first` and `to_second` (M, 3, 3) are the blocks of H: rows are the normal, tangential
    and rolling velocity of a contact [L/T], columns vx, vy and angular velocity of the body."""

    scale: float  # [L/T]
    inverse_mass: np.ndarray  # (N, 3) [1/M, 1/M, 1/(M L^2)], the diagonal of M^-1
    free_velocity: np.ndarray  # (N, 3) [L/T, L/T, 1/T]
    bodies: np.ndarray  # (M, 2)
    to_first: np.ndarray
    to_second: np.ndarray
    bias: np.ndarray  # (M, 3) [L/T]
    friction: np.ndarray  # (M)
    rolling_friction: np.ndarray  # (M)
    start: np.ndarray  # (M, 3) [M L/T] initial impulses of the contacts


def read_problem(path):
    with h5py.File(path, "r") as file:
        assert file.attrs["format"] in ("repose-contact-problem", b"repose-contact-problem"), f"{path}: no contact problem"
        scale = float(file.attrs["velocity_scale"])
        body = {name: data[()] for name, data in file["bodies"].items()}
        contact = {name: data[()] for name, data in file["contacts"].items()}
    (nx, ny), arms, roll = contact["normal"].T, contact["arms"], contact["roll_radius"]
    zero = np.zeros_like(nx)

    def block(sign, arm):
        """The rows are the velocity along n, along t = (-ny, nx) at the contact point, and of rolling."""
        rows = [[sign * nx, sign * ny, zero], [-sign * ny, sign * nx, -arm], [zero, zero, sign * roll]]
        return np.moveaxis(np.array(rows), 2, 0)

    return ContactProblem(
        scale=scale,
        inverse_mass=1.0 / np.stack([body["mass"], body["mass"], body["inertia"]], axis=1),
        free_velocity=body["free_velocity"],
        bodies=contact["bodies"],
        to_first=block(1.0, arms[:, 0]),
        to_second=block(-1.0, arms[:, 1]),
        bias=np.stack([contact["normal_bias"], contact["tangential_bias"], zero], axis=1),
        friction=contact["friction"],
        rolling_friction=contact["rolling_friction"],
        start=contact["impulse"],
    )


def velocities(problem, impulses):
    """Velocities of the bodies (N, 3) after the impulses (M, 3) of all contacts."""
    momentum = np.zeros_like(problem.free_velocity)
    for side, blocks in enumerate((problem.to_first, problem.to_second)):
        np.add.at(momentum, problem.bodies[:, side], np.einsum("mij,mi->mj", blocks, impulses))
    return problem.free_velocity + problem.inverse_mass * momentum


def contact_velocities(problem, body_velocities):
    """Formal velocities (M, 3) of the contacts, bias included."""
    first, second = (body_velocities[problem.bodies[:, side]] for side in (0, 1))
    return (
        np.einsum("mij,mj->mi", problem.to_first, first)
        + np.einsum("mij,mj->mi", problem.to_second, second)
        + problem.bias
    )


def own_masses(problem):
    """Effective masses of the contacts (M, 3) [M]: 1 over the diagonal of H M^-1 H^T."""
    first, second = (problem.inverse_mass[problem.bodies[:, side]] for side in (0, 1))
    return 1.0 / (
        np.einsum("mij,mj->mi", problem.to_first**2, first) + np.einsum("mij,mj->mi", problem.to_second**2, second)
    )


def residual(problem, impulses):
    """The largest violation of each law by the impulses (M, 3): {"normal", "tangential", "rolling", "worst"}, over the
    velocity scale, and "complementarity", |p_n u_n| over mass and scale squared.

    The first three are |p - projection(p - m u)| / m, which is 0 if and only if the law holds. The limit of friction
    follows from the projected normal impulse, the limit of rolling from the actual one.

    Infinite friction: a contact that touches, slides and has no normal impulse may carry any friction against its slip.
    """
    mass = own_masses(problem)
    u = contact_velocities(problem, velocities(problem, impulses))
    p = impulses
    wanted = np.maximum(0.0, p[:, NORMAL] - mass[:, NORMAL] * u[:, NORMAL])

    def limit(coefficient, normal):
        pressed = normal > 0.0
        return np.where(pressed, np.where(pressed, coefficient, 0.0) * normal, 0.0)

    def missed(part, most):
        right = np.clip(p[:, part] - mass[:, part] * u[:, part], -most, most)
        return np.abs(p[:, part] - right) / mass[:, part]

    normal = np.abs(p[:, NORMAL] - wanted) / mass[:, NORMAL]
    tangential = missed(TANGENTIAL, limit(problem.friction, wanted))
    rolling = missed(ROLLING, limit(problem.rolling_friction, p[:, NORMAL]))

    push, slip = p[:, TANGENTIAL] / mass[:, TANGENTIAL], u[:, TANGENTIAL]
    loose = np.maximum(np.abs(p[:, NORMAL]) / mass[:, NORMAL], np.abs(u[:, NORMAL]))
    against = np.where(push * slip < 0.0, 0.0, np.minimum(np.abs(push), np.abs(slip)))
    slides = np.isinf(problem.friction) & (np.maximum(loose, against) < np.maximum(normal, tangential))
    normal, tangential = np.where(slides, loose, normal), np.where(slides, against, tangential)

    def worst(values, unit):
        found = float(np.max(values, initial=0.0)) / unit
        return found if np.isfinite(found) else np.inf

    parts = {
        "normal": worst(normal, problem.scale),
        "tangential": worst(tangential, problem.scale),
        "rolling": worst(rolling, problem.scale),
    }
    work = np.abs(p[:, NORMAL] * u[:, NORMAL]) / mass[:, NORMAL]
    return parts | {"worst": max(parts.values()), "complementarity": worst(work, problem.scale**2)}
