"""Checks of arguments: each error names the argument, the element and the rule."""

from __future__ import annotations

import numbers
import os
from typing import Any, NamedTuple

import numpy as np

from ._path import Curve

LARGEST = np.finfo(np.float64).max


def points_of(name: str, values: Any) -> np.ndarray:
    """Returns an array of shape (n, 3) and type float64 in C order; copies only if it must."""
    array = numbers_of(name, values)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} has shape {array.shape}, but (n, 3) is needed")
    with np.errstate(over="ignore"):
        array = np.ascontiguousarray(array, dtype=np.float64)
    check_elements(name, array, ~np.isfinite(array), "not a finite number")
    return array


def triangles_of(name: str, values: Any, n: int) -> np.ndarray:
    """Returns an array of shape (m, 3) and type int64 in C order with entries from 0 to n-1."""
    if isinstance(values, (list, tuple)):
        for i, face in enumerate(values):
            if hasattr(face, "__len__") and len(face) != 3:
                raise ValueError(f"{name}[{i}] has {len(face)} corners: each face must be a triangle")
    array = numbers_of(name, values)
    if array.ndim <= 2 and array.size == 0:
        return np.zeros((0, 3), dtype=np.int64)
    if array.ndim == 2 and array.shape[1] != 3:
        raise ValueError(f"{name}[0] has {array.shape[1]} corners: each face must be a triangle")
    if array.ndim != 2:
        raise ValueError(f"{name} has shape {array.shape}, but (m, 3) is needed")
    return ids_of(name, array, n, "vertices")


def ids_of(name: str, values: Any, n: int, what: str) -> np.ndarray:
    """Returns an array of type int64 in C order; rejects entries that are not ids of the n elements."""
    array = numbers_of(name, values)
    if array.dtype.kind == "f":
        check_elements(name, array, ~(np.isfinite(array) & (array == np.floor(array))), "not an integer")
    bad = np.asarray((array < 0) | (array >= n))
    if bad.any():
        position = tuple(np.argwhere(bad)[0])
        raise IndexError(f"{_element(name, position)} is {array[position]}, but there are {n} {what}, counted from 0")
    return np.ascontiguousarray(array, dtype=np.int64).reshape(array.shape)


def row_of_ids(name: str, values: Any, n: int, what: str = "vertices") -> np.ndarray:
    """Returns one id or a row of ids as an array of one dimension."""
    return _row(name, ids_of(name, values, n, what), what)


def faces_of(name: str, values: Any, m: int) -> np.ndarray:
    """Returns ids of faces; they may be given as m booleans."""
    are_flags = isinstance(values, (list, tuple)) and len(values) > 0 and all(isinstance(v, bool) for v in values)
    if not are_flags and getattr(values, "dtype", None) != np.bool_:
        return row_of_ids(name, values, m, "faces")
    if np.shape(values) != (m,):
        raise ValueError(f"{name} has shape {np.shape(values)}, but there are {m} faces")
    return np.flatnonzero(values).astype(np.int64)


class Places(NamedTuple):
    """Points of a surface: entry i is vertex[i], or if that is -1 the point of face[i] with coordinates weight[i].

    The last two arrays may be empty if all are vertices.
    """

    vertex: np.ndarray
    face: np.ndarray
    weight: np.ndarray


def places_of(name: str, values: Any, n_vertices: int, n_faces: int) -> Places:
    """Reads a vertex, a pair (face, coordinates), a sequence of these, or a pair of arrays (faces, coordinates)."""
    if _is_pair(name, values):
        return _points_of_faces(name, values, n_faces)
    if isinstance(values, (list, tuple)) and any(isinstance(value, tuple) for value in values):
        parts = [_place(f"{name}[{i}]", value, n_vertices, n_faces) for i, value in enumerate(values)]
        return Places(*(np.concatenate(arrays) for arrays in zip(*parts)))
    return Places(row_of_ids(name, values, n_vertices), np.zeros(0, dtype=np.int64), np.zeros((0, 3)))


def has_curves(values: Any) -> bool:
    return isinstance(values, Curve) or isinstance(values, (list, tuple)) and any(isinstance(v, Curve) for v in values)


