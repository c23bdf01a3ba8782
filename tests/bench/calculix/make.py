#!/usr/bin/env python3
"""Makes tests/unit/fe/calculix.tar.xz: bar, plate, bracket and leg with the matrices, frequencies and deflections of CalculiX.

make.py FOLDER    works in FOLDER and leaves calculix.tar.xz there. Needs gmsh and ccx (Debian: gmsh calculix-ccx).
"""
import os
import re
import shutil
import subprocess
import sys

here = os.path.dirname(os.path.abspath(__file__))
os.makedirs(sys.argv[1], exist_ok=True)
os.chdir(sys.argv[1])


def node_set(name, ids):
    return "*NSET,NSET=%s\n" % name + "".join(",".join(map(str, ids[k:k + 12])) + (",\n" if k + 12 < len(ids) else "\n") for k in range(0, len(ids), 12))


def bricks(name, size, counts):
    """C3D8I, from the root at x = 0 to the tip."""
    nx, ny, nz = counts
    number = lambda i, j, k: 1 + i + (nx + 1) * (j + (ny + 1) * k)
    grid = [(i, j, k) for k in range(nz + 1) for j in range(ny + 1) for i in range(nx + 1)]
    text = "*NODE,NSET=ALL\n"
    for i, j, k in grid:
        text += "%d,%.9g,%.9g,%.9g\n" % (number(i, j, k), size[0] * i / nx, size[1] * j / ny, size[2] * k / nz)
    text += "*ELEMENT,TYPE=C3D8I,ELSET=SOLID\n"
    cells = [(i, j, k) for k in range(nz) for j in range(ny) for i in range(nx)]
    for e, (i, j, k) in enumerate(cells, 1):
        face = [number(i, j, k), number(i + 1, j, k), number(i + 1, j + 1, k), number(i, j + 1, k)]
        text += ",".join(map(str, [e] + face + [n + (nx + 1) * (ny + 1) for n in face])) + "\n"
    text += node_set("ROOT", [number(*g) for g in grid if g[0] == 0]) + node_set("TIP", [number(*g) for g in grid if g[0] == nx])
    open(name + ".inp", "w").write(text)


def quadratic_bricks(name, size, counts):
    """C3D20, from the root at x = 0 to the tip."""
    nx, ny, nz = (2 * n for n in counts)
    grid = [(i, j, k) for k in range(nz + 1) for j in range(ny + 1) for i in range(nx + 1) if i % 2 + j % 2 + k % 2 <= 1]
    number = {g: n for n, g in enumerate(grid, 1)}
    text = "*NODE,NSET=ALL\n"
    for (i, j, k), n in number.items():
        text += "%d,%.9g,%.9g,%.9g\n" % (n, size[0] * i / nx, size[1] * j / ny, size[2] * k / nz)
    text += "*ELEMENT,TYPE=C3D20,ELSET=SOLID\n"
    ring = [(0, 0), (2, 0), (2, 2), (0, 2)]
    middle = [(1, 0), (2, 1), (1, 2), (0, 1)]
    places = [(*p, 0) for p in ring] + [(*p, 2) for p in ring] + [(*p, 0) for p in middle] + [(*p, 2) for p in middle] + [(*p, 1) for p in ring]
    cells = [(i, j, k) for k in range(0, nz, 2) for j in range(0, ny, 2) for i in range(0, nx, 2)]
    for e, (i, j, k) in enumerate(cells, 1):
        ids = [number[i + a, j + b, k + c] for a, b, c in places]
        text += ",".join(map(str, [e] + ids[:10])) + ",\n " + ",".join(map(str, ids[10:])) + "\n"
    text += node_set("ROOT", [n for g, n in number.items() if g[0] == 0]) + node_set("TIP", [n for g, n in number.items() if g[0] == nx])
    open(name + ".inp", "w").write(text)


