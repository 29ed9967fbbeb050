# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Why a picture is left out."""


class NotDrawn(Exception):
    """This run has nothing that the picture could show; the message says what is missing."""