def curves_of(name: str, values: Any, n_vertices: int, n_faces: int) -> list[tuple[Places, bool]]:
    """Reads a curve, or places of which some may be curves: the places of each curve, and whether it is closed."""
    curves = []
    for i, value in enumerate(values if has_curves(values) and not isinstance(values, Curve) else [values]):
        if isinstance(value, Curve):
            curve = name if value is values else f"{name}[{i}]"
            places = places_of(f"places of {curve}", value.places, n_vertices, n_faces)
            if len(places.vertex) == 0:
                raise ValueError(f"{curve} is a curve without places")
            curves.append((places, bool(value.closed)))
        else:
            curves += [(place, False) for place in single_places(places_of(name, value, n_vertices, n_faces))]
    return curves


def single_places(places: Places) -> list[Places]:
    return [Places(*(array[k:k + 1] for array in places)) for k in range(len(places.vertex))]


def offsets_of(name: str, values: Any, n: int) -> np.ndarray:
    """Returns n numbers that are finite and not negative, or none."""
    array = weights_of(name, values, n)
    check_elements(name, array, array < 0, "but it must not be negative")
    return array + 0.0  # without a sign


def weights_of(name: str, values: Any, n: int) -> np.ndarray:
    """Returns n numbers that are finite, or none."""
    return np.zeros(0) if values is None else finite_row_of(name, values, n)


def finite_row_of(name: str, values: Any, n: int) -> np.ndarray:
    """Returns n numbers that are finite."""
    array = row_of_numbers(name, values)
    if array.shape != (n,):
        raise ValueError(f"{name} has shape {array.shape}, but {n} {'number is' if n == 1 else 'numbers are'} needed")
    check_elements(name, array, ~np.isfinite(array), "not a finite number")
    return array


def row_of_numbers(name: str, values: Any) -> np.ndarray:
    """Returns one number or a row of numbers as an array of one dimension and type float64."""
    return _row(name, numbers_of(name, values).astype(np.float64), "numbers")


def values_of(name: str, values: Any, n: int, what: str = "vertices") -> np.ndarray:
    """Returns a number for each of n elements."""
    array = numbers_of(name, values)
    if array.shape != (n,):
        raise ValueError(f"{name} has shape {array.shape}, but there are {n} {what}")
    return np.ascontiguousarray(array, dtype=np.float64)


def row_without_nan(name: str, values: Any) -> np.ndarray:
    array = row_of_numbers(name, values)
    check_elements(name, array, np.isnan(array), "not a number")
    return array


def count_of(name: str, value: Any, least: int, most: int = 2**31 - 1) -> int:
    is_number = isinstance(value, numbers.Real) and not isinstance(value, (bool, np.bool_))
    if not is_number or not least <= value <= most or int(value) != value:
        raise ValueError(f"{name} is {value!r}, but an integer from {least} to {most} is needed")
    return int(value)


def length_of(name: str, value: Any, least: float, rule: str, most: float = np.inf) -> float:
    """Returns a number from `least` to `most`; infinity counts."""
    array = numbers_of(name, value)
    if array.ndim != 0 or not least <= array <= most:
        raise ValueError(f"{name} is {value!r}: it must be {rule}")
    return float(array) + 0.0  # a zero has no sign


def finite_of(name: str, value: Any, least: float = -LARGEST, rule: str = "a finite number") -> float:
    return length_of(name, value, least, rule, LARGEST)


def rows_of(name: str, value: Any) -> tuple[int, int]:
    """Returns the pair (first row, row behind the last one); None stands for all rows."""
    if value is None:
        return 0, 2**63 - 1
    if not isinstance(value, (tuple, list)) or len(value) != 2:
        raise ValueError(f"{name} is {value!r}, but a pair (first row, row behind the last one) is needed")
    first = count_of(f"{name}[0]", value[0], 0)
    return first, count_of(f"{name}[1]", value[1], first)


def radius_of(name: str, value: Any) -> float:
    return length_of(name, value, 0.0, "a number that is not negative")


def call_of(threads: int | None, progress: Any) -> tuple[int, Any]:
    """How a call computes: the number of threads, where None stands for all processors that this process may use, and
    the function that it tells of its progress, or None."""
    if threads is None:
        threads = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return count_of("threads", threads, 1), function_of("progress", progress)


