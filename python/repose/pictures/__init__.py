# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of runs (`run`, of spheres `spheres`), of sweeps (`sweep`) and of stress models (`models`)."""


def pictures_of_run(run):
    """Functions of a run and a state by the name of the picture, for the dimension of a run."""
    from repose.pictures.run import RUN_PICTURES
    from repose.pictures.spheres import SPHERE_PICTURES

    return RUN_PICTURES if run.attributes["dimension"] == 2 else SPHERE_PICTURES
