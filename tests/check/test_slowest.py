"""A sample of `python -m tests.slowest`: the step limit bounds the work on slow certificates."""

import json
from unittest.mock import Mock, patch

import pytest
from slowest import BYTES, KINDS

from exactsweep.check import standalone, verify


@pytest.mark.parametrize("kind", KINDS)
def test_slow_certificates_are_checked_in_bounded_time(kind: str) -> None:
    certificate = KINDS[kind](40, 2)
    assert len(json.dumps(certificate)) < BYTES
    with patch.object(standalone, "spend", Mock(side_effect=standalone.spend)) as taken:
        verdict = verify(certificate, max_steps=10**6)
    assert "not an object with keys" not in verdict.reason
    assert taken.called
