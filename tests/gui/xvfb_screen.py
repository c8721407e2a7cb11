"""A virtual screen with the workbench on it, driven by keys and clicks from outside: what the stories share.

Judged is what can be seen from outside: files, the titles of windows, pictures of the screen, which stay in a folder.
A story waits for what has to happen, not for a time, and ends its screen and its programs whatever happens.
"""

import ctypes
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

TOOLS = {"Xvfb": "xvfb", "xdotool": "xdotool", "import": "imagemagick", "compare": "imagemagick"}
LONGEST_S = 170.0  # on a machine that has much else to do; a story takes a tenth of it
PATIENCE_S = 30.0
SIZE = (1280, 860)


class Failed(Exception):
    pass


def die_with_parent():
    """For children: no screen and no program outlives this script, however it ends."""
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)


def wait_for(what, condition, patience_s=PATIENCE_S):
    """Returns what the condition returned once that is true in the sense of Python."""
    end = time.monotonic() + patience_s
    while True:
        result = condition()
        if result:
            return result
        if time.monotonic() > end:
            raise Failed(f"waited in vain until {what}")
        time.sleep(0.03)


class Screen:
    def __init__(self, pictures, memory):
        self.pictures = pictures
        self.memory = memory / "Xvfb_screen0"  # What the screen shows, line by line behind a header.
        pictures.mkdir(parents=True, exist_ok=True)
        for old in pictures.glob("*.png"):
            old.unlink()
        read_end, write_end = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{SIZE[0]}x{SIZE[1]}x24", "-fbdir", str(memory), "-nolisten", "tcp", "-noreset"],
            pass_fds=[write_end], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=die_with_parent)
        os.close(write_end)
        with os.fdopen(read_end) as answer:
            number = answer.readline().strip()
        if not number:
            raise Failed("Xvfb found no free display")
        self.display = f":{number}"
        self.environment = dict(os.environ, DISPLAY=self.display)

    def close(self):
        self.server.terminate()  # it takes its lock with it
        try:
            self.server.wait(timeout=5)
        except subprocess.TimeoutExpired:
            self.server.kill()
            self.server.wait()

    def tool(self, *words):
        done = subprocess.run(words, env=self.environment, capture_output=True, text=True, timeout=PATIENCE_S)
        return done.stdout.strip()

    def picture(self, name):
        path = self.pictures / f"{name}.png"
        self.tool("import", "-window", "root", str(path))
        if not path.exists():
            raise Failed(f"no picture {name}")
        return path

    def lines(self):
        """The lines of the screen as they are now, as bytes."""
        size = 4 * SIZE[0]
        pixels = self.memory.read_bytes()[-size * SIZE[1]:]
        return [pixels[at:at + size] for at in range(0, len(pixels), size)]

    def stands_still(self, for_s=0.45, steps=3):
        """Whether fewer than 100 pixels, as of a caret that blinks, change meanwhile."""
        before = self.lines()
        for _ in range(steps):
            time.sleep(for_s / steps)
            changed = [pair for pair in zip(before, self.lines()) if pair[0] != pair[1]]
            if sum(a[i:i + 4] != b[i:i + 4] for a, b in changed[:100] for i in range(0, len(a), 4)) >= 100:
                return False
        return True

    def differing_pixels(self, one, other, rows=SIZE[1]):
        """How many pixels of the upper rows differ by more than 5 %."""
        return self.differing_in(one, other, (0, 0, SIZE[0], rows))

    def differing_in(self, one, other, area):
        """The same of a part of the screen: left, top, width, height."""
        part = "[{2}x{3}+{0}+{1}]".format(*area)
        done = subprocess.run(["compare", "-metric", "AE", "-fuzz", "5%", f"{one}{part}", f"{other}{part}", "null:"],
                              env=self.environment, capture_output=True, text=True, timeout=PATIENCE_S)
        return int(float(done.stderr.split()[0]))

    def window(self, title):
        """The number of the window whose title fits, once there is one; it has the keyboard then."""
        def find():
            return self.tool("xdotool", "search", "--onlyvisible", "--name", title).split()
        number = wait_for(f"a window is called '{title}'", find)[-1]
        self.tool("xdotool", "windowfocus", "--sync", number)
        return number

    def back_from(self, title):
        """Waits until a dialog is closed, and gives the keyboard to the main window, whose number it returns.

        Not before: a dialog that waits for its answer takes the keyboard back, and would take it along when it closes.
        """
        wait_for(f"the window '{title}' is closed", lambda: not self.has_window(title))
        return self.window("Sarsim")

    def has_window(self, title):
        return bool(self.tool("xdotool", "search", "--onlyvisible", "--name", title))

    def wait_for_title(self, number, title):
        wait_for(f"the title is '{title}'", lambda: self.tool("xdotool", "getwindowname", number) == title)

    def press(self, *keys):
        for key in keys:
            self.tool("xdotool", "key", key)

    def type(self, text):
        self.tool("xdotool", "key", "ctrl+a")
        self.tool("xdotool", "type", "--delay", "2", text)
        self.tool("xdotool", "key", "Return")


