#!/usr/bin/env python3
"""Recomputes why the legs of a lander are as they are: docs/explanation/legs.md.

    legs.py [--write]    checks every rule for inputs/landing_mr and inputs/validation_drop, and that the tables of the page hold these numbers;
                         --write: writes them into the page

Lengths in m, forces in N. One leg lies in the plane y = 0: x outwards, z up. Exit code 1 where a rule is broken or the page is old.
"""
import math
import pathlib
import re
import sys
import tomllib

kRoot = pathlib.Path(__file__).resolve().parents[2]
kPage = kRoot / "docs/explanation/legs.md"

# Numbers of the rules; the page names the source of each.
kSlope = math.radians(12)    # at rest and at touchdown
kSideways = 1.22             # m/s at touchdown, 4 ft/s
kBearing = 1.0e6             # Pa per m of depth under lunar gravity: 2 N/cm2 at 2 cm
kMoon = 1.63                 # m/s2, where that was measured
kSinkage = 0.10              # m, of a pad under the largest force
kFirmness, kStatic = 0.02, 3  # m of depth whose bearing strength counts at rest, and the factor on it
kRock = 0.30                 # m, under the cabin after the whole stroke
kYield = 1517e6              # Pa, landing gear steel
kSafety = 1.4                # on stress
kBuckling = 3.5              # on Euler's load
kCore = 10e6                 # Pa, the strongest honeycomb core
kUsed = 0.8                  # of a stroke in the design landing
kAcceleration = 5 * 9.81     # m/s2, the limit of [Lin25]
kStages = 9500 / 4500        # second over first stage of a primary honeycomb
kFirst = 10 / 32             # of its length
kHub = 0.05                  # m, radius of the ankle's seat on the pad
kSoil = 0.8                  # horizontal over vertical force of a ploughing pad
kStop = 5e-3                 # m that an end stop gives under the largest force
kThin = 30                   # diameter over wall

# Formula and source of every row of the tables; the page explains the letters and lists the sources.
kReasons = {
    "pads' radius from the axis": ("v^2 = 2 g r (1 - cos(a - s)) (k^2 + r^2) / h^2, r^2 = h^2 + b^2, tan a = b / h", "[4] mechanics"),
    "height of the cabin": ("floor - stroke / cos - sinkage", "[7] own choice"),
    "ankle": ("h = R / (4 x 0.8)", "mechanics"),
    "gas piston": ("pi/4 d^2 P0 = N cos", "[1] statics"),
    "stroke": ("m z'' = m g - 4 (F_gas + c z' cos) / cos", "[1] mechanics"),
    "acceleration at touchdown": ("4 (F_gas + c v cos) / (m cos) - g", "[1]"),
    "gas volume": ("V0 - A L", "[1]"),
    "end stop": ("k = P / 5 mm", "own choice"),
    "primary crush forces": ("F1 L1 + F2 (0.8 L - L1) = (m v^2 / 2 + m g 0.8 L / cos) / 4", "energy; [4] two stages"),
    "second stage over first": ("9500 / 4500 lbf", "[4]"),
    "first stage of the length": ("10 / 32 in", "[4]"),
    "bore of the primary": ("D^2 = 4 F / (pi p)", "[6]"),
    "auxiliary struts, first stage": ("F = P x / (cos e)", "statics"),
    "auxiliary struts, second stage": ("F = P x / (cos e)", "statics"),
    "length of the first stage": ("dz sin / L x e / 2", "kinematics"),
    "length of both stages": ("overlap - D / 2", "own choice"),
    "energy of two auxiliary struts": ("m v^2 / 2", "[4] energy"),
    "bore of the auxiliary struts": ("D^2 = 4 F / (pi p)", "[6]"),
    "inner tube of the auxiliary struts": ("", "fit"),
    "buckling of the auxiliary struts": ("pi^2 E I / L^2 / F", "[9] Euler"),
    "buckling of the primary": ("pi^2 E I / L^2 / P", "[9] Euler"),
    "rod": ("Z = 1.4 N sin l / yield", "[5] [8] beam"),
    "outer tube": ("Z = 1.4 M / yield", "[5] [8] beam"),
    "bore of the outer tube": ("", "fit"),
    "guide of the rod": ("2.75 D", "[10]"),
    "room for the stroke": ("", "fit"),
    "walls": ("D / t", "own choice"),
    "pad radius": ("pi R^2 = max(N / (k 0.10), 3 N_rest / (k 0.02))", "[2] [3]"),
    "pad thickness": ("t^2 = 6 x 1.4 M / yield; w = p R^4 (7 + 3 nu) / (64 D (1 + nu)) = t / 2", "[5] [8] [11] plate"),
    "centring spring": ("k s = 0.3 N R / 4", "own choice"),
    "its damper": ("d / (2 sqrt(k J))", "own choice"),
    "mass of the legs": ("", "own choice"),
}


