#!/usr/bin/env bash
# The containers install what the script `footfall` installs for a run, by the same names.
set -u
cd "$(dirname "$0")/../.."
failed=0
wanted=$(sed -n '/^packages=(/,/)/p' footfall | tr -d '()' | sed 's/packages=//' | tr -s ' \n' '\n' | grep . | sort)
(($(wc -l <<<"$wanted") > 10)) || { echo "footfall: the list of packages was not found"; failed=1; }
for recipe in packaging/containers/Dockerfile packaging/containers/footfall.def; do
  for package in $wanted; do
    grep -qxF -- "$package" <(tr -s ' ' '\n' <"$recipe") || { echo "$recipe: does not install $package"; failed=1; }
  done
done
exit $failed
