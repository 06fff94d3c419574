"""The server of the page, on this machine alone."""

from fastapi import HTTPException
from fastapi.responses import FileResponse
from nicegui import app, ui
from starlette.middleware.trustedhost import TrustedHostMiddleware

from fembearing.app import computing
from fembearing.app.check import CHECKS
from fembearing.app.page import Page

HOST = "127.0.0.1"
NAMES = [HOST, "localhost"]  # by which a browser may ask: a page of a stranger that is led here has another


def serve(port: int, *, shows: bool) -> None:
    """Serve pages until the process is ended;  shows : open the browser"""
    add_report()
    app.add_middleware(TrustedHostMiddleware, allowed_hosts=NAMES)
    app.on_shutdown(close)
    ui.run(
        Page,
        host=HOST,
        port=port,
        show=shows,
        title="fembearing",
        favicon="\N{GEAR}",
        dark=None,
        language="en-US",
        reload=False,
        tailwind=False,
        show_welcome_message=False,
    )


def add_report() -> None:
    """Serve the files of the checks that are shown."""

    @app.get("/check/{token}/{name}")
    def report_file(token: str, name: str) -> FileResponse:
        check = CHECKS.get(token)
        if check is None or name not in {file.name for file in check.folder.glob("*")}:
            raise HTTPException(404, "this check is closed, or its report has no such file")
        return FileResponse(check.folder / name)


def close() -> None:
    """End every check, and no longer compute."""
    for check in [*CHECKS.values()]:
        check.close()
    computing.close()
