# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Opens the HDF5 files of Repose, checks their seals and formats, and reports damage in one line."""

import warnings
from contextlib import contextmanager
from functools import cache

import h5py
import numpy as np

from repose.errors import RunFolderError, one_line
from repose.tables import to_pandas

try:
    import xxhash
except ImportError:
    xxhash = None

SEAL_SIZE = 512  # bytes before the HDF5 file itself


class Table(dict):
    """Columns by name, with their units and the attributes of their group; text as lists of str; KeyError without a needed
    column."""

    def __init__(self, group, needed=""):
        super().__init__({name: values_of(part) for name, part in group.items() if isinstance(part, h5py.Dataset)})
        self.attributes = attributes_of(group)
        self.units = {name: attributes_of(group[name]).get("unit", "") for name in self}
        missing = [f"{group.name}/{name}" for name in needed.split() if name not in self]
        if missing:
            raise KeyError(f"no dataset {', '.join(missing)}")


    def to_pandas(self):
        """The columns as a DataFrame; ImportError without pandas."""
        return to_pandas(self)


MOST_COMPRESSION = 1100  # no byte of a deflated stream holds more


def check_size(dataset):
    """RunFolderError if a dataset claims to be larger than what is stored of it can be: before memory is asked for."""
    content = dataset.id.get_storage_size() * (1 if dataset.chunks is None else MOST_COMPRESSION)
    if dataset.size * dataset.dtype.itemsize > content:
        raise RunFolderError(f"{dataset.file.filename}: {dataset.name}: is larger than its content: damaged")


def values_of(dataset):
    """The array of a dataset, or a list of str."""
    check_size(dataset)
    if h5py.check_string_dtype(dataset.dtype):
        return dataset.asstr()[()].tolist()
    return dataset[()]


def attributes_of(group):
    """Attributes of a group as Python values and arrays; text as str."""
    values = {}
    for name, value in group.attrs.items():
        if isinstance(value, bytes):
            value = value.decode("utf-8")
        values[name] = value.item() if isinstance(value, np.generic) else value
    return values


def check_format(path, attributes, kind, version, needed=()):
    """RunFolderError unless the attributes are those of repose-`kind` in this version, with the needed ones."""
    article = "an" if kind[0] in "aeiou" else "a"
    if attributes.get("format") != f"repose-{kind}":
        raise RunFolderError(f"{path}: not {article} {kind} of Repose (no format = 'repose-{kind}')")
    if attributes.get("format_version") != version:
        raise RunFolderError(f"{path}: format_version {attributes.get('format_version')}; this package reads {version}")
    missing = sorted(set(needed) - attributes.keys())
    if missing:
        raise RunFolderError(f"{path}: does not follow the format: no attribute {', '.join(missing)}")


@cache
def can_hash():
    """Whether damage can be detected; warns once if not."""
    if xxhash is None:
        warnings.warn("no Python package xxhash: damaged files are not detected", stacklevel=2)
    return xxhash is not None


def check_seal(path):
    """RunFolderError unless a sealed file has the length and the hash that its first 512 bytes state."""
    with open(path, "rb") as file:
        seal = file.read(SEAL_SIZE).rstrip(b"\0").decode("ascii", "replace").split("\n")
        if seal[0] != "repose sealed file" or not can_hash():
            return
        length, digest = SEAL_SIZE, xxhash.xxh3_128()
        while piece := file.read(1 << 20):
            digest.update(piece)
            length += len(piece)
    if seal[1:3] != [f"length {length}", f"xxh3-128 {digest.hexdigest()}"]:
        raise RunFolderError(f"{path}: damaged: its content is not what was written")


@contextmanager
def opened(path):
    """An HDF5 file; errors of h5py and missing or damaged parts become a RunFolderError."""
    if path.exists() and not path.is_file():
        raise RunFolderError(f"{path}: is no regular file")
    if not path.is_file():
        raise RunFolderError(f"{path.parent}: no {path.name} in this folder")
    try:
        check_seal(path)
        file = h5py.File(path, "r")
    except OSError as error:
        raise RunFolderError(f"{path}: cannot be read: {one_line(error)}") from error
    with file:
        try:
            yield file
        except RunFolderError:
            raise
        except MemoryError as error:
            raise RunFolderError(f"{path}: does not fit into memory") from error
        except (AttributeError, KeyError, OSError, RuntimeError, TypeError, ValueError) as error:
            raise RunFolderError(f"{path}: does not follow the format: {one_line(error)}") from error
