"""`fembearing app`: what it refuses, and what it says before it serves."""

import socket
import sys
import webbrowser
from typing import Any

import pytest


def free_port() -> int:
    with socket.socket() as tried:
        tried.bind(("127.0.0.1", 0))
        return tried.getsockname()[1]


@pytest.fixture
def served(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """Calls of the server, which does not run."""
    from fembearing.app import server

    calls: list[Any] = []
    monkeypatch.setattr(server, "serve", lambda port, *, shows: calls.append((port, shows)))
    return calls


def test_it_says_where_the_page_is(command, served: list[Any]) -> None:
    port = free_port()
    told = command("app", "--port", str(port), "--no-browser")
    assert (told.status, told.err) == (0, "")
    assert told.out == f"page: http://127.0.0.1:{port} (Ctrl-C ends it)\n"
    assert served == [(port, False)]


def test_a_port_in_use_gets_one_line(command, served: list[Any]) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        told = command("app", "--port", str(port))
    assert (told.status, told.out, served) == (2, "", [])
    assert told.err.startswith(f"fembearing: --port {port} cannot be used (Address already in use): give another")
    assert told.err.count("\n") == 1


def test_a_port_that_is_none_gets_one_line(command, served: list[Any]) -> None:
    told = command("app", "--port", "70000")
    assert (told.status, told.out, told.err.count("\n"), served) == (2, "", 1, [])


def test_without_a_browser_it_says_so_and_serves(command, served: list[Any], monkeypatch: pytest.MonkeyPatch) -> None:
    def none() -> None:
        raise webbrowser.Error

    monkeypatch.setattr(webbrowser, "get", none)
    port = free_port()
    told = command("app", "--port", str(port))
    assert told.status == 0
    assert told.err == f"fembearing: no browser found: open http://127.0.0.1:{port} in one, or give --no-browser\n"
    assert served == [(port, False)]


def test_without_the_extra_it_says_what_to_install(command, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in [each for each in sys.modules if each.startswith("fembearing.app")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "nicegui", None)
    told = command("app", "--port", str(free_port()))
    assert (told.status, told.out) == (2, "")
    assert told.err == 'fembearing: app needs nicegui: pip install ".[app]" in the folder of fembearing\n'
