"""The page of `fembearing app`: a torque that follows its inputs. It calls the functions of the command line only.

The text of the scene is the state of a page, and each browser tab has its own. Two threads compute for all of them;
finite elements run in a process of their own.
"""

import os

# The page stores nothing. NiceGUI would read what lies in .nicegui of the working folder.
os.environ["NICEGUI_STORAGE_PATH"] = os.path.join(os.path.dirname(__file__), "storage")