def relaxation_of(iterations: int, threshold: float, on_iteration: Any) -> tuple[int, float, Any]:
    return (count_of("iterations", iterations, 0), radius_of("threshold", threshold),
            function_of("on_iteration", on_iteration))


def function_of(name: str, value: Any) -> Any:
    """Returns a function, or None."""
    if value is not None and not callable(value):
        raise ValueError(f"{name} is {value!r}, but a function is needed")
    return value


def numbers_of(name: str, values: Any) -> np.ndarray:
    """Returns an array of integers or floats."""
    try:
        array = np.asarray(values)
    except (ValueError, OverflowError) as error:
        raise ValueError(f"{name} is not an array of numbers: {error}") from None
    if np.ma.is_masked(values):
        raise ValueError(f"{name} has masked elements")
    if array.dtype.kind not in "iuf" and array.size > 0 or array.dtype.kind in "SUO":
        raise ValueError(f"{name} has the type {array.dtype}, but numbers are needed")
    return array


def _row(name: str, array: np.ndarray, what: str) -> np.ndarray:
    if array.ndim > 1:
        raise ValueError(f"{name} has shape {array.shape}, but one row of {what} is needed")
    return np.atleast_1d(array)


def _place(name: str, value: Any, n_vertices: int, n_faces: int) -> Places:
    if _is_pair(name, value) and np.ndim(value[0]) == 0:
        return _points_of_faces(name, value, n_faces)
    ids = row_of_ids(name, value, n_vertices)
    if len(ids) != 1:
        raise ValueError(f"{name} is {value!r}, but a vertex or a pair (face, coordinates) is needed")
    return Places(ids, np.full(1, -1, dtype=np.int64), np.zeros((1, 3)))


def _points_of_faces(name: str, values: Any, n_faces: int) -> Places:
    faces = np.atleast_1d(ids_of(f"face of {name}", values[0], n_faces, "faces"))
    given = numbers_of(f"coordinates of {name}", values[1])
    weights = np.atleast_2d(given).astype(np.float64)
    if weights.shape != (len(faces), 3):
        raise ValueError(f"coordinates of {name} have the shape {given.shape}, but (k, 3) is needed for k faces")
    # The sum and the signs may err by the rounding of the type.
    tolerance = 1e-9 if given.dtype.kind != "f" or given.dtype.itemsize >= 8 else 8 * float(np.finfo(given.dtype).eps)
    sums = weights.sum(axis=1)
    bad = ~((weights >= -tolerance).all(axis=1) & (np.abs(sums - 1) <= tolerance))
    if bad.any():
        i = int(np.argmax(bad))
        raise ValueError(f"coordinates {weights[i].tolist()} of {name} (point {i}) are not in the face: none may be "
                         "negative, and their sum must be 1")
    inexact = (np.abs(sums - 1) > 1e-15) | (weights < 0).any(axis=1)
    positive = np.maximum(weights[inexact], 0)
    weights[inexact] = positive / positive.sum(axis=1, keepdims=True)
    return Places(np.full(len(faces), -1, dtype=np.int64), faces, np.ascontiguousarray(weights))


def _is_pair(name: str, value: Any) -> bool:
    """Is this (face, coordinates) or (faces, coordinates), and not two vertices or two places?"""
    if not (isinstance(value, tuple) and len(value) == 2 and hasattr(value[1], "__len__")):
        return False
    if any(isinstance(part, (str, bytes)) or _is_place(part) for part in value):
        return False
    coordinates = numbers_of(f"coordinates of {name}", value[1])
    return coordinates.size > 1 or coordinates.ndim == 2


def _is_place(part: Any) -> bool:
    return isinstance(part, tuple) and len(part) == 2 and not hasattr(part[0], "__len__") and hasattr(part[1], "__len__")


def check_elements(name: str, array: np.ndarray, is_bad: np.ndarray, rule: str) -> None:
    if is_bad.any():
        position = tuple(np.argwhere(is_bad)[0])
        raise ValueError(f"{_element(name, position)} is {array[position]}, {rule}")


def _element(name: str, position: tuple) -> str:
    return f"{name}[{', '.join(str(i) for i in position)}]" if position else name
