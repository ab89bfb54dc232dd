"""Builds the extension module by CMake. Options for it: the environment variable CMAKE_ARGS."""

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


class CMakeBuild(build_ext):
    """`cmake`, then the module and what it loads, copied into the package."""

    def build_extension(self, ext: Extension) -> None:
        package = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        build = Path(self.build_temp).resolve() / "cmake"
        options = {"CMAKE_BUILD_TYPE": "Release", "CMAKE_UNITY_BUILD": "ON", "CMAKE_UNITY_BUILD_BATCH_SIZE": "16",
                   "CMAKE_BUILD_WITH_INSTALL_RPATH": "ON", "JOINTID_BUILD_TESTS": "OFF", "JOINTID_BUILD_GUI": "OFF",
                   "JOINTID_PYTHON": "ON", "Python_EXECUTABLE": sys.executable}
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        cmake = ["cmake", "-S", str(ROOT), "-B", str(build), *generator, *(f"-D{key}={value}" for key, value in options.items())]
        subprocess.run([*cmake, *shlex.split(os.environ.get("CMAKE_ARGS", ""))], check=True)
        subprocess.run(["cmake", "--build", str(build), "--parallel", str(os.cpu_count() or 1), "--target", "jointid_python_package"],
                       check=True)
        modules = package / "modules"
        modules.mkdir(parents=True, exist_ok=True)
        for library in (build / "python/jointid").glob("_jointid.*.so"):
            shutil.copy2(library, package)
        for library in (build / "modules").glob("*.so"):
            shutil.copy2(library, modules)


version = re.search(r"project\(jointid VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))
setup(version=version[1] if version else "0", ext_modules=[Extension("jointid._jointid", [])], cmdclass={"build_ext": CMakeBuild})
