"""compile_twice.py SCRATCH [TARGETS…]: copies the sources to two folders below SCRATCH, compiles targets of preset release in each, without
ccache, and compares the bytes of what they make. By default the parts of most packages that are quickest."""

import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
TARGETS = ["jointid_base", "jointid_scene", "jointid_module_digest", "jointid_restrictions", "jointid_weighting"]


def built(folder: pathlib.Path, targets: list[str]) -> dict[str, bytes]:
    """What the targets make, by name, in a copy of the sources at `folder`."""
    folder.mkdir(parents=True)
    files = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True).stdout
    subprocess.run(["tar", "--null", "-T", "-", "-cf", folder / "sources.tar"], cwd=ROOT, input=files, check=True)
    subprocess.run(["tar", "-xf", "sources.tar"], cwd=folder, check=True)
    environment = {**os.environ, "CCACHE_DISABLE": "1"}
    run = lambda *words: subprocess.run(words, cwd=folder, env=environment, check=True, stdout=subprocess.DEVNULL)
    run("cmake", "--preset", "release", "-DJOINTID_BUILD_BENCH=OFF", "-DJOINTID_SAME_BYTES=ON")
    run("cmake", "--build", "build/release", "--target", *targets)
    made = folder / "build/release"
    return {str(path.relative_to(made)): path.read_bytes() for path in sorted(made.rglob("*"))
            if path.suffix in (".a", ".so", ".o") and path.is_file()}


def main(scratch: str, *targets: str) -> None:
    here = pathlib.Path(scratch)
    one, other = (built(here / name, list(targets) or TARGETS) for name in ("one", "other/with/a/longer/name"))
    differ = [name for name in one if one[name] != other.get(name)]
    if differ or one.keys() != other.keys():
        raise SystemExit(f"other bytes in another folder: {', '.join(differ) or 'other files'}")
    objects = sum(name.endswith(".o") for name in one)
    print(f"{objects} objects and {len(one) - objects} libraries ({sum(map(len, one.values())) / 1e6:.1f} MB) have the same bytes in two folders")


if __name__ == "__main__":
    main(*sys.argv[1:])
