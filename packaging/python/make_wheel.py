#!/usr/bin/env python3
"""make_wheel.py PACKAGE VERSION OUT: writes the wheel of the built package in the folder PACKAGE (build/python/footfall) into OUT.

The wheel holds the package, in footfall.libs the libraries that its module loads, where it looks, and their licences. Those that
every system has, by the policy manylinux (PEP 600), stay outside. Programs are not part of it: runs need those of an installation."""
import base64
import hashlib
import os
import pathlib
import platform
import re
import subprocess
import sys
import zipfile

OF_THE_SYSTEM = re.compile(r"^(ld-linux.*|lib(c|m|dl|rt|util|pthread|gcc_s|stdc\+\+|z)\.so\..*)$")


def libraries_of(module):
    """[(name, path)] of what the loader finds for it."""
    said = subprocess.run(["ldd", module], check=True, capture_output=True, text=True).stdout
    missing = re.findall(r"^\s*(\S+) => not found", said, re.M)
    if missing:
        sys.exit(f"make_wheel.py: {module} needs {', '.join(missing)}, which is not installed")
    return [(name, path) for name, path in re.findall(r"^\s*(\S+) => (/\S+) ", said, re.M) if not OF_THE_SYSTEM.match(name)]


def licence_of(path):
    """(Debian package, its copyright file) of a library; None of another system's. Its folder may be named with or without /usr."""
    real = os.path.realpath(path)
    for name in (real, path, re.sub("^/usr", "", real), "/usr" + real):
        found = subprocess.run(["dpkg-query", "-S", name], capture_output=True, text=True)
        if found.returncode == 0:
            package = found.stdout.split(":")[0]
            return package, pathlib.Path("/usr/share/doc", package, "copyright")
    return None


def stripped(path):
    """Its bytes without symbols that only a debugger reads."""
    out = subprocess.run(["strip", "--strip-unneeded", "-o", "/dev/stdout", path], capture_output=True)
    return out.stdout if out.returncode == 0 and out.stdout else pathlib.Path(path).read_bytes()


def main(package, version, out):
    package = pathlib.Path(package)
    module = next(package.glob("_core.*.so"), None)
    if module is None:
        sys.exit(f"make_wheel.py: {package} has no module; ./footfall python builds it")
    abi = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    libc = platform.libc_ver()[1].replace(".", "_")
    tag = f"{abi}-{abi}-manylinux_{libc}_{platform.machine()}"
    info = f"footfall-{version}.dist-info"
    files = {}
    for path in sorted(package.iterdir()):
        if path.suffix in {".py", ".pyi", ".typed", ".txt"}:
            files[f"footfall/{path.name}"] = path.read_bytes()
    files[f"footfall/{module.name}"] = stripped(module)
    for name, path in sorted(libraries_of(module)):
        files[f"footfall.libs/{name}"] = pathlib.Path(path).read_bytes()
        licence = licence_of(path)
        if licence is not None and licence[1].is_file():
            files[f"{info}/licenses/{licence[0]}.txt"] = licence[1].read_bytes()
    root = pathlib.Path(__file__).resolve().parents[2]
    files[f"{info}/licenses/LICENSE"] = (root / "LICENSE").read_bytes()
    files[f"{info}/METADATA"] = f"""Metadata-Version: 2.1
Name: footfall
Version: {version}
Summary: flexible multibody mechanisms against beds of grains
License: GPL-3.0-or-later
Requires-Python: =={sys.version_info[0]}.{sys.version_info[1]}.*
Requires-Dist: numpy

Scenes, their checks, and mechanisms that Python leads step by step. Runs, sweeps and grains need the programs of footfall in PATH.
""".encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: footfall\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()

    def row(name, content):
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        return f"{name},sha256={digest},{len(content)}\n"

    record = "".join(row(name, content) for name, content in files.items())
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    wheel = pathlib.Path(out, f"footfall-{version}-{tag}.whl")
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name)  # without times: equal contents are equal bytes
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content, zipfile.ZIP_DEFLATED)
    print(f"{wheel}: {wheel.stat().st_size / 1e6:.1f} MB, {sum(name.startswith('footfall.libs/') for name in files)} libraries inside")


if len(sys.argv) != 4:
    sys.exit(__doc__)
main(*sys.argv[1:])
