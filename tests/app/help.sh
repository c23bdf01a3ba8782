#!/usr/bin/env bash
# help.sh FOOTFALL OUT CHECKOUT: --help and --version of every command, in a checkout that is not built, neither build nor install; nor does a misspelt command.
set -eu
out=$2 checkout=$3
rm -rf "$out"
mkdir -p "$out"
for command in run check new import view report plot compare sweep accuracy calibrate rig schema python test install package unknown ""; do
  for option in --help -h --version; do
    FOOTFALL_BUILD=$out/build timeout 20 "$checkout/footfall" $command $option >"$out/text" 2>&1 || { echo "$command $option failed"; cat "$out/text"; exit 1; }
    [[ -s $out/text && ! -e $out/build ]] || { echo "$command $option builds, or says nothing"; exit 1; }
  done
done
code=0
FOOTFALL_BUILD=$out/build timeout 20 "$checkout/footfall" rnu >"$out/text" 2>&1 || code=$?
[[ $code == 2 && ! -e $out/build ]] && grep -q 'unknown command "rnu". Commands: run check' "$out/text" || { echo "a misspelt command ends with $code:"; cat "$out/text"; exit 1; }
