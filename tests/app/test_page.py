"""The page without a browser: what a user types, and what is shown then."""

import asyncio
from typing import Any

import pytest
from nicegui import ui

from analytic.errors import InputError
from analytic.scenefile.read import load_scene
from fembearing.app import evaluation
from fembearing.app.evaluation import Evaluation
from fembearing.app.page import Page
from fembearing.report.terminal.torque import print_headline
from fembearing.verify.torque.scene_torque import torque_of_scene

LONGEST = 300  # tenths of a second, for machines that do much else


def page_of(user: Any) -> Page:
    """The page of a user: its close is what the tab calls when it is gone."""
    (close,) = [each for each in user.client.delete_handlers if isinstance(getattr(each, "__self__", None), Page)]
    return close.__self__


async def settled(page: Page) -> None:
    """Wait until nothing is computed."""
    await asyncio.sleep(0.05)
    for _ in range(LONGEST):
        if not page.is_busy:
            return
        await asyncio.sleep(0.1)
    raise AssertionError("it computes without an end")
