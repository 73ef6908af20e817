"""`python -m exactsweep`, the same as the command."""

from exactsweep.cli import main

main(prog_name="exactsweep")