class Program:
    """The workbench, with folders of its own for settings and copies."""

    def __init__(self, screen, program, home, script=None):
        environment = dict(screen.environment, QT_QPA_PLATFORM="xcb", HOME=str(home), XDG_DATA_HOME=str(home / "data"),
                           XDG_CONFIG_HOME=str(home / "config"), XDG_RUNTIME_DIR=str(home / "run"),
                           QT_SCALE_FACTOR="1", LC_ALL="C.UTF-8")
        (home / "run").mkdir(mode=0o700, exist_ok=True)
        self.process = subprocess.Popen([program, "--light"] + ([str(script)] if script else []), env=environment,
                                        preexec_fn=die_with_parent)

    def kill(self):
        self.process.kill()
        self.process.wait()

    def wait_for_end(self):
        return self.process.wait(timeout=PATIENCE_S)


def expect(condition, what):
    if not condition:
        raise Failed(what)


def place_main_window(screen, number):
    """Gives the window its place and its size: once it is at rest, and again where it took another, as no one else watches."""
    size = f"{SIZE[0]}x{SIZE[1]}"

    def has_size():
        if size in screen.tool("xdotool", "getwindowgeometry", number):
            return True
        screen.tool("xdotool", "windowmove", number, "0", "0")
        screen.tool("xdotool", "windowsize", number, str(SIZE[0]), str(SIZE[1]))
        time.sleep(0.1)
        return False
    wait_for("the window is at rest", screen.stands_still)
    wait_for("the window has its size", has_size)


def wait_until_drawn(screen, name, other=None, area=(0, 0, *SIZE), pixels=50):
    """A picture of the screen that does not change any more and, where another is given, differs from that.

    More than so many pixels of an area (left, top, width, height) have to differ: what is waited for comes after the
    answer of other windows, late on a machine that has much else to do.
    """
    def drawn():
        # The live image comes coarse first and pauses before it is whole.
        return screen.stands_still() and (other is None or screen.differing_in(screen.picture(name), other, area) > pixels)
    wait_for(f"the screen shows {name}", drawn)
    return screen.picture(name) if other is None else screen.pictures / f"{name}.png"


def run_story(pictures, tell):
    """Runs tell(screen, home). Exit status: 0 it went well, 1 it failed, 77 what it needs is not installed."""
    missing = sorted({package for tool, package in TOOLS.items() if shutil.which(tool) is None})
    if missing:
        print(f"skipped: this needs {', '.join(missing)}; tools/install-deps compare installs them")
        return 77

    def stop(number, _):
        raise Failed(f"ended by signal {number}" if number != signal.SIGALRM else f"it took longer than {LONGEST_S} s")
    for number in (signal.SIGALRM, signal.SIGTERM, signal.SIGINT):
        signal.signal(number, stop)
    signal.setitimer(signal.ITIMER_REAL, LONGEST_S)
    begin = time.monotonic()
    folders = [tempfile.TemporaryDirectory(prefix=f"sarsim-{use}-", ignore_cleanup_errors=True) for use in ("story", "screen")]
    with folders[0] as home, folders[1] as memory:
        screen = None
        try:
            screen = Screen(pictures, Path(memory))
            tell(screen, Path(home))
            print(f"the story took {time.monotonic() - begin:.1f} s; pictures: {pictures}")
            return 0
        except (Failed, subprocess.TimeoutExpired) as failure:
            print(f"failed after {time.monotonic() - begin:.1f} s: {failure}")
            if screen is not None and screen.server.poll() is None:
                subprocess.run(["import", "-window", "root", str(pictures / "failed.png")], env=screen.environment,
                               timeout=10, check=False)
                print(f"the screen then: {pictures / 'failed.png'}")
            return 1
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            if screen is not None:
                screen.close()
