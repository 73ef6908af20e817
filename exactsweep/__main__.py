"""Entry point of `python -m exactsweep`, equivalent to the command."""

from exactsweep.cli import main

main(prog_name="exactsweep")
