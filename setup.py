"""Builds the extension module by CMake. Environment: CMAKE_ARGS, options for it; JOINTID_BUILD, a build's folder to take it from (which
has to stay, unless its libraries are static: preset release)."""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


OPTIONS = {"CMAKE_BUILD_TYPE": "Release", "CMAKE_UNITY_BUILD": "ON", "CMAKE_UNITY_BUILD_BATCH_SIZE": "16",
           "CMAKE_BUILD_WITH_INSTALL_RPATH": "ON", "JOINTID_BUILD_TESTS": "OFF", "JOINTID_BUILD_GUI": "OFF", "JOINTID_PYTHON": "ON",
           "Python_EXECUTABLE": sys.executable}


class CMakeBuild(build_ext):
    """`cmake`, then the module and what it loads, copied into the package."""

    def build_extension(self, ext: Extension) -> None:
        package = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        build = Path(os.environ.get("JOINTID_BUILD") or self.build_temp).resolve()
        if "JOINTID_BUILD" not in os.environ:
            self.configure(build)
        subprocess.run(["cmake", "--build", str(build), "--parallel", str(os.cpu_count() or 1), "--target", "jointid_python_package"],
                       check=True)
        self.copy(list((build / "python/jointid").glob("_jointid.*.so")), package)
        self.copy(list((build / "modules").glob("*.so")), package / "modules")

    def configure(self, build: Path) -> None:
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        options = [f"-D{key}={value}" for key, value in OPTIONS.items()]
        given = shlex.split(os.environ.get("CMAKE_ARGS", ""))
        subprocess.run(["cmake", "-S", str(ROOT), "-B", str(build), *generator, *options, *given], check=True)

    @staticmethod
    def copy(libraries: list[Path], folder: Path) -> None:
        if not libraries:
            raise SystemExit("the build has no Python package: install the packages of scripts/install-packages python")
        folder.mkdir(parents=True, exist_ok=True)
        for library in libraries:
            shutil.copy2(library, folder)


version = re.search(r"project\(jointid VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))
setup(version=version[1] if version else "0", ext_modules=[Extension("jointid._jointid", [])], cmdclass={"build_ext": CMakeBuild})