def merged(base, changes):
    """A scene and the scene it is based on, as the program reads them: lists by name, `without` takes keys away."""
    result = dict(base)
    for key in changes.get("without", []):
        result.pop(key, None)
    for key, value in changes.items():
        old = result.get(key)
        if isinstance(value, dict) and isinstance(old, dict):
            result[key] = merged(old, value)
        elif isinstance(value, list) and isinstance(old, list) and value and all(isinstance(v, dict) and "name" in v for v in value):
            known = {v["name"]: v for v in old}
            for entry in value:
                known[entry["name"]] = merged(known.get(entry["name"], {}), entry)
            result[key] = list(known.values())
        elif key != "without":
            result[key] = value
    return result


def read(path):
    path = path / "scene.toml" if path.is_dir() else path
    scene = tomllib.loads(path.read_text())
    return merged(read(path.parent / scene.pop("base")), scene) if "base" in scene else scene


class Tube:
    def __init__(self, shape):
        self.outer, self.wall = shape["diameter"], shape["wall"]
        self.bore = self.outer - 2 * self.wall
        self.length = math.dist(shape["from"], shape["to"])
        self.area = math.pi / 4 * (self.outer**2 - self.bore**2)
        self.inertia = math.pi / 64 * (self.outer**4 - self.bore**4)
        self.modulus = 2 * self.inertia / self.outer
        self.middle = [(a + b) / 2 for a, b in zip(shape["from"], shape["to"])]
        self.start = shape["from"]


class Lander:
    def __init__(self, folder):
        scene = read(kRoot / folder)
        bodies = {b["name"]: b for b in scene["bodies"]}
        struts = {s["name"]: s for s in scene["struts"]}
        material = scene["materials"]["strut_metal"]
        self.young, self.poisson, self.density = material["young"], material["poisson"], material["density"]
        self.gravity, self.mass, self.speed = -scene["gravity"][2], scene["total_mass"], -scene["initial"]["velocity"][2]
        tube = {n: Tube(bodies["leg_{leg}_" + n]["shape"]) for n in ("outer", "rod", "left_outer", "left_inner", "right_outer", "right_inner")}
        self.outer, self.rod, self.aux_outer, self.aux_inner = (tube[n] for n in ("outer", "rod", "left_outer", "left_inner"))
        for side in ("left", "right"):
            assert struts["leg_{leg}_" + side]["honeycomb"] == struts["leg_{leg}_left"]["honeycomb"], "auxiliary struts differ"
        pad = bodies["footpad_{leg}"]["shape"]
        self.pad_radius, self.pad_thickness = pad["radius"], pad["thickness"]
        self.pad_mass = math.pi * pad["radius"]**2 * pad["thickness"] * self.density
        primary = struts["leg_{leg}_primary"]
        self.gas, self.mr, self.stops, self.honeycomb = (primary.get(k) for k in ("gas", "mr", "stops", "honeycomb"))
        self.aux = struts["leg_{leg}_left"]["honeycomb"]["stages"]
        self.hip, self.ankle = primary["points"]
        self.root, self.tip = struts["leg_{leg}_left"]["points"]
        spring = scene["springs"][0]
        self.centring, self.centring_damping = spring["stiffness"], spring["damping"]
        joint = next(j for j in scene["joints"] if j["name"] == "leg_{leg}_ankle")
        self.ankle_height = joint["point"][2] - pad["centre"][2]
        cabin = bodies["cabin"]["shape"]
        self.legs = scene["arrays"]["leg"]["count"]

        # masses and inertia of the whole about its mass centre, about a horizontal axis; four legs on a circle
        parts = [(t.area * t.length * self.density, t.middle) for t in tube.values()] + [(self.pad_mass, pad["centre"])]
        self.leg_mass = sum(m for m, _ in parts)
        body = self.mass - self.legs * self.leg_mass
        self.height = (body * cabin["centre"][2] + self.legs * sum(m * p[2] for m, p in parts)) / self.mass
        own = body / 12 * (cabin["size"][0]**2 + cabin["size"][2]**2)
        own += body * (cabin["centre"][2] - self.height)**2
        own += self.legs * sum(m * ((p[0]**2 + p[1]**2) / 2 + (p[2] - self.height)**2) for m, p in parts)
        self.gyration = math.sqrt(own / self.mass)
        self.bottom = cabin["centre"][2] - cabin["size"][2] / 2

        # the leg: axial force and moment about the hip for a vertical pad force of 1 and a horizontal one, positive outwards
        reach, drop = self.ankle[0] - self.hip[0], self.hip[2] - self.ankle[2]
        self.length = math.hypot(reach, drop)
        self.sine, self.cosine = reach / self.length, drop / self.length
        along = [b - a for a, b in zip(self.tip, self.root)]
        norm = math.hypot(*along)
        tip = (self.tip[0] - self.hip[0], self.tip[2] - self.hip[2])
        self.arm = 2 * abs(tip[1] * along[0] - tip[0] * along[2]) / norm   # m, of both auxiliary struts
        self.aux_length = norm
        self.reach = reach
        self.lever = math.hypot(self.ankle[0] - self.tip[0], self.ankle[2] - self.tip[2])   # of the rod beyond its lower bearing

    def vertical(self, axial):
        """Force of the pad, straight up, at which the primary strut carries `axial`."""
        return axial / self.cosine

    def auxiliary(self, axial):
        """Pull of each auxiliary strut at that force: moments about the hip."""
        return self.vertical(axial) * self.reach / self.arm

    def bending(self, axial, lever):
        return self.vertical(axial) * self.sine * lever


