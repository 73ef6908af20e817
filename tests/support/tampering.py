"""Values at places of a certificate: read one, or copy the certificate with another one."""

import copy
from collections.abc import Iterable, Sequence
from typing import Any


def get(item: Any, path: Iterable[Any]) -> Any:
    for key in path:
        item = item[key]
    return item


def put(item: Any, path: Sequence[Any], value: Any) -> Any:
    """Copy a certificate, or a part, with another value at one place."""
    changed = copy.deepcopy(item)
    get(changed, path[:-1])[path[-1]] = value
    return changed
