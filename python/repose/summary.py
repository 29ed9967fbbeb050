# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads summary.json of a run or sweep folder; its keys are described in docs/reference/summary.md."""

import json

from repose.errors import RunFolderError, one_line
from repose.hdf5 import can_hash, xxhash


def read_summary(path):
    """The numbers by name, {} without a file; RunFolderError if the file is damaged."""
    if not path.is_file():
        return {}
    try:
        content = path.read_bytes()
        summary = json.loads(content.decode("utf-8"))
    except (OSError, ValueError) as error:
        raise RunFolderError(f"{path}: cannot be read: {one_line(error)}") from error
    text, key, end = content.rpartition(b',\n  "checksum": ')
    if key and can_hash() and end != f'"{xxhash.xxh3_128_hexdigest(text)}"\n}}\n'.encode():
        raise RunFolderError(f"{path}: damaged: its content is not what was written")
    return summary
