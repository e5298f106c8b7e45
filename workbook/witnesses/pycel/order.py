"""The order in which cells are evaluated: each after what it needs."""

from collections.abc import Iterator, Mapping, Sequence


class _Visit:
    """A key under way: what it has still to look at, and the outermost key that it leads back to."""

    __slots__ = ("back", "key", "rest", "via")

    def __init__(self, key: int, rest: Iterator[int], depth: int) -> None:
        self.key, self.rest = key, rest
        self.back, self.via = depth + 1, key  # deeper than itself: it leads back to nothing


def ordered(needs: Mapping[int, Sequence[int]]) -> tuple[list[int], dict[int, int]]:
    """Return the keys of ``needs`` so that each follows those it needs, and the keys of cycles.

    Depth first, without recursion: a chain may be as long as a sheet. Each key of a cycle comes with the one
    that it needs in that cycle; a cycle is cut where it was noticed. Needs that are no keys are passed over.
    """
    order: list[int] = []
    cyclic: dict[int, int] = {}
    depth: dict[int, int] = {}  # of a key under way; -1 when done
    for start in needs:
        if start in depth:
            continue
        path = [_Visit(start, iter(needs[start]), 0)]
        depth[start] = 0
        while path:
            visit = path[-1]
            for need in visit.rest:
                if need not in needs:
                    continue
                there = depth.get(need)
                if there is None:
                    depth[need] = len(path)
                    path.append(_Visit(need, iter(needs[need]), len(path)))
                    break
                if 0 <= there < visit.back:
                    visit.back, visit.via = there, need
            else:
                _leave(path, depth, cyclic)
                order.append(visit.key)
    return order, cyclic


def _leave(path: list[_Visit], depth: dict[int, int], cyclic: dict[int, int]) -> None:
    visit = path.pop()
    depth[visit.key] = -1
    if visit.back <= len(path):
        cyclic[visit.key] = visit.via
    if visit.back < len(path) and visit.back < path[-1].back:
        path[-1].back, path[-1].via = visit.back, visit.key