def stopped(lander):
    """Stroke of the primary strut of a level landing on hard smooth ground without current: viscous force and gas."""
    area = math.pi / 4 * lander.gas["piston_diameter"]**2
    z, v, dt = 0.0, lander.speed, 1e-5
    while v > 0:
        s = z * lander.cosine
        gas = area * lander.gas["pressure"] * (lander.gas["volume"] / (lander.gas["volume"] - area * s))**lander.gas["exponent"]
        force = gas + lander.mr["viscous"] * v * lander.cosine
        v += dt * (lander.gravity - lander.legs * lander.vertical(force) / lander.mass)
        z += dt * v
    return z * lander.cosine


class Rules:
    def __init__(self):
        self.rows, self.broken = [], []

    def row(self, what, rule, numbers, least, chosen, most=None, unit="", digits=4):
        """least <= chosen <= most: bounds that are None do not hold."""
        good = (least is None or chosen >= least * (1 - 1e-9)) and (most is None or chosen <= most * (1 + 1e-9))
        bound = [f"{sign} {value:.{digits}g}" for sign, value in (("at least", least), ("at most", most)) if value is not None]
        formula, source = kReasons[what]
        self.rows.append(f"| {what} | {rule} | {formula} | {numbers} | {source} | {', '.join(bound)} {unit} | {chosen:.{digits}g} {unit} |".replace("  ", " "))
        if not good:
            self.broken.append(self.rows[-1])


