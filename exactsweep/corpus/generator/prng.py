"""SplitMix64: random numbers that are the same in all languages.

The state is 64 bits, s. Each draw sets s to s + 0x9E3779B97F4A7C15 and returns z, where

    z = (s ^ (s >> 30)) * 0xBF58476D1CE4E5B9
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB
    z = z ^ (z >> 31)

all modulo 2^64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014). The
first state is the first eight bytes, the most significant first, of the SHA-256 of the seed text.
"""

from collections.abc import Sequence
from hashlib import sha256
from typing import TypeVar

from exactsweep.numbers.error import ExactSweepError

_T = TypeVar("_T")
_MASK = 2**64 - 1


class Prng:
    """A stream of random numbers for any seed text.

    >>> random = Prng("a seed")
    >>> [random.between(1, 6) for _ in range(8)]
    [5, 6, 3, 6, 1, 3, 3, 2]
    """

    def __init__(self, seed: str) -> None:
        self._state = int.from_bytes(sha256(seed.encode()).digest()[:8], "big")

    def bits64(self) -> int:
        self._state = (self._state + 0x9E3779B97F4A7C15) & _MASK
        z = self._state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & _MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & _MASK
        return z ^ (z >> 31)

    def between(self, low: int, high: int) -> int:
        """Draw an int from low to high inclusive, all equally likely.

        A number consists of 64-bit draws, the most significant first; numbers in the incomplete
        last multiple of the range are rejected and drawn again.
        """
        span = high - low + 1
        if span < 1:
            raise ExactSweepError(f"empty range: {low} to {high}")
        words = max(1, -(-(span - 1).bit_length() // 64))
        limit = (1 << 64 * words) // span * span
        while True:
            drawn = 0
            for _ in range(words):
                drawn = drawn << 64 | self.bits64()
            if drawn < limit:
                return low + drawn % span

    def choice(self, items: Sequence[_T]) -> _T:
        return items[self.between(0, len(items) - 1)]

    def chance(self, share: int, total: int) -> bool:
        """Draw an event with probability share / total."""
        return self.between(1, total) <= share
