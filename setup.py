# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""Builds the Python module by CMake: `python3 -m pip install --no-build-isolation .` needs no network.

FINDSPACE_BUILD names a build folder to use again.
"""
import os
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = os.path.dirname(os.path.abspath(__file__))


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        folder = os.environ.get("FINDSPACE_BUILD") or os.path.abspath(os.path.join(self.build_temp, "cmake"))
        options = ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG",
                   "-DCMAKE_UNITY_BUILD=ON", "-DFINDSPACE_PYTHON=ON",
                   "-DPython3_EXECUTABLE=" + sys.executable]
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, *options], check=True)
        subprocess.run(["cmake", "--build", folder, "--target", "findspace_python"], check=True)
        built = os.path.join(folder, "python", "findspace")
        target = os.path.dirname(os.path.abspath(self.get_ext_fullpath(ext.name)))
        os.makedirs(target, exist_ok=True)
        for name in os.listdir(built):
            if name.startswith("_findspace"):
                self.copy_file(os.path.join(built, name), os.path.join(target, name))
        self.copy_tree(os.path.join(ROOT, "web", "built"), os.path.join(target, "page"))


setup(
    packages=["findspace"],
    package_dir={"findspace": "python/findspace"},
    package_data={"findspace": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("findspace._findspace", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
