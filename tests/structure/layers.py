#!/usr/bin/env python3
"""layers.py: which folder may include which, and which file may include a foreign library. The tables below are the architecture; every
include of coupler, liggghts_fix and mbd_solver is held against them. Headers are named by their full path."""
import fnmatch
import pathlib
import re
import sys

# A folder may include its own headers, the headers of the folders named here, and what these may include. Subfolders without an entry belong to
# the folder above, whose codes.h all of them share.
MAY_INCLUDE = {
    "coupler/base": "",
    "coupler": "coupler/base",
    "liggghts_fix/link": "coupler",  # no headers of LIGGGHTS
    "liggghts_fix/access": "liggghts_fix/link",
    "liggghts_fix/contact": "liggghts_fix/access",
    "liggghts_fix/replaced": "liggghts_fix/access",
    "liggghts_fix/couple": "liggghts_fix/contact liggghts_fix/replaced",
    "liggghts_fix": "liggghts_fix/couple",
    "mbd_solver/base": "coupler/base",
    "mbd_solver/model": "mbd_solver/base coupler",
    "mbd_solver/fe": "mbd_solver/model",
    "mbd_solver/dynamics": "mbd_solver/model",
    "mbd_solver/integrator": "mbd_solver/dynamics",
    "mbd_solver/scene": "mbd_solver/fe",
    "mbd_solver/assemble": "mbd_solver/scene",
    "mbd_solver/coupling": "mbd_solver/assemble mbd_solver/dynamics",
    "mbd_solver/session/output": "mbd_solver/base coupler",
    "mbd_solver/session/observe": "mbd_solver/coupling mbd_solver/session/output",
    "mbd_solver/session": "mbd_solver/session/observe mbd_solver/integrator",
    "mbd_solver/python": "mbd_solver/session",
    "mbd_solver/launch": "mbd_solver/scene",
    "mbd_solver/bed": "mbd_solver/launch mbd_solver/assemble mbd_solver/session/output",
    "mbd_solver/app": "mbd_solver/bed mbd_solver/session/observe",
    "mbd_solver/studies": "mbd_solver/app",
    "mbd_solver/campaign": "mbd_solver/studies",
    "mbd_solver/import": "mbd_solver/app",
    "mbd_solver/fmi": "mbd_solver/base",
    "mbd_solver/fmi/model": "mbd_solver/fmi mbd_solver/session",
    "mbd_solver/fmi/export": "mbd_solver/fmi/model mbd_solver/app",
    "mbd_solver/fmi/library": "mbd_solver/fmi/model",
    "mbd_solver/programs": "mbd_solver/session mbd_solver/studies mbd_solver/campaign mbd_solver/import mbd_solver/fmi/export",
}

# What matches (a regular expression at the start of an include) may be included by these files only.
MPI_FILES = """coupler/communicator.* coupler/polling_wait.* coupler/abort_guard.* coupler/transport_mpi.* mbd_solver/programs/mbd_solver.cpp
    liggghts_fix/launcher.cpp liggghts_fix/couple/* liggghts_fix/contact/*"""
