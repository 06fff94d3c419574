"""The server of the page, on this machine alone."""

from importlib.resources import files

from fastapi import HTTPException
from fastapi.responses import FileResponse
from nicegui import app, ui
from starlette.datastructures import Headers
from starlette.middleware.trustedhost import TrustedHostMiddleware
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Receive, Scope, Send

from fembearing.app import computing
from fembearing.app.check import CHECKS
from fembearing.app.page import Page, after_handshake

HOST = "127.0.0.1"
NAMES = [HOST, "localhost"]  # by which a browser may ask: a page of a stranger that is led here has another
PRIMARY = "#1f6fb2"  # white letters on it have a contrast of 5.2
OWN = ("none", "same-origin")  # of the header Sec-Fetch-Site: a user has typed the address, or the page itself asks
REFUSAL = "This page is not for other sites: type its address into the browser.\n"


class OwnSite:
    """Refuses what the page of another site, or of another port of this machine, asks for."""

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        given = Headers(scope=scope) if scope["type"] in ("http", "websocket") else {}
        own = f"http://{given.get('host')}"
        if given.get("origin", own) != own or given.get("sec-fetch-site", OWN[0]) not in OWN:
            await PlainTextResponse(REFUSAL, 403)(scope, receive, send)
        else:
            await self.app(scope, receive, send)


def serve(port: int, *, shows: bool) -> None:
    """Serve pages until the process is ended;  shows : open the browser"""
    add_report()
    app.add_middleware(OwnSite)
    app.add_middleware(TrustedHostMiddleware, allowed_hosts=NAMES)
    app.on_shutdown(close)
    app.colors(primary=PRIMARY)
    ui.add_css(files("fembearing.app").joinpath("style.css").read_text("utf-8"), shared=True)
    ui.run(
        after_handshake(Page),
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
