#!/usr/bin/env bash
# make_engine.sh: compiles engine.c for this machine and writes inputs/reference/engine.fmu (needs a C compiler and python3).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/binaries/$(uname -m)-linux" "$folder/sources"
cp "$here/engine.c" "$folder/sources"
${CC:-cc} -Os -s -shared -fPIC -o "$folder/binaries/$(uname -m)-linux/engine.so" "$here/engine.c" -lm
cat > "$folder/modelDescription.xml" <<'XML'
<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="3.0" modelName="engine" instantiationToken="{footfall-engine}" description="Thrust follows a throttle">
  <UnitDefinitions>
    <Unit name="N"><BaseUnit kg="1" m="1" s="-2"/></Unit>
    <Unit name="s"><BaseUnit s="1"/></Unit>
  </UnitDefinitions>
  <CoSimulation modelIdentifier="engine" canGetAndSetFMUState="true" canSerializeFMUState="true" canHandleVariableCommunicationStepSize="true"/>
  <ModelVariables>
    <Float64 name="time" valueReference="0" causality="independent" variability="continuous"/>
    <Float64 name="throttle" valueReference="1" causality="input" variability="continuous" start="0" min="0" max="1"/>
    <Float64 name="thrust" valueReference="2" causality="output" variability="continuous" initial="calculated" unit="N"/>
    <Float64 name="largest" valueReference="3" causality="parameter" variability="tunable" start="3000" unit="N"/>
    <Float64 name="response" valueReference="4" causality="parameter" variability="fixed" start="0.05" unit="s"/>
  </ModelVariables>
  <ModelStructure>
    <Output valueReference="2"/>
    <InitialUnknown valueReference="2"/>
  </ModelStructure>
</fmiModelDescription>
XML
# Times of files are left out, so that equal contents are equal bytes.
python3 - "$folder" "$here/../../inputs/reference/engine.fmu" <<'PY'
import pathlib, sys, zipfile
folder = pathlib.Path(sys.argv[1])
with zipfile.ZipFile(sys.argv[2], "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            archive.writestr(zipfile.ZipInfo(str(path.relative_to(folder))), path.read_bytes(), zipfile.ZIP_DEFLATED)
PY
