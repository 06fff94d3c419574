"""Pages whose commands are run, and whose output is what the commands print.

In a page a comment before a block says what the block is for:

    <!-- file: my.toml -->    the block is this file
    <!-- run -->              the block is run: `fembearing` commands, or Python
    <!-- run, status 1 -->    the same, and its commands end with this status
    <!-- run, long -->        the same; it takes ten seconds or more, and the gate does not go past it
    <!-- output -->           the block is what the last command before it printed; a line "..." stands for any lines

    python -m tests.executed_pages PAGE ...

runs pages and writes new numbers into their outputs, where nothing but numbers has changed; an empty output gets all
that was printed.
"""

import contextlib
import io
import os
import re
import shlex
import shutil
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
BLOCK = re.compile(
    r"<!-- (?P<mark>run(?P<long>, long)?(?:, status (?P<status>\d+))?|output|file: (?P<file>[\w.-]+)) -->\n"
    r"```(?P<kind>\w+)\n(?P<text>.*?)```\n",
    re.DOTALL,
)
NUMBER = re.compile(r"(?<![\w.])[+-]?\d+\.?\d*(?:e[+-]?\d+)?(?![\w])")
LEFT_OUT = "..."
SECONDS = re.compile(r"\d+(?:\.\d+)? s\b")  # of a computation: no page promises them


@dataclass(frozen=True)
class Output:
    """An output of a page beside what was printed."""

    place: tuple[int, int]  # of its text in the page
    expected: str
    printed: str


def outputs(page: str, *, whole: bool = True) -> Iterator[Output]:
    """Run a page in the working folder; gives each output with what was printed.

    whole : else only what comes before its first long block
    """
    printed, names = "", {"__name__": "__main__"}
    for block in BLOCK.finditer(page):
        if block["long"] and not whole:
            return
        text = block["text"]
        if block["file"]:
            Path(block["file"]).write_text(text, "utf-8")
        elif block["mark"] == "output":
            yield Output(block.span("text"), text, printed)
        elif block["kind"] == "python":
            printed = printed_by_python(text, names)
        else:
            status = int(block["status"] or 0)
            printed = [printed_by_command(command, status) for command in commands_in(text)][-1]


def commands_in(text: str) -> Iterator[str]:
    """The commands of a block, one a line; a backslash continues one."""
    for line in text.replace("\\\n", " ").splitlines():
        if line.strip():
            yield line.strip()


def printed_by_command(line: str, status: int = 0) -> str:
    """What a `fembearing` command prints, on a terminal of 80 columns.

    Raises RuntimeError for one that ends with another status.
    """
    from fembearing.cli import main

    words = shlex.split(line, comments=True)
    program, *arguments = words
    if Path(program).name != "fembearing":
        raise RuntimeError(f"{line!r} is no command of fembearing")
    out, before = io.StringIO(), sys.argv
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(io.StringIO()) as errors:
        sys.argv = ["fembearing", *arguments]
        try:
            main()
        except SystemExit as stop:
            if int(stop.code or 0) != status:
                raise RuntimeError(f"{line}: status {stop.code}: {errors.getvalue().strip()}") from None
        finally:
            sys.argv = before
    return out.getvalue()


def printed_by_python(text: str, names: dict[str, Any]) -> str:
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(text, "page", "exec"), names)
    return out.getvalue()


def differences(output: Output) -> list[str]:
    """The expected lines that were not printed, in this order."""
    lines = output.printed.splitlines()
    place, missing, anywhere = 0, [], False
    for line in output.expected.splitlines():
        if line.strip() == LEFT_OUT:
            anywhere = True
            continue
        found = next((n for n in range(place, len(lines)) if same(line, lines[n], numbers=True)), None)
        if found is None or (not anywhere and found != place):
            missing.append(line)
        else:
            place = found + 1
        anywhere = False
    return missing


def same(expected: str, printed: str, *, numbers: bool) -> bool:
    """Whether a line says the same; numbers : whether its numbers have to agree to two units of their last digit.

    Two units: the last digit may round the other way on another machine, in both of two numbers that are compared.
    """
    expected, printed = (" ".join(SECONDS.sub("0 s", line).split()) for line in (expected, printed))
    if re.sub(r"[─-]{3,}", "-", NUMBER.sub("0", expected)) != re.sub(r"[─-]{3,}", "-", NUMBER.sub("0", printed)):
        return False
    pairs = zip(NUMBER.findall(expected), NUMBER.findall(printed), strict=True)
    return not numbers or all(abs(float(a) - float(b)) <= 2.001 * last_digit(a) for a, b in pairs)


def last_digit(number: str) -> float:
    mantissa, _, power = number.partition("e")
    return 10.0 ** (int(power or 0) - len(mantissa.partition(".")[2]))


def renewed(output: Output) -> str:
    """The expected text with the numbers that were printed; all that was printed for an empty one."""
    if not output.expected.strip():
        return "".join(f"{line.rstrip()}\n" for line in output.printed.splitlines())
    lines, place, text = output.printed.splitlines(), 0, ""
    for line in output.expected.splitlines():
        found = next((n for n in range(place, len(lines)) if same(line, lines[n], numbers=False)), None)
        if found is None:
            text += f"{line}\n"
        else:
            text, place = f"{text}{lines[found].rstrip()}\n", found + 1
    return text


def run_in(folder: Path, page: Path, *, whole: bool = True) -> list[Output]:
    """Run a page in a folder that has the data and scenes of the examples, as on a terminal of 80 columns.

    whole : else only what comes before its first long block
    """
    (folder / "examples").mkdir()
    for file in (*EXAMPLES.glob("*.csv"), *EXAMPLES.glob("*.toml")):
        shutil.copy(file, folder / "examples")
    before, columns = Path.cwd(), os.environ.get("COLUMNS")
    os.chdir(folder)
    os.environ["COLUMNS"] = "80"
    try:
        return list(outputs(page.read_text("utf-8"), whole=whole))
    finally:
        os.chdir(before)
        os.environ.pop("COLUMNS")
        if columns is not None:
            os.environ["COLUMNS"] = columns


def main() -> None:
    os.environ.setdefault("OMP_NUM_THREADS", "1")  # as in the tests: last digits depend on the number of threads
    for name in sys.argv[1:]:
        page = Path(name).resolve()
        with tempfile.TemporaryDirectory() as folder:
            found = run_in(Path(folder), page)
        text = page.read_text("utf-8")
        for output in reversed(found):
            begin, end = output.place
            text = text[:begin] + renewed(output) + text[end:]
        page.write_text(text, "utf-8")


if __name__ == "__main__":
    main()
