#!/usr/bin/env python3
"""Gives every command line of the documentation to the program, in a nearly empty folder.

Usage: check_doc_commands.py SOURCE PROGRAM   (exit 0: none is wrong usage)

Most inputs are missing there, which is exit code 3 and fine; a command or option that does not exist,
or a value that is out of range, is 2. Square brackets mark what may be left out: it is given. Prose may
name a command without its inputs.
"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

WRONG_USAGE = 2
COMMAND = re.compile(r"^(?:\S*\$\s+)?(?:\S*/)?hybridfusion\s+(.*)$")
PLACEHOLDERS = {"…", "...", "COMMAND"}


def documented(page):
    """The command lines of a page: in blocks of code and, in text, between backquotes."""
    text = page.read_text()
    blocks = re.findall(r"^ *```[^\n]*\n(.*?)^ *```", text, re.M | re.S)
    prose = re.sub(r"^ *```.*?^ *```", "", text, flags=re.M | re.S)
    lines = [(line, False) for block in blocks for line in block.replace("\\\n", " ").splitlines()]
    lines += [(line, True) for line in re.findall(r"`([^`]+)`", prose)]
    for line, is_prose in lines:
        line = re.sub(r"\s#.*$", "", line.strip()).split(" > ")[0].rstrip("<( )")
        match = COMMAND.match(line)
        if match and not PLACEHOLDERS & set(line.split()):
            line = re.sub(r"(\S)\|\S+", r"\1", match[1].replace("[", "").replace("]", ""))
            yield re.sub(r"\bN\b", "1", line), is_prose


def make_workspace(folder, program):
    """As far as `convert` looks at it before it reads the cloud."""
    (folder / "ws/vision").mkdir(parents=True)
    (folder / "ws/fused").mkdir()
    (folder / "empty").mkdir()
    (folder / "ws/vision/origin.json").write_text(
        '{"latitude_deg": 48.0, "longitude_deg": 9.0, "altitude_m": 500.0, "datum": "WGS84"}')
    (folder / "points.xyz").write_text("0 0 0\n1 2 3\n")
    subprocess.run([program, "convert", "points.xyz", "ws/fused/fused.ply"], cwd=folder, check=True,
                   capture_output=True)


def main():
    source, program = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    pages = [source / "README.md", *sorted((source / "docs").rglob("*.md"))]
    commands = subprocess.run([program, "completion", "commands"], capture_output=True, text=True,
                              check=True).stdout.split()
    tried = {}
    for page in pages:
        if page.name == "commands.md":  # the --help of the program itself
            continue
        for line, is_prose in documented(page):
            if line.split()[0] in commands or line.startswith("-"):
                tried.setdefault(line, (page.relative_to(source), is_prose))
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        make_workspace(pathlib.Path(folder), program)
        for line, (page, is_prose) in tried.items():
            words = shlex.split(line)
            if words[0] == "simulate":  # would do it: its options are read first
                words += ["--set", "simulation.drive.duration_s=0"]
            # `view` would serve what it finds.
            place = folder if words[0] == "convert" else pathlib.Path(folder) / "empty"
            result = subprocess.run([program, *words], cwd=place, capture_output=True, text=True, timeout=60)
            outside = words[0] == "simulate" and "duration_s" in result.stderr
            mention = is_prose and "is required" in result.stderr
            if result.returncode == WRONG_USAGE and not outside and not mention:
                failed += 1
                print(f"{page}: hybridfusion {line}\n  {result.stderr.strip()[-300:]}")
    print(f"{len(tried)} command lines, {failed} wrong")
    return 1 if failed or len(tried) < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