ONLY_IN = {
    r"(ida|sundials|nvector|sunmatrix|sunlinsol|sunnonlinsol)/": "mbd_solver/integrator/ida.cpp",
    r"toml\+\+": "mbd_solver/scene/scene_reader.cpp",
    r"fl/": "mbd_solver/model/control/fuzzy.cpp",
    r"fcl/": "mbd_solver/model/elements/surface_model.cpp mbd_solver/model/elements/contact_surface.cpp",
    r"openturns/": "mbd_solver/campaign/sampling.cpp mbd_solver/campaign/optimum.cpp",
    r"muParser": "mbd_solver/model/control/signal_chain.cpp",
    r"pugixml": "mbd_solver/session/output/vtk_writer.cpp mbd_solver/import/xml_source.h mbd_solver/fmi/model_description.cpp",
    r"httplib\.h": "mbd_solver/app/live/page_server.cpp",
    r"zip\.h": "mbd_solver/fmi/fmu_file.cpp",
    r"mujoco/": "mbd_solver/import/mjcf_reader.cpp",
    r"(sdf|ignition)/": "mbd_solver/import/sdf/sdf_reader.cpp",
    r"pybind11/": "mbd_solver/python/module.cpp",
    r"zlib": "mbd_solver/base/packed_bytes.cpp",
    r"mpi\.h": MPI_FILES + " liggghts_fix/replaced/comm_world.h liggghts_fix/replaced/mpi_abort.cpp liggghts_fix/access/liggghts_access.cpp",
    r"coupler/(communicator|polling_wait|abort_guard|transport_mpi)\.h": MPI_FILES + " liggghts_fix/replaced/popen.cpp liggghts_fix/replaced/fopen.cpp",
    r"(lammps|fix|fix_[a-z_]*|mesh_module|atom|modify|neighbor|comm|domain|update|error|input|tri_mesh|signal_handling)\.h":
        "liggghts_fix/launcher.cpp liggghts_fix/access/* liggghts_fix/couple/* liggghts_fix/contact/* liggghts_fix/replaced/*",
    # A scene without grains makes nothing of the coupling: all of it is made by CoupledRun, and that by the run alone.
    r"mbd_solver/coupling/(dem_partner|coupling_watch|window_choice)\.h": "mbd_solver/coupling/*",
    r"mbd_solver/coupling/coupled_run\.h": "mbd_solver/coupling/* mbd_solver/session/loop/moving_mechanism.h",
    r"mbd_solver/coupling/coupling_sample\.h": "mbd_solver/coupling/* mbd_solver/session/observe/sampler.h",
    r"mbd_solver/session/(?!codes|session|error_report)[a-z_]*\.h": "mbd_solver/session/* mbd_solver/programs/mbd_solver.cpp",
}
# Plain C++: only these files of coupler/base may use headers of the operating system.
SYSTEM_FILES_OF_BASE = ("coupler/base/files.cpp coupler/base/confinement.cpp coupler/base/input_file.cpp coupler/base/number.cpp coupler/base/pulse.cpp"
                        " coupler/base/run_directory.cpp coupler/base/run_directory.h coupler/base/start.cpp coupler/base/interrupt.cpp")
SYSTEM_HEADER = re.compile(r"[a-z_]+[/.]")
COUPLED_RUN_IS_MADE_IN = "mbd_solver/session/loop/moving_mechanism.cpp"

root = pathlib.Path(__file__).resolve().parents[2]
failed = False


def complain(text):
    global failed
    failed = True
    print(text)


def folder_of(path):
    folder = path.rpartition("/")[0]
    while folder and folder not in MAY_INCLUDE:
        folder = folder.rpartition("/")[0]
    return folder


def reach(folder, found=None):
    found = set() if found is None else found
    if folder not in found:
        found.add(folder)
        for other in MAY_INCLUDE[folder].split():
            reach(other, found)
    return found


sources = {str(p.relative_to(root)): p.read_text()
           for top in ("coupler", "liggghts_fix", "mbd_solver", "tests")
           for p in (root / top).rglob("*") if p.suffix in (".cpp", ".h") and "node_modules" not in p.parts}
include = re.compile(r'^#include ([<"])([^>"]+)[>"]', re.M)
used, made_in = set(), []
for file, text in sorted(sources.items()):
    ours = not file.startswith("tests/")
    if ours and re.search(r"make_unique<CoupledRun>|\bCoupledRun [a-z]+[({]", text):
        made_in.append(file)
    for kind, header in include.findall(text):
        if kind == '"' and not re.match("(coupler|mbd_solver|liggghts_fix|tests)/", header):
            if not file.startswith("liggghts_fix/") or (root / "liggghts_fix" / header).exists():
                complain(f"{file} includes {header}: expected the header's full path")
        if not ours:
            continue
        for pattern, allowed in ONLY_IN.items():
            if re.match(pattern, header):
                used.add(pattern)
                if not any(fnmatch.fnmatch(file, name) for name in allowed.split()):
                    complain(f"{file} includes {header}; only {' '.join(allowed.split())} may")
        if kind == "<" and file.startswith("coupler/base/") and SYSTEM_HEADER.match(header) and file not in SYSTEM_FILES_OF_BASE.split():
            complain(f"{file} includes {header}: coupler/base is plain C++")
        if kind == '"' and "/" in header:
            start, end = folder_of(file), folder_of(header)
            if not start:
                complain(f"{file} is in no folder of the table in tests/structure/layers.py")
            elif end not in reach(start) and not (header == f"{end}/codes.h" and start.startswith(end + "/")):
                complain(f"{file} includes {header}: {start} may not include {end}")
for pattern in ONLY_IN.keys() - used:
    complain(f"nothing includes {pattern}: this check is blind")
if made_in != [COUPLED_RUN_IS_MADE_IN]:
    complain(f"CoupledRun is made in {made_in}, expected {COUPLED_RUN_IS_MADE_IN}")
sys.exit(failed)
