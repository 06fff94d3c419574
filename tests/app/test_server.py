"""The program as the pages of other sites, and other programs, meet it."""

import os
import re
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from pathlib import Path

import pytest
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect
from websockets.typing import Origin

PATIENCE = 120  # s: the machine may do much else
SOCKET = "/_nicegui_ws/socket.io/?EIO=4&transport=websocket"
FOREIGN = [
    {"Origin": "http://example.com"},
    {"Origin": "null"},  # of a frame without rights, or of a file
    {"Origin": "http://127.0.0.1:9"},  # another port of this machine
    {"Sec-Fetch-Site": "cross-site"},
    {"Sec-Fetch-Site": "same-site", "Sec-Fetch-Dest": "image"},
]
MOST_GROWTH = 40.0  # MB over all requests: a page has 1 MB, and 20 requests may wait for their browsers
REQUESTS = 200
BUSY = 5.0  # s without a connection


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The working folder, with what NiceGUI stores, by others."""
    stored = tmp_path_factory.mktemp("others") / ".nicegui"
    stored.mkdir()
    (stored / "storage-general.json").write_text("no {json", "utf-8")
    return stored.parent


@pytest.fixture(scope="module")
def server(folder: Path) -> Iterator[tuple[str, int]]:
    """Address and process of the program."""
    with socket.socket() as tried:
        tried.bind(("127.0.0.1", 0))
        address = f"127.0.0.1:{tried.getsockname()[1]}"
    command = [sys.executable, "-m", "fembearing", "app", "--no-browser", "--port", address.partition(":")[2]]
    # NiceGUI looks for this variable of pytest, and would simulate a server.
    variables = {name: value for name, value in os.environ.items() if name != "PYTEST_CURRENT_TEST"}
    variables["PYTHONPATH"] = os.pathsep.join(filter(None, sys.path))
    with (
        (folder / "said").open("w") as said,
        subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=said, env=variables, cwd=folder) as running,
    ):
        try:
            end = time.monotonic() + PATIENCE
            while status(f"http://{address}") is None and running.poll() is None and time.monotonic() < end:
                time.sleep(0.1)
            yield address, running.pid
        finally:
            running.terminate()


def status(address: str, headers: dict[str, str] | None = None) -> int | None:
    """Of the answer; None: nobody answers."""
    try:
        with urllib.request.urlopen(urllib.request.Request(address, headers=headers or {}), timeout=PATIENCE) as answer:
            return answer.status
    except urllib.error.HTTPError as refused:
        return refused.code
    except OSError:
        return None


@pytest.mark.parametrize("headers", FOREIGN, ids=lambda headers: " ".join(headers.values()))
def test_other_sites_get_neither_page_nor_socket_nor_report(server: tuple[str, int], headers: dict[str, str]) -> None:
    address, _ = server
    for path in ("/", "/check/token/report.html", "/_nicegui_ws/socket.io/?EIO=4&transport=polling"):
        assert status(f"http://{address}{path}", headers) == 403
    with pytest.raises(InvalidStatus) as refused:
        connect(f"ws://{address}{SOCKET}", additional_headers=headers)
    assert refused.value.response.status_code == 403


def test_a_browser_gets_them_by_the_own_names_alone(server: tuple[str, int]) -> None:
    address, _ = server
    by_name = address.replace("127.0.0.1", "localhost")
    for own in (address, by_name):
        assert status(f"http://{own}", {"Sec-Fetch-Site": "none"}) == 200
        with connect(f"ws://{own}{SOCKET}", origin=Origin(f"http://{own}")) as open_socket:
            assert "sid" in str(open_socket.recv(PATIENCE))
    assert status(f"http://{address}/check/token/report.html") == 404
    assert status(f"http://{address}", {"Host": "example.com"}) == 400


@pytest.mark.nightly  # it waits longer than the page's grace
def test_a_browser_that_was_too_busy_to_answer_finds_its_page_again(server: tuple[str, int]) -> None:
    """Else it would begin anew: without the scene of the user, and with the usual bearing in the download."""
    address, _ = server
    with urllib.request.urlopen(f"http://{address}", timeout=PATIENCE) as page:
        client = re.search(r"client_id[\"']*: *[\"']([\w-]+)", page.read().decode())
    assert client
    asked = f"&implicit_handshake=true&client_id={client[1]}&tab_id=one&document_id=one"
    for pause in (BUSY, 0):
        with connect(f"ws://{address}{SOCKET}{asked}") as open_socket:
            open_socket.recv(PATIENCE)
            open_socket.send("40")  # as the browser asks for what is behind the socket
            assert str(open_socket.recv(PATIENCE)).startswith("40")
        time.sleep(pause)


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="the memory is read from /proc")
def test_requests_without_a_browser_take_no_memory(server: tuple[str, int]) -> None:
    address, process = server

    def memory() -> float:
        """Resident, MB."""
        lines = Path(f"/proc/{process}/status").read_text("utf-8").splitlines()
        return next(float(line.split()[1]) for line in lines if line.startswith("VmRSS")) / 1e3

    before = memory()
    for _ in range(REQUESTS):
        assert status(f"http://{address}", {"Sec-Fetch-Site": "none"}) == 200
    assert memory() - before < MOST_GROWTH


def test_what_others_stored_in_the_working_folder_is_not_read(server: tuple[str, int], folder: Path) -> None:
    assert status(f"http://{server[0]}") == 200
    assert "storage" not in (folder / "said").read_text("utf-8")
