"""The check of the documentation in a browser sees what is wrong with a page."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = Path(__file__).parents[2] / "validation" / "site_check.py"
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
SOUND = "<!DOCTYPE html><html><head><title>{title}</title></head><body><p>{inside}</p></body></html>"
DOT = "data:image/gif;base64,R0lGODlhAQABAAAAACwAAAAAAQABAAA="  # a picture of one pixel
SICK = f"""<img src="{DOT}"> <img src="gone.png" alt="a picture">
<div style="width: 600px">wide</div> <script src="https://example.org/far.js"></script>
<script>console.error("something broke")</script>"""


def checked(folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, PROGRAM, folder], capture_output=True, text=True, check=False)


@pytest.mark.slow
@pytest.mark.skipif(not any(map(shutil.which, BROWSERS)), reason="no Chromium and no Chrome")
def test_a_sick_page_is_named_with_its_faults(tmp_path: Path) -> None:
    picture = f'<img src="{DOT}" alt="a dot">'
    (tmp_path / "index.html").write_text(SOUND.format(title="sound", inside=picture), "utf-8")
    sound = checked(tmp_path)
    assert (sound.returncode, "all checks pass" in sound.stdout) == (0, True), sound.stdout
    (tmp_path / "sick.html").write_text(SOUND.format(title="sick", inside=SICK), "utf-8")
    done = checked(tmp_path)
    assert done.returncode == 1
    lines = done.stdout.splitlines()
    assert "sick.html: would fetch https://example.org/far.js" in lines
    assert any(line.startswith("sick.html at 390 pixels: the page is 6") for line in lines)  # 600 and its margins
    assert not any(line.startswith("sick.html at 1280 pixels: the page is") for line in lines)
    for width in (1280, 390):
        assert any(line.startswith(f"sick.html at {width} pixels: the picture {DOT} has no text") for line in lines)
        assert any(line.endswith("gone.png is not loaded") and f"at {width} " in line for line in lines)
        assert any(line.startswith(f"at {width} pixels: the console says") and "broke" in line for line in lines)
    assert not any(line.startswith("index.html") for line in lines)


def test_a_folder_without_a_page_is_refused(tmp_path: Path) -> None:
    done = checked(tmp_path)
    assert done.returncode == 2
    assert "site_check: " in done.stderr
