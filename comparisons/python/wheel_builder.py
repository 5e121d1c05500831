"""Makes the wheel that `pip install .` installs (PEP 517): what `cmake --install` lays down of the
components python, fem and data, zipped. CMake, the compiler and the libraries are those of
comparisons/setup/packages.txt; nothing is downloaded.

    pip install . --no-index                                     builds in build/wheel
    pip install . --no-index --config-settings build-folder=build    takes a build that is there
"""
import base64
import hashlib
import os
import pathlib
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
import zipfile

COMPONENTS = ("python", "fem", "data")


def _project():
    return tomllib.loads(pathlib.Path("pyproject.toml").read_text(encoding="utf-8"))["project"]


def _names():
    project = _project()
    name = project["name"].replace("-", "_")
    tag = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{name}-{project['version']}", f"{tag}-{tag}-{platform}"


def _metadata():
    project = _project()
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {project['version']}",
             f"Summary: {project['description']}", f"Requires-Python: {project['requires-python']}"]
    lines += [f"Requires-Dist: {requirement}" for requirement in project["dependencies"]]
    readme = pathlib.Path(project["readme"]).read_text(encoding="utf-8")
    return "\n".join(lines) + "\nDescription-Content-Type: text/markdown\n\n" + readme


def _run(*command):
    subprocess.run([str(part) for part in command], check=True)


def _build(settings):
    """The folder of a build that holds the module."""
    folder = pathlib.Path((settings or {}).get("build-folder", "build/wheel"))
    if not (folder / "CMakeCache.txt").exists():
        _run("cmake", "-S", ".", "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
             "-DREBOUND_TESTS=OFF", "-DREBOUND_BENCHMARKS=OFF",
             f"-DPython3_EXECUTABLE={sys.executable}")
    _run("cmake", "--build", folder, "--target", "rebound_python")
    return folder


def _place(path, prefix, data):
    """Where a file of the prefix stands in the wheel: libraries at its root, the rest in its data.

    The module looks for the FE tier beside itself; `pip install --target` loses data below lib/.
    """
    return path.name if path.suffix == ".so" else f"{data}/{path.relative_to(prefix)}"


def get_requires_for_build_wheel(config_settings=None):
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    name, tag = _names()
    folder = _build(config_settings)
    files = {f"{name}.dist-info/METADATA": _metadata().encode(),
             f"{name}.dist-info/WHEEL": ("Wheel-Version: 1.0\nGenerator: rebound\n"
                                         f"Root-Is-Purelib: false\nTag: {tag}\n").encode()}
    with tempfile.TemporaryDirectory() as prefix:
        for component in COMPONENTS:
            _run("cmake", "--install", folder, "--prefix", prefix, "--component", component)
        for path in sorted(pathlib.Path(prefix).rglob("*")):
            if path.is_file() and not path.match("doc/*/*"):
                files[_place(path, prefix, f"{name}.data/data")] = path.read_bytes()
    if not any(path.startswith("rebound_impact.") for path in files):
        raise RuntimeError(f"{folder} holds no Python module: was pybind11 missing when it was configured?")
    record = "".join(
        f"{path},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode()},"
        f"{len(data)}\n" for path, data in files.items())
    files[f"{name}.dist-info/RECORD"] = (record + f"{name}.dist-info/RECORD,,\n").encode()
    wheel = f"{name}-{tag}.whl"
    unfinished = pathlib.Path(wheel_directory) / (wheel + ".part")
    with zipfile.ZipFile(unfinished, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, data in files.items():
            archive.writestr(path, data)
    os.replace(unfinished, unfinished.with_suffix(""))
    return wheel
