"""`fembearing app`."""

import socket
import webbrowser
from typing import Annotated

import typer

from fembearing.cli.status import say


def app(
    port: Annotated[int, typer.Option(min=1, max=65535, help="Port of the page.")] = 8080,
    no_browser: Annotated[bool, typer.Option("--no-browser", help="Start the server without a browser.")] = False,
) -> None:
    """Open an interactive page in the browser: torque for bearing, loads, speed and oil. Ctrl-C ends it.

    The server listens at 127.0.0.1 only.
    """
    from fembearing.cli.console import out

    _require_free(port)
    from fembearing.app.server import HOST, serve

    address = f"http://{HOST}:{port}"
    shows = not no_browser and _has_browser()
    if not (shows or no_browser):
        say(f"no browser found: open {address} in one, or give --no-browser")
    out.tell(f"page: {address} (Ctrl-C ends it)")
    serve(port, shows=shows)


def _require_free(port: int) -> None:
    """Raises InputError for a port that another program has, or that the system does not give."""
    from analytic.errors import InputError

    with socket.socket() as tried:
        tried.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)  # of a server that ended a moment ago
        try:
            tried.bind(("127.0.0.1", port))
        except OSError as problem:
            other = 8081 if port != 8081 else 8082
            raise InputError(
                f"--port {port} cannot be used ({problem.strerror}): give another, as --port {other}"
            ) from problem


def _has_browser() -> bool:
    try:
        webbrowser.get()
    except webbrowser.Error:
        return False
    return True
