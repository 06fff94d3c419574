"""The part of the page that checks its scene, shows the report and gives all files."""

import asyncio
from html import escape
from typing import TYPE_CHECKING, Any, Protocol

from nicegui import ui

from fembearing.app.check import Check
from fembearing.app.computing import computed

if TYPE_CHECKING:
    from fembearing.report.report import PictureFile, Report

LOOK = 0.2  # s between two looks at a check
ABOUT = (
    "Finite elements on the true shapes of every contact, and numerical solutions of film and friction: a minute or "
    "more, in the background."
)
KINDS = ("pressure", "film", "view")  # pictures of the report that the page shows
turn = asyncio.Semaphore(1)  # of all tabs: a check takes all cores and much memory


class Shown(Protocol):
    """The page that a panel is a part of."""

    text: str  # of its scene
    evaluation: Any  # that it shows; None: none yet
    is_open: bool  # whether its tab is


class CheckPanel:
    """One check at a time, its report, and the download."""

    def __init__(self, page: Shown) -> None:
        self.page = page
        self.check: Check | None = None
        with ui.element("section").classes("panel check").props('aria-label="Check"'):
            ui.label("Check").tag = "h2"
            ui.label(ABOUT).classes("soft")
            with ui.element("div").classes("actions"):
                self.starts = ui.button("Check this scene", on_click=self.run).props("unelevated no-caps")
                self.cancels = ui.button("Cancel", on_click=self.cancel, color=None).props("outline no-caps")
                self.saves = ui.button("Download all", on_click=self.download, color=None).props("outline no-caps")
            self.bar = ui.linear_progress(value=0, show_value=False).props('aria-label="Progress of the check"')
            self.said = ui.label("").props('role="status"')
            self.report = ui.element("div").classes("stack")
        self._show()

    def follow(self, text: str) -> None:
        """Say whether the report is that of this scene."""
        self.saves.set_enabled(self.page.evaluation is not None)
        if self.check is not None and self.check.is_done:
            self.said.text = "checked" if self.check.text == text else "Report of an earlier scene."

    async def run(self) -> None:
        """Check the scene of the page, after the checks of other tabs."""
        self.close()
        check = self.check = Check(text=self.page.text)
        self._show()
        async with turn:
            if check is self.check:
                check.start()
            while check is self.check and not check.has_ended:
                await asyncio.sleep(LOOK)
                if check is self.check:
                    check.look()
                    self.bar.value, self.said.text = check.share, check.step
        if check is self.check:
            self._show()

    def close(self) -> None:
        """End the check, and remove its report."""
        check, self.check = self.check, None
        if check is not None:
            check.close()

    def cancel(self) -> None:
        """End the check."""
        self.close()
        self._show()

    async def download(self) -> None:
        """Give scene, tables, numbers and report of the torque that is shown in one file."""
        from fembearing.app.evaluation import zip_of

        found, check = self.page.evaluation, self.check
        if found is None:
            return
        checked = check.folder if check is not None and check.is_done and check.text == found.text else None
        content = await computed(zip_of, found, checked)
        ui.download.content(content, f"{found.result.scene.bearing.name.replace('/', '-')}.zip")

    def _show(self) -> None:
        """Show what can be done now, and the report of a check that has one."""
        check = self.check
        runs = check is not None and not check.has_ended
        self.starts.set_enabled(not runs)
        self.cancels.set_visibility(runs)
        self.bar.set_visibility(runs)
        self.said.text = "" if check is None else check.problem or check.step
        self.follow(self.page.text)
        self.report.clear()
        if check is not None and check.report is not None:
            with self.report:
                _show_report(check.report, f"/check/{check.token}")


def _show_report(report: "Report", address: str) -> None:
    """Headline, pictures and tables as the report itself has them, and where it is."""
    from fembearing.report.page.document import shown
    from fembearing.report.sections.contacts import contacts_section
    from fembearing.report.sections.creep import creep_section
    from fembearing.report.sections.film import film_section
    from fembearing.report.sections.headline import check_headline

    ui.html(shown(check_headline(report)), sanitize=False)
    ui.link("The whole report", f"{address}/report.html", new_tab=True)
    with ui.element("div").classes("pictures"):
        for picture in report.pictures:
            if picture.kind in KINDS:
                ui.html(_figure(picture, f"{address}/{picture.file}"), sanitize=False)
    for section in (contacts_section(report), film_section(report), creep_section(report)):
        if section.blocks:
            ui.html(shown(section), sanitize=False)


def _figure(picture: "PictureFile", address: str) -> str:
    words = escape(f"{picture.kind}, {picture.pair}, {picture.geometry}")
    shown = f'<img src="{address}" alt="{words}">'
    if picture.kind == "view":
        shown = f'<iframe src="{address}" title="{words}, to turn" loading="lazy"></iframe>'
    return f"<figure>{shown}<figcaption>{escape(picture.caption)}</figcaption></figure>"
