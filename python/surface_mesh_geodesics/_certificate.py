from __future__ import annotations

from typing import NamedTuple


class Condition(NamedTuple):
    """One condition of a certificate."""

    violation: float  #: the largest violation, relative; 0 if there is none
    vertex: int  #: the vertex where it is violated most, or -1
    number_of_checks: int


class Certificate(NamedTuple):
    """The result of checking distances, whoever has computed them. Made by `Solver.certify()`.

    >>> import surface_mesh_geodesics as smg
    >>> c = smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).certify([0, 3, 4.5], 0)
    >>> c.is_certified(), c.conditions["EDGES"].vertex
    (False, 2)
    """

    worst_violation: float  #: the largest violation of all conditions, relative
    conditions: dict[str, Condition]

    def is_certified(self, tolerance: float = 2.0**-40) -> bool:
        """Are the distances exact up to the tolerance, a relative number?

        >>> import surface_mesh_geodesics as smg
        >>> s = smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        >>> s.certify([0, 3, 4], 0).is_certified(1e-15)
        True
        """
        return self.worst_violation <= tolerance