def rules_of(folder):
    l, r = Lander(folder), Rules()
    g = l.gravity
    track = l.reach + l.hip[0]
    edge = track * math.cos(math.pi / l.legs)
    radius = math.hypot(l.height, edge)
    rise = radius * (1 - math.cos(math.atan2(edge, l.height) - kSlope))
    tip_over = math.sqrt(2 * g * rise * (l.gyration**2 + radius**2)) / l.height
    weight = l.mass * g / l.legs
    steep = math.cos(kSlope) + l.legs / 2 * l.height * math.sin(kSlope) / track   # load of the lowest leg on the slope over that on the level
    stroke = l.stops["max"] if l.stops else sum(s["length"] for s in l.honeycomb["stages"])

    r.row("pads' radius from the axis", "the lander that trips over two pads on the slope does not tip over",
          f"{math.degrees(kSlope):.0f} degrees, {kSideways} m/s; mass centre {l.height:.3f} m high, radius of gyration {l.gyration:.3f} m; pads {track:.2f} m from the axis",
          kSideways, tip_over, unit="m/s") if g < 2 else None
    sunk = l.bottom - stroke / l.cosine - kSinkage
    r.row("height of the cabin", "a rock has room below it, strokes used up and pads sunk", f"floor at {l.bottom:.2f} m, stroke {stroke:.2f} m, sinkage {kSinkage:.2f} m", kRock, sunk, unit="m")
    r.row("ankle", "a ploughing pad does not dig its edge in: the resultant stays within a quarter of the radius", f"force {kSoil} of the load; pad of {l.pad_radius:.2f} m",
          None, l.ankle_height, l.pad_radius / 4 / kSoil, "m")

    if l.mr:
        area = math.pi / 4 * l.gas["piston_diameter"]**2
        static = steep * weight * l.cosine
        r.row("gas piston", "the gas at the printed pressure carries the lowest leg on the slope, extended", f"{weight:.0f} N a leg, x {steep:.3f} on the slope, x {l.cosine:.4f} along the strut",
              static, area * l.gas["pressure"], 1.1 * static, "N")
        used = stopped(l)
        r.row("stroke", "without current the design landing ends before the stop", f"viscous force and gas alone use {used:.4f} m, a fifth is left", used / kUsed * 0.99, stroke, unit="m")
        soft = l.mr["viscous"] * l.speed * l.cosine + area * l.gas["pressure"]
        largest = soft + l.mr["yield_force"]
        r.row("acceleration at touchdown", "viscous force and gas alone stay within the printed limit", f"{l.legs} legs of {soft:.0f} N along the strut", None,
              l.legs * l.vertical(soft) / l.mass - g, kAcceleration, "m/s2")
        compressed = l.gas["volume"] - area * stroke
        r.row("gas volume", "positive at the stop, with a third of the printed volume left", "", l.gas["volume"] / 3, compressed, unit="m3")
        r.row("end stop", "gives at most 5 mm under the largest force", f"{largest:.0f} N", largest / kStop, l.stops["stiffness"], unit="N/m")
        yields = (soft, largest)
        bending = l.bending(largest, l.lever)
    else:
        one, two = l.honeycomb["stages"]
        energy = (l.mass * l.speed**2 / 2 + l.mass * g * kUsed * stroke / l.cosine) / l.legs
        absorbed = one["force"] * one["length"] + two["force"] * (kUsed * stroke - one["length"])
        r.row("primary crush forces", "on hard ground the legs take all the energy in 0.8 of the stroke", f"{energy / 1e3:.2f} kJ a leg, stroke {stroke:.2f} m", energy, absorbed, 1.03 * energy, "J")
        r.row("second stage over first", "as of Apollo's primary struts", "", None, two["force"] / one["force"], 1.01 * kStages)
        r.row("first stage of the length", "as of Apollo's primary struts", "10 of 32 inches", None, one["length"] / stroke, 1.01 * kFirst)
        largest = two["force"]
        yields = (one["force"], largest)
        bending = max(l.bending(one["force"], l.lever), l.bending(largest, l.lever - one["length"]))
        r.row("bore of the primary", "carries the second stage with the strongest core", f"{largest:.0f} N over {kCore / 1e6:.0f} MPa", math.sqrt(4 * largest / kCore / math.pi), l.outer.bore, unit="m")
    first, second = l.aux
    states = ("without current at touchdown", "with full current at touchdown") if l.mr else ("in its first stage", "in its second stage")
    for name, stage, force, state in zip(("first", "second"), (first, second), yields, states):
        r.row(f"auxiliary struts, {name} stage", f"yields beyond the primary {state}, under a pad force straight up", f"{force:.0f} N along the primary", l.auxiliary(force), stage["force"],
              1.03 * l.auxiliary(force), "N")
    turned = stroke / l.cosine * l.sine / l.length * l.arm / 2
    r.row("length of the first stage", "the pad may rest where it touched while the primary uses its stroke", f"the auxiliary strut grows by {turned:.4f} m", turned, first["length"], unit="m")
    overlap = l.aux_outer.length + l.aux_inner.length - l.aux_length
    r.row("length of both stages", "drawn out, the tubes still overlap by half a diameter: they are not bent", f"overlap {overlap:.3f} m", None, first["length"] + second["length"], overlap - l.aux_inner.outer / 2, "m")
    sideways = l.mass * kSideways**2 / 2
    r.row("energy of two auxiliary struts", "one leg that is caught stops the sideways motion", f"{sideways:.0f} J", sideways, 2 * (first["force"] * first["length"] + second["force"] * second["length"]), unit="J")
    r.row("bore of the auxiliary struts", "carries the second stage with the strongest core", f"{second['force']:.0f} N over {kCore / 1e6:.0f} MPa", math.sqrt(4 * second["force"] / kCore / math.pi),
          l.aux_outer.bore, unit="m")
    r.row("inner tube of the auxiliary struts", "slides in the outer one", "", None, l.aux_inner.outer, l.aux_outer.bore, "m")
    r.row("buckling of the auxiliary struts", "Euler's load of the inner tube over the second stage", f"pinned, {l.aux_length:.3f} m", kBuckling,
          math.pi**2 * l.young * l.aux_inner.inertia / l.aux_length**2 / second["force"])
    r.row("buckling of the primary", "Euler's load of the rod over the largest force", f"pinned, {l.length:.3f} m", kBuckling, math.pi**2 * l.young * l.rod.inertia / l.length**2 / largest)
    r.row("rod", f"bent beyond its bearing when all struts yield: stress x {kSafety} below yield", f"{bending:.0f} N m", kSafety * bending / kYield * 1e6, l.rod.modulus * 1e6, unit="cm3")
    between = math.dist(l.rod.start, l.hip)
    bent = bending * between / math.dist(l.tip, l.hip)
    r.row("outer tube", "the same moment where the rod's upper bearing gives it over", f"{bent:.0f} N m", kSafety * bent / kYield * 1e6, l.outer.modulus * 1e6, unit="cm3")
    r.row("bore of the outer tube", "the rod and a bearing of 2.5 mm fit", "", l.rod.outer + 0.005, l.outer.bore, unit="m")
    guide = math.dist(l.rod.start, l.tip)
    r.row("guide of the rod", "bearings lie 2.75 diameters apart, extended", f"rod of {l.rod.outer:.3f} m", 2.75 * l.rod.outer, guide, unit="m")
    r.row("room for the stroke", "the rod's end stays in the outer tube", f"{between:.3f} m above it", stroke, between, unit="m")
    r.row("walls", "diameter over thickness: no local buckling, no dents", "", None, max(t.outer / t.wall for t in (l.outer, l.rod)), kThin)
    bearing = kBearing * g / kMoon
    load = l.vertical(largest)
    sinking, resting = load / bearing / kSinkage, steep * weight / (bearing * kFirmness / kStatic)
    least = math.sqrt(max(sinking, resting) / math.pi)
    r.row("pad radius", "sinks by 0.10 m under the largest force; at rest on the slope a third of the bearing strength at 2 cm",
          f"{load:.0f} N, {bearing / 1e6:.2f} MPa per metre: {sinking:.3f} m2; {steep * weight:.0f} N: {resting:.3f} m2", least, l.pad_radius, 1.05 * least, "m")
    area = math.pi * l.pad_radius**2
    moment = load / (4 * math.pi) * ((1 + l.poisson) * math.log(l.pad_radius / kHub) + 1 - (3 + l.poisson) / 4)
    thick = math.sqrt(6 * kSafety * moment / kYield)
    pressure, plate = load / area, l.young / 12 / (1 - l.poisson**2)
    bow = pressure * l.pad_radius**4 * (7 + 3 * l.poisson) / (64 * plate * (1 + l.poisson))
    thick = max(thick, (2 * bow)**0.25)
    r.row("pad thickness", "strength, and a rim that bends by half of it at most (thin plate)", f"{moment:.0f} N m/m, hub of {kHub} m", thick, l.pad_thickness, unit="m")
    polar = l.pad_mass * l.pad_radius**2 / 4
    critical = 2 * math.sqrt(l.centring * polar)
    r.row("centring spring", "at the slope's angle far weaker than the weight on a quarter of the radius", f"{weight:.0f} N a leg", None, l.centring * kSlope, 0.3 * weight * l.pad_radius / 4, "N m")
    r.row("its damper", "half of critical, to a tenth", f"critical {critical:.2f} N m s", 0.4, l.centring_damping / critical, 0.6)
    r.row("mass of the legs", "share of the lander's", f"{l.leg_mass:.1f} kg a leg", None, l.legs * l.leg_mass / l.mass, 0.15)
    return r


def main():
    page = kPage.read_text() if kPage.exists() else ""
    failed = False
    for folder in ("inputs/landing_mr", "inputs/validation_drop"):
        rules = rules_of(folder)
        table = "\n".join(["| what | rule | formula | numbers | source | bound | chosen |", "|---|---|---|---|---|---|---|"] + rules.rows)
        for broken in rules.broken:
            print(f"{folder}: a rule of docs/explanation/legs.md is broken: {broken}")
            failed = True
        mark = re.compile(rf"(<!-- legs: {folder} -->\n).*?(<!-- end -->)", re.S)
        if "--print" in sys.argv:
            print(table)
            continue
        if not mark.search(page):
            print(f"{kPage.relative_to(kRoot)}: no table of {folder}; expected <!-- legs: {folder} --> and <!-- end -->")
            failed = True
            continue
        new = mark.sub(lambda m: m.group(1) + table + "\n" + m.group(2), page)
        if new != page and "--write" not in sys.argv:
            print(f"{kPage.relative_to(kRoot)}: the table of {folder} does not hold the numbers of the scene; write it by tests/docs/legs.py --write")
            failed = True
        page = new
    if "--write" in sys.argv:
        kPage.write_text(page)
    sys.exit(1 if failed else 0)


main()
