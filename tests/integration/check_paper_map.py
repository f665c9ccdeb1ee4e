#!/usr/bin/env python3
"""Every file, function and test that docs/explanation/paper-map.md names exists.

Usage: check_paper_map.py SOURCE   (exit 0: all do)
"""
import fnmatch
import pathlib
import re
import sys

FILE = re.compile(r"([\w./*-]+\.(?:cpp|hpp))(?::(\w+))?")
TEST = re.compile(r"([\w/*]+)\.([\w*]+)")


def known(source):
    """Names of files, of tests as Suite.Name, and the text of all sources."""
    files, tests, text = set(), set(), []
    for folder in ("modules", "apps", "tests", "benchmarks"):
        for path in (source / folder).rglob("*.[ch]pp"):
            if "node_modules" in path.parts:
                continue
            content = path.read_text()
            files.add(path.name)
            text.append(content)
            tests |= {f"{suite}.{name}" for suite, name in
                      re.findall(r"^(?:TYPED_)?(?:TEST|TEST_F|TEST_P)\(\s*(\w+),\s*(\w+)", content, re.M)}
    return files, tests, "\n".join(text)


def main():
    source = pathlib.Path(sys.argv[1])
    files, tests, text = known(source)
    missing = []
    names = re.findall(r"`([^`]+)`", (source / "docs/explanation/paper-map.md").read_text())
    for name in names:
        file, test = FILE.fullmatch(name), TEST.fullmatch(name)
        if file:
            pattern = file[1].rsplit("/", 1)[-1]
            good = any(fnmatch.fnmatch(f, pattern) for f in files)
            good = good and (not file[2] or re.search(rf"\b{file[2]}\b", text))
        elif re.fullmatch(r"\w+_test", name):
            good = f"{name}.cpp" in files
        elif test and "Test" not in name and name[0].isupper() or (test and name[0] == "*"):
            # Parametrised suites are Instance/Suite.Name/Index.
            suites = [part for part in test[1].split("/") if part != "*" and not part.isdigit()]
            good = any(fnmatch.fnmatch(t, f"*{suite.strip('*')}*.{test[2]}") for suite in suites for t in tests)
        else:
            continue
        if not good:
            missing.append(name)
    for name in missing:
        print(f"docs/explanation/paper-map.md: {name} does not exist")
    print(f"{len(names)} names, {len(missing)} missing")
    return 1 if missing or len(names) < 100 else 0


if __name__ == "__main__":
    sys.exit(main())
