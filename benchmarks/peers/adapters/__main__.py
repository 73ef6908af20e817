"""`python -m benchmarks.peers.adapters NAME`: run a program with the runner's protocol."""

from __future__ import annotations

import json
import os
import sys
from typing import Any

import click

from benchmarks.peers.adapters.adapter import Adapter, MissingError
from benchmarks.peers.adapters.names import NAMES, load
from exactsweep.conform.run.protocol import QUESTIONS, SUM, read_object
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import quote
from exactsweep.numbers.number import to_fraction


@click.command()
@click.argument("name", required=False, type=click.Choice(NAMES))
@click.option("--ask", "question", type=click.Choice(QUESTIONS), help="Answer only this question.")
def main(name: str | None, question: str | None) -> None:
    """Answer the cases on standard input with the program NAME.

    The protocol is that of 'exactsweep conform'. Without a name, list the programs and whether they
    are installed.
    """
    if name is None:
        for each in NAMES:
            click.echo(f"{each:24}{_state(each)}")
        return
    try:
        adapter = load(name)
        if question is not None:
            adapter = adapter.limited(question)
    except MissingError as error:
        raise click.ClickException(str(error)) from None
    # Libraries write messages to standard output: redirect it to standard error.
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    print(json.dumps(adapter.hello.to_json()), file=answers, flush=True)
    for line in sys.stdin:
        case = read_object(line)
        if "bye" in case:
            break
        answer = {"id": case["id"], **_answer(adapter, case)}
        print(json.dumps(answer, default=_write), file=answers, flush=True)


def _state(name: str) -> str:
    try:
        return load(name).hello.name
    except MissingError as error:
        return str(error)


def _answer(adapter: Adapter, case: dict[str, Any]) -> dict[str, Any]:
    try:
        numbers, questions = adapter.hello.numbers, adapter.hello.questions
        d, g = (
            [
                [(_number(x, numbers), _number(y, numbers)) for x, y in ring]
                for ring in (case[name], *case.get(f"{name}_holes", ()))
            ]
            for name in (("a", "b") if questions == (SUM,) else ("directrix", "generatrix"))
        )
        shapes: tuple[list[Any], list[Any]] = (d, g)
        if adapter.hello.shapes != "any":
            shapes = (d[0], g[0])
        return adapter.answer(*shapes, parts=case.get("ask", ()))
    except NotImplementedError as error:
        return {"unsupported": str(error)}
    except Exception as error:
        return {"error": f"{type(error).__name__}: {error}"}


def _number(text: str, numbers: str) -> object:
    if numbers == "rational":
        return to_fraction(text)
    try:
        return float(text) if numbers == "binary64" else int(text)
    except ValueError:
        raise NotImplementedError(f"{quote(text)} is not a number of type {numbers}") from None


def _write(value: object) -> str:
    return format_fraction(to_fraction(value))


if __name__ == "__main__":
    main()
