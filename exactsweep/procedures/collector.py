"""The garbage collector, which has nothing to do while loops are made."""

import gc


class pause_collector:  # noqa: N801
    """Keep the collector from running while many objects are made that refer to one another.

    It looks for cycles among all objects each time that their number has grown by some share. The
    kernel makes none, but 100,000 vertices make it look so often that this takes half of the time.
    """

    def __enter__(self) -> None:
        self.runs = gc.isenabled()
        gc.disable()

    def __exit__(self, *error: object) -> None:
        if self.runs:
            gc.enable()
