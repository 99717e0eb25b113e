"""Checks of arguments: each error names the argument, the element and the rule."""

from __future__ import annotations

import numbers
import os
from typing import Any, NamedTuple

import numpy as np


def points_of(name: str, values: Any) -> np.ndarray:
    """Returns an array of shape (n, 3) and type float64 in C order; copies only if it must."""
    array = _numbers_of(name, values)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} has shape {array.shape}, but (n, 3) is needed: a row of three numbers for each point")
    array = np.ascontiguousarray(array, dtype=np.float64)
    bad = ~np.isfinite(array)
    if bad.any():
        row, column = np.argwhere(bad)[0]
        raise ValueError(f"{name}[{row}, {column}] is {array[row, column]}, not a finite number")
    return array


def triangles_of(name: str, values: Any, n: int) -> np.ndarray:
    """Returns an array of shape (m, 3) and type int64 in C order with entries from 0 to n-1."""
    try:
        array = _numbers_of(name, values)
    except ValueError:
        _reject_polygons(name, values)
        raise
    if array.size == 0:
        return np.zeros((0, 3), dtype=np.int64)
    if array.ndim != 2 or array.shape[1] != 3:
        if array.ndim == 2:
            raise ValueError(f"{name}[0] has {array.shape[1]} corners: each face must be a triangle")
        raise ValueError(f"{name} has shape {array.shape}, but (m, 3) is needed: three vertices for each face")
    return ids_of(name, array, n, "vertices")


def ids_of(name: str, values: Any, n: int, what: str) -> np.ndarray:
    """Returns an array of type int64 in C order; rejects entries that are no ids of the n elements."""
    array = _numbers_of(name, values)
    if array.dtype.kind == "f" and array.size > 0:
        fractional = array != np.floor(array)
        if fractional.any() or not np.isfinite(array).all():
            position = tuple(np.argwhere(fractional | ~np.isfinite(array))[0])
            raise ValueError(f"{_element(name, position)} is {array[position]}, not an integer")
    bad = (array < 0) | (array >= n)
    if bad.any():
        position = tuple(np.argwhere(bad)[0])
        raise IndexError(f"{_element(name, position)} is {array[position]}, but there are {n} {what}, counted from 0")
    return np.ascontiguousarray(array, dtype=np.int64)


class Places(NamedTuple):
    """Points of a surface: entry i is vertex[i], or if that is -1 the point of face[i] with coordinates weight[i].

    The last two arrays may be empty if all are vertices.
    """

    vertex: np.ndarray
    face: np.ndarray
    weight: np.ndarray


def places_of(name: str, values: Any, n_vertices: int, n_faces: int) -> Places:
    """Reads a vertex, a pair (face, coordinates), a sequence of these, or a pair of arrays (faces, coordinates)."""
    if _is_pair(values):
        faces = np.atleast_1d(np.asarray(values[0]))
        weights = np.atleast_2d(_numbers_of(name, values[1])).astype(np.float64)
        if weights.shape != (len(faces), 3):
            raise ValueError(f"{name} has coordinates of shape {weights.shape} for {len(faces)} faces, "
                             "but three numbers for each face are needed")
        faces = ids_of(name, faces, n_faces, "faces")
        return Places(np.full(len(faces), -1, dtype=np.int64), faces, np.ascontiguousarray(weights))
    if isinstance(values, numbers.Number) or isinstance(values, np.ndarray):
        return _vertices(ids_of(name, np.atleast_1d(values), n_vertices, "vertices"), name)
    values = list(values)
    if not any(_is_pair(value) for value in values):
        return _vertices(ids_of(name, values, n_vertices, "vertices"), name)
    parts = [_padded(places_of(f"{name}[{i}]", value, n_vertices, n_faces)) for i, value in enumerate(values)]
    return Places(*(np.concatenate(arrays) for arrays in zip(*parts)))


def offsets_of(name: str, values: Any, n: int) -> np.ndarray:
    """Returns n numbers that are finite and not negative, or none."""
    array = weights_of(name, values, n)
    if (array < 0).any():
        i = int(np.argmax(array < 0))
        raise ValueError(f"{name}[{i}] is {array[i]}: it must not be negative")
    return array


def weights_of(name: str, values: Any, n: int) -> np.ndarray:
    """Returns n numbers that are finite, or none."""
    if values is None:
        return np.zeros(0)
    array = np.atleast_1d(_numbers_of(name, values)).astype(np.float64)
    if array.shape != (n,):
        raise ValueError(f"{name} has shape {array.shape}, but {n} numbers are needed")
    if not np.isfinite(array).all():
        i = int(np.argmin(np.isfinite(array)))
        raise ValueError(f"{name}[{i}] is {array[i]}, not a finite number")
    return array


def count_of(name: str, value: Any, least: int) -> int:
    if isinstance(value, bool) or not isinstance(value, numbers.Number) or int(value) != value or value < least:
        raise ValueError(f"{name} is {value!r}, but an integer from {least} on is needed")
    return int(value)


def positive_of(name: str, value: Any) -> float:
    value = float(value)
    if not value > 0 or not np.isfinite(value):
        raise ValueError(f"{name} is {value}: it must be positive")
    return value


def radius_of(name: str, value: Any) -> float:
    value = float(value)
    if not value >= 0:
        raise ValueError(f"{name} is {value}: it must not be negative")
    return value


def threads_of(value: int | None) -> int:
    """None stands for all processors that this process may use."""
    if value is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return count_of("threads", value, 1)


def _numbers_of(name: str, values: Any) -> np.ndarray:
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise ValueError(f"{name} is not an array: its rows differ in length") from error
    if array.dtype.kind == "O" and array.size > 0:
        raise ValueError(f"{name} is not an array of numbers")
    if array.size > 0 and array.dtype.kind not in "iuf":
        raise ValueError(f"{name} has the type {array.dtype}, but numbers are needed")
    return array


def _reject_polygons(name: str, values: Any) -> None:
    for i, face in enumerate(values):
        if hasattr(face, "__len__") and len(face) != 3:
            raise ValueError(f"{name}[{i}] has {len(face)} corners: each face must be a triangle")


def _is_pair(value: Any) -> bool:
    """Is this (face, coordinates) or (faces, coordinates), and not two vertices?"""
    return isinstance(value, tuple) and len(value) == 2 and np.ndim(value[1]) == np.ndim(value[0]) + 1


def _vertices(ids: np.ndarray, name: str) -> Places:
    if ids.ndim != 1:
        raise ValueError(f"{name} has shape {ids.shape}, but one row of vertices is needed")
    return Places(ids, np.zeros(0, dtype=np.int64), np.zeros((0, 3)))


def _padded(places: Places) -> Places:
    if len(places.face) == len(places.vertex):
        return places
    n = len(places.vertex)
    return Places(places.vertex, np.full(n, -1, dtype=np.int64), np.zeros((n, 3)))


def _element(name: str, position: tuple) -> str:
    return f"{name}[{', '.join(str(i) for i in position)}]" if position else name