def strut(name, stations):
    """C3D20 between square sections (x, width)."""
    nodes, text, elements = {}, "*NODE,NSET=ALL\n", ""
    corner = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    place = lambda i, c: (stations[i][0], corner[c][0] * stations[i][1] / 2, corner[c][1] * stations[i][1] / 2)

    def number(*ends):
        nonlocal text
        if ends not in nodes:
            nodes[ends] = len(nodes) + 1
            x = [sum(v) / len(ends) for v in zip(*[place(*end) for end in ends])]
            text += "%d,%.9g,%.9g,%.9g\n" % (nodes[ends], *x)
        return nodes[ends]

    for e in range(len(stations) - 1):
        a, b = [(e, c) for c in range(4)], [(e + 1, c) for c in range(4)]
        ids = [number(n) for n in a + b]
        for ring in (a, b):
            ids += [number(ring[k], ring[(k + 1) % 4]) for k in range(4)]
        ids += [number(a[k], b[k]) for k in range(4)]
        elements += ",".join(map(str, [e + 1] + ids[:10])) + ",\n " + ",".join(map(str, ids[10:])) + "\n"
    at = lambda i: [n for ends, n in nodes.items() if all(end[0] == i for end in ends)]
    text += "*ELEMENT,TYPE=C3D20,ELSET=SOLID\n" + elements + node_set("ROOT", at(0)) + node_set("TIP", at(len(stations) - 1))
    open(name + ".inp", "w").write(text)


def angle(name):
    """C3D4 of gmsh, in mm."""
    for ending, options in ((".inp", ["-format", "inp"]), ("2.msh", ["-format", "msh22"]), ("4.msh", ["-format", "msh41", "-bin"]), ("40.msh", ["-format", "msh40"])):
        subprocess.run(["gmsh", "-3", here + "/bracket.geo", *options, "-o", name + ending], check=True, stdout=subprocess.DEVNULL)
    text = open(name + ".inp").read()
    text = re.sub(r"\*ELEMENT, type=CPS\d, ELSET=\w+\n(?:[^*\n]*\n)+", "", text)  # the faces
    text = re.sub(r"(?m)^\*\*\*.*\n", "", text)
    text = re.sub(r"\*Heading\n.*\n", "", text)
    text = re.sub(r"\*ELSET,ELSET=(HOLE|TOP|SOLID)\n(?:[^*\n]*\n)+", "", text)
    open(name + ".inp", "w").write(re.sub(r"ELSET=Volume\d+", "ELSET=SOLID", text))


def ccx(name, deck):
    open(name + ".inp", "w").write(deck)
    subprocess.run(["ccx", name], check=True, stdout=subprocess.DEVNULL)


def frequencies(file):
    rows = [line.split() for line in open(file)]
    return [row[3] for row in rows if len(row) == 5 and row[0].isdigit()]


def masses(name, density):
    """Masses of all nodes: diagonal terms, scaled to the mass (Hinton, Rock and Zienkiewicz 1976)."""
    rows = [line.strip().split(".") for line in open(name + "_m.dof")]
    listed = set(int(n) for n in re.findall(r"(?m)^\s*(\d+),[^,\n]*,[^,\n]*,[^,\n]*$", open(name + ".inp").read().split("*ELEMENT")[0]))
    total, diagonal = 0.0, {}
    for line in open(name + "_m.mas"):
        i, j, value = line.split()
        (n, a), (m, b) = rows[int(i) - 1], rows[int(j) - 1]
        if a != "1" or b != "1" or int(n) not in listed or int(m) not in listed:
            continue
        total += float(value) * (1 if i == j else 2)
        if i == j:
            diagonal[int(n)] = float(value)
    scale = total / sum(diagonal.values())
    return {n: m * scale for n, m in sorted(diagonal.items())}


def elements_of(masses):
    return "".join("*ELEMENT,TYPE=MASS,ELSET=M%d\n%d,%d\n*MASS,ELSET=M%d\n%.15g\n" % (n, 100000 + n, n, n, m) for n, m in masses.items())


def inertia_of(masses, name):
    """Mass, centre, and second moments xx yy zz xy xz yz about the centre, of masses at the nodes."""
    nodes = {int(row[0]): [float(x) for x in row[1:]] for row in re.findall(r"(?m)^\s*(\d+),([^,\n]*),([^,\n]*),([^,\n]*)$", open(name + ".inp").read().split("*ELEMENT")[0])}
    total = sum(masses.values())
    c = [sum(m * nodes[n][i] for n, m in masses.items()) / total for i in range(3)]
    moment = lambda i, j: sum(m * (nodes[n][i] - c[i]) * (nodes[n][j] - c[j]) for n, m in masses.items())
    return [total] + c + [moment(*ij) for ij in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]


bricks("bar", (1.0, 0.02, 0.02), (8, 1, 1))
bricks("plate", (0.4, 0.3, 0.01), (5, 4, 1))
quadratic_bricks("bar20", (1.0, 0.02, 0.02), (8, 1, 1))
quadratic_bricks("plate20", (0.4, 0.3, 0.01), (5, 4, 1))
strut("leg", [(0, 0.06), (0.35, 0.05), (0.7, 0.04), (1.0, 0.03), (1.05, 0.15)])
angle("bracket")
steel = (210e9, 0.3, 7850, "ROOT", "TIP")
parts = {"bar": steel, "plate": steel, "bar20": steel, "plate20": steel,
         "bracket": (70e3, 0.33, 2.7e-9, "TOP", "HOLE"), "leg": (70e9, 0.33, 2700, "ROOT", "TIP")}
