#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Usage: tests/programs/match/completion.py BUILD

Types words into bash, zsh and fish on a terminal of their own, presses Tab and Return, and looks at the
command that the shell then has. Catches a script of `mirocup completion` that its shell does not read, and
candidates that it takes apart in another way. A shell that is not installed is left out.
"""
import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time

# What is typed before Tab, and the words that the command then has.
CASES = [
    ("mirocup matc", "match"),
    ("mirocup match --blue stri", "match --blue striker"),
    ("mirocup match --league mid", "match --league middle"),
    ("mirocup verify my", "verify my\\ leg.json"),
    ("mirocup league compa", "league compare"),
]

# A mirocup that says with which words it was called; completion asks the program itself.
BASH = """PS1='READY> '
mirocup() { if [ "$1" = complete ]; then command mirocup "$@"; else printf 'GOT<%q' "$1"; shift
  [ $# -eq 0 ] || printf ' %q' "$@"; echo '>'; fi; }
"""
SHELLS = {
    "bash": (["bash", "--norc", "--noprofile", "-i"], BASH + "source {script}\n"),
    "zsh": (["zsh", "-f", "-i"], "autoload -U compinit; compinit -u -D\n" + BASH + "source {script}\n"),
    "fish": (["fish", "--no-config", "-i"], """function fish_prompt; echo -n 'READY> '; end
function mirocup
    if test "$argv[1]" = complete; command mirocup $argv; else; echo 'GOT<'(string join -- ' ' (string escape --no-quoted -- $argv))'>'; end
end
source {script}
"""),
}
PATIENCE = 60  # s, for a busy machine; a shell that answers is not waited for


class Terminal:
    """A shell that is typed into."""

    def __init__(self, words, folder, environment):
        self.seen = ""
        self.pid, self.screen = pty.fork()
        if self.pid == 0:
            os.chdir(folder)
            os.execvpe(words[0], words, environment)

    def type(self, text):
        os.write(self.screen, text.encode())

    def wait_for(self, pattern):
        """Returns the first match in what the shell has shown since the last one, or None."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            found = re.search(pattern, self.seen)
            if found:
                self.seen = self.seen[found.end():]
                return found
            if select.select([self.screen], [], [], 0.1)[0]:
                try:
                    self.seen += os.read(self.screen, 65536).decode(errors="replace")
                except OSError:  # the shell has ended
                    return None
        return None

    def close(self):
        os.close(self.screen)
        os.kill(self.pid, 9)
        os.waitpid(self.pid, 0)


def wrong_answers(shell, build, folder):
    script = folder / f"mirocup.{shell}"
    script.write_bytes(subprocess.run([build / "mirocup", "completion", shell], stdout=subprocess.PIPE, check=True).stdout)
    words, start = SHELLS[shell]
    begin = folder / f"begin.{shell}"
    begin.write_text(start.replace("{script}", str(script)))
    environment = {"PATH": f"{build}:/usr/bin:/bin", "HOME": str(folder), "TERM": "xterm", "LANG": "C.UTF-8"}
    terminal = Terminal(words, folder / "games", environment)
    try:
        terminal.type(f" source {begin}\r")
        if terminal.wait_for("READY> ") is None:
            return [f"{shell} does not start: {terminal.seen!r}"]
        wrong = []
        for typed, expected in CASES:
            terminal.type(typed + "\t\r")
            got = terminal.wait_for(r"[\r\n]GOT<([^>\n]*)>")
            answer = None if got is None else got[1].strip()
            if answer != expected:
                wrong.append(f"{shell}: {typed}[Tab] gives {answer}, expected {expected}; {terminal.seen[-300:]!r}")
        return wrong
    finally:
        terminal.close()


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "games").mkdir()
        (folder / "games" / "my leg.json").write_text("{}")
        wrong = []
        for shell in SHELLS:
            if shutil.which(shell) is None:
                print(f"{shell} is not installed", file=sys.stderr)
            else:
                wrong += wrong_answers(shell, build, folder)
    print("\n".join(wrong) or "ok")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
