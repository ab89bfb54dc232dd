"""search_test.py HTML: asks the search of the built site, in headless Chromium and without a network, for the words of tests/docs/tasks.md;
one of the pages that answer has to be among the first three results."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from urllib.parse import quote

HERE = pathlib.Path(__file__).resolve().parent
FIRST = 3
ROW = re.compile(r"^\| ([^|]+) \| ([^|]+) \| ([^|]+) \|$", re.MULTILINE)
RESULTS = re.compile(r'<ul class="search">(.*?)</ul>', re.DOTALL)
LINK = re.compile(r'<li[^>]*><a href="([^"#?]+)\.html')


def tasks() -> list[tuple[str, str, list[str]]]:
    rows = ROW.findall((HERE / "tasks.md").read_text(encoding="utf-8"))[1:]
    return [(task, words.strip(), [page.strip() for page in pages.split(",")]) for task, words, pages in rows if not task.startswith("---")]


def browser() -> str:
    for name in ("chromium", "chromium-browser", "google-chrome"):
        if found := shutil.which(name):
            return found
    sys.exit(subprocess.run([HERE.parent / "skip.sh", "no Chromium (Debian package chromium)"], check=False).returncode)


def found_pages(program: str, site: pathlib.Path, words: str, profile: str) -> list[str]:
    """Pages in the order of the results, each once."""
    address = f"file://{site}/search.html?q={quote(words)}"
    done = subprocess.run([program, "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
                           "--disable-component-update", "--disable-sync", "--allow-file-access-from-files",
                           f"--user-data-dir={profile}", "--virtual-time-budget=20000", "--dump-dom", address],
                          capture_output=True, text=True, timeout=120, check=True)
    results = RESULTS.search(done.stdout)
    return list(dict.fromkeys(LINK.findall(results[1]))) if results else []


def main(site: pathlib.Path) -> int:
    program, wrong = browser(), 0
    with tempfile.TemporaryDirectory() as profile:
        for task, words, pages in tasks():
            there = [page for page in pages if (site / f"{page}.html").exists()]
            found = found_pages(program, site, words, profile)
            place = next((found.index(page) + 1 for page in found if page in there), None)
            ok = place is not None and place <= FIRST
            wrong += not ok
            print(f"{'ok  ' if ok else 'FAIL'} {words!r}: {place or 'not found'} of {len(found)}; first {', '.join(found[:FIRST])} ({task})")
    print(f"tasks: {wrong} of {len(tasks())} not answered by the first {FIRST} results")
    return 1 if wrong or len(tasks()) < 10 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
