#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The package mirocup of Python without mirocup-labs: mirocup.team works, and what is missing says where to get it. Catches a module
of plugins/python that needs one of labs, and an environment that ends in "No module named mirocup.vector_env". Usage: python_alone.py BUILD
"""
import pathlib
import shutil
import sys
import tempfile

source = pathlib.Path(sys.argv[1]) / "python" / "mirocup"
with tempfile.TemporaryDirectory() as folder:
    package = pathlib.Path(folder) / "python" / "mirocup"
    package.mkdir(parents=True)
    shutil.copy(pathlib.Path(sys.argv[1]) / "libmirocup_skills.so.0", folder)
    for name in ("__init__.py", "team.py"):
        shutil.copy(source / name, package)
    sys.path.insert(0, str(package.parent))
    import mirocup
    import mirocup.team

    assert mirocup.team.Team
    for name in mirocup.__all__:
        try:
            getattr(mirocup, name)
        except ImportError as error:
            told = str(error)
        else:
            sys.exit(f"mirocup.{name} needs no mirocup-labs")
        assert f"mirocup.{name}" in told and "mirocup-labs" in told and "--target mirocup_training" in told, told
