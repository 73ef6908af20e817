"""A pause of the garbage collector while the kernel makes loops."""

import gc


class pause_collector:  # noqa: N801
    """Disable the garbage collector in a `with` block that makes many objects.

    The collector searches all objects for cycles whenever their number has grown by some share. The
    kernel makes no cycles, but with 100,000 vertices the searches take half of the time.
    """

    def __enter__(self) -> None:
        self.runs = gc.isenabled()
        gc.disable()

    def __exit__(self, *error: object) -> None:
        if self.runs:
            gc.enable()