os.makedirs("pack", exist_ok=True)
for name, (young, poisson, density, root, tip) in parts.items():
    mesh = "*INCLUDE,INPUT=%s.inp\n" % name
    material = lambda rho: "*MATERIAL,NAME=M\n*ELASTIC\n%g,%g\n*DENSITY\n%g\n*SOLID SECTION,ELSET=SOLID,MATERIAL=M\n" % (young, poisson, rho)
    step = lambda what: "*STEP\n" + what + "*END STEP\n"
    hold = "*BOUNDARY\n%s,1,3\n" % root
    ccx(name + "_m", mesh + material(density) + step("*FREQUENCY,SOLVER=MATRIXSTORAGE\n10\n"))
    ccx(name + "_free", mesh + material(density) + step("*FREQUENCY\n16\n*NODE FILE\nU\n*EL FILE\nS\n"))
    ccx(name + "_held", mesh + material(density) + hold + step("*FREQUENCY\n10\n"))
    ccx(name + "_static", mesh + material(density) + hold + step("*STATIC\n*CLOAD\n%s,3,-10.\n*NODE PRINT,NSET=%s\nU\n*EL PRINT,ELSET=SOLID,TOTALS=ONLY\nEMAS\n" % (tip, tip)))
    of_nodes = masses(name, density)
    lumped = mesh + material(1e-7 * density) + elements_of(of_nodes)  # CalculiX wants some density
    ccx(name + "_l", lumped + step("*FREQUENCY,SOLVER=MATRIXSTORAGE\n10\n"))
    ccx(name + "_lfree", lumped + step("*FREQUENCY\n16\n"))
    ccx(name + "_lheld", lumped + hold + step("*FREQUENCY\n10\n"))
    shutil.copy(name + ".inp", "pack")
    for ending in ("sti", "mas", "dof"):
        shutil.copy("%s_m.%s" % (name, ending), "pack/%s.%s" % (name, ending))
    shutil.copy(name + "_l.mas", "pack/%s_lumped.mas" % name)
    with open("pack/%s.results" % name, "w") as results:
        for kind, file, first in (("free", "free", 6), ("held", "held", 0), ("lumped_free", "lfree", 6), ("lumped_held", "lheld", 0)):
            print(kind, *frequencies("%s_%s.dat" % (name, file))[first:first + 10], file=results)
        static = open(name + "_static.dat").read()
        totals = [re.search(title + r"[^\n]*\n\n([^\n]*)", static).group(1).split()
                  for title in ("total mass for", "center of gravity", "inertia about the center ?of ?gravity")]
        print("inertia", *sum(totals, []), file=results)  # mass, its centre, its second moments xx yy zz xy xz yz about that
        print("lumped_inertia", *("%.9e" % x for x in inertia_of(of_nodes, name)), file=results)
        for row in (line.split() for line in static.splitlines()):
            if len(row) == 4 and row[0].isdigit():
                print("static", *row, file=results)
kept = [1 + 9 * corner + layer for layer in (0, 4, 8) for corner in range(4)]
ccx("sub", "*INCLUDE,INPUT=bar.inp\n*MATERIAL,NAME=M\n*ELASTIC\n210e9,0.3\n*SOLID SECTION,ELSET=SOLID,MATERIAL=M\n*STEP\n*SUBSTRUCTURE GENERATE\n"
    "*RETAINED NODAL DOFS\n" + "".join("%d,1,3\n" % n for n in kept) + "*SUBSTRUCTURE MATRIX OUTPUT,STIFFNESS=YES,FILE NAME=bar\n*END STEP\n")
for file, name in (("bar.mtx", "bar.mtx"), ("bar_free.frd", "bar.frd"), ("bracket2.msh", "bracket2.msh"), ("bracket4.msh", "bracket4.msh"), ("bracket40.msh", "bracket40.msh")):
    shutil.copy(file, "pack/" + name)
subprocess.run("tar --sort=name --mtime=2026-01-01 --owner=0 --group=0 --numeric-owner -C pack -cf - . | xz -9e >calculix.tar.xz", shell=True, check=True)
print("calculix.tar.xz:", os.path.getsize("calculix.tar.xz"), "bytes")
