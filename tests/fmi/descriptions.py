#!/usr/bin/env python3
"""descriptions.py MODEL VERSION: the modelDescription.xml of one of the FMUs of models.cpp."""
import sys

# name, type, value reference, causality, variability, start, dimension
OSCILLATOR = [("F", "Float64", 1, "input", "continuous", "0", 0), ("x", "Float64", 2, "output", "continuous", None, 0),
              ("v", "Float64", 3, "output", "continuous", None, 0)] + [
    (name, "Float64", 4 + k, "parameter", "fixed", start, 0)
    for k, (name, start) in enumerate([("m", "1"), ("k", "1e4"), ("d", "1"), ("x0", "0.01"), ("v0", "0")])]
CONTROLLER = [("e", "Float64", 1, "input", "continuous", "0", 0), ("u", "Float64", 2, "output", "continuous", None, 0),
              ("kp", "Float64", 4, "parameter", "fixed", "1", 0), ("ki", "Float64", 5, "parameter", "tunable", "0", 0)]
KINDS = ["Float64", "Float32", "Int8", "UInt16", "Int32", "Boolean"]
TYPES = [(kind + "_in", kind, 1 + k, "input", "discrete", "false" if kind == "Boolean" else "0", 0) for k, kind in enumerate(KINDS)]
TYPES += [(kind + "_out", kind, 11 + k, "output", "discrete", None, 0) for k, kind in enumerate(KINDS)]
TYPES += [("array_in", "Float64", 7, "input", "discrete", "7 8 9", 3), ("array_out", "Float64", 17, "output", "discrete", None, 3),
          ("resource", "Float64", 20, "output", "discrete", None, 0), ("length", "Float64", 21, "output", "discrete", None, 0),
          ("text", "String", 30, "parameter", "fixed", "none", 0)]
BROKEN = [("fault", "Float64", 1, "parameter", "fixed", "0", 0), ("when", "Float64", 2, "parameter", "fixed", "0.01", 0),
          ("y", "Float64", 3, "output", "continuous", None, 0)]
MODELS = {"oscillator": OSCILLATOR, "controller": CONTROLLER, "types": TYPES, "broken": BROKEN}
TWO = {"Float64": "Real", "Int32": "Integer", "Boolean": "Boolean", "String": "String"}

model, version = sys.argv[1], sys.argv[2]
keeps = "false" if model == "broken" else "true"
print('<?xml version="1.0" encoding="UTF-8"?>')
if version == "3":
    print(f'<fmiModelDescription fmiVersion="3.0" modelName="{model}" instantiationToken="{{{model}}}">')
    print(f'  <CoSimulation modelIdentifier="{model}" canGetAndSetFMUState="{keeps}" canSerializeFMUState="{keeps}"'
          ' canHandleVariableCommunicationStepSize="true"/>')
    print('  <ModelVariables>\n    <Float64 name="time" valueReference="0" causality="independent" variability="continuous"/>')
    for name, kind, reference, causality, variability, start, size in MODELS[model]:
        if kind in ("Float64", "Float32") or variability != "continuous":
            text = f'    <{kind} name="{name}" valueReference="{reference}" causality="{causality}" variability="{variability}"'
            inner = f'<Dimension start="{size}"/>' if size else ""
            if kind == "String":
                inner = f'<Start value="{start}"/>'
            elif start is not None:
                text += f' start="{start}"'
            print(text + (f">{inner}</{kind}>" if inner else "/>"))
else:
    print(f'<fmiModelDescription fmiVersion="2.0" modelName="{model}" guid="{{{model}}}">')
    print(f'  <CoSimulation modelIdentifier="{model}" canGetAndSetFMUstate="{keeps}" canSerializeFMUstate="{keeps}"/>')
    print('  <ModelVariables>')
    for name, kind, reference, causality, variability, start, size in MODELS[model]:
        if kind in TWO and not size:
            value = f' start="{start}"' if start is not None else ""
            print(f'    <ScalarVariable name="{name}" valueReference="{reference}" causality="{causality}" variability="{variability}">'
                  f'<{TWO[kind]}{value}/></ScalarVariable>')
print('  </ModelVariables>\n  <ModelStructure/>\n</fmiModelDescription>')
