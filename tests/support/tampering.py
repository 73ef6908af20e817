"""Values in a certificate by path: read one, or copy the certificate with another value."""

import copy
from collections.abc import Iterable, Sequence
from typing import Any


def get(item: Any, path: Iterable[Any]) -> Any:
    for key in path:
        item = item[key]
    return item


def put(item: Any, path: Sequence[Any], value: Any) -> Any:
    """Copy a certificate, or a part of it, with another value at a path."""
    changed = copy.deepcopy(item)
    get(changed, path[:-1])[path[-1]] = value
    return changed
