"""links.py HTML: follows every link inside of a built site, to anchors too, and fails where one leads nowhere. Links to other places are
counted by host, not fetched; pages that load something from there fail: the site works without a network."""

import collections
import pathlib
import sys
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

LOADING = {("script", "src"), ("img", "src"), ("link", "href"), ("iframe", "src"), ("source", "src")}


class Page(HTMLParser):
    def __init__(self, text: str) -> None:
        super().__init__()
        self.anchors: set[str] = set()
        self.links: list[tuple[str, bool]] = []  #: and whether the page loads it
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        self.anchors |= {value for name in ("id", "name") if (value := given.get(name))}
        for name in ("href", "src"):
            if value := given.get(name):
                loads = (tag, name) in LOADING and given.get("rel") not in ("canonical", "index", "search", "next", "prev", "author")
                self.links.append((value, loads))


def main(root: pathlib.Path) -> int:
    pages = {path: Page(path.read_text(encoding="utf-8")) for path in sorted(root.rglob("*.html"))}
    dead, hosts, inside = [], collections.Counter(), 0
    for path, page in pages.items():
        for link, loads in page.links:
            parts = urlsplit(link)
            if parts.scheme in ("http", "https") or parts.netloc:
                hosts[parts.netloc] += 1
                if loads:
                    dead.append(f"{path.relative_to(root)}: loads {link}")
                continue
            if parts.scheme:
                continue
            inside += 1
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not target.is_file():
                dead.append(f"{path.relative_to(root)}: {link}")
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].anchors:
                dead.append(f"{path.relative_to(root)}: {link}: no such place there")
    print(f"links: {inside} inside of {len(pages)} pages, {len(dead)} dead; others, not followed: "
          + (", ".join(f"{host} {count}" for host, count in hosts.most_common()) or "none"))
    for each in dict.fromkeys(dead):
        print(f"links: dead: {each}", file=sys.stderr)
    return 1 if dead else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
