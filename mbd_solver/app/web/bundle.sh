#!/usr/bin/env bash
# Builds dist/view.js and dist/report.js from src/, three.js and uPlot, with node, npm and, for the first time, network. Both
# files are stored with their sources, so building footfall requires none of these. --check: are they up to date?
set -euo pipefail
cd "$(dirname "$0")"
out=dist
[[ ${1-} == --check ]] && { out=$(mktemp -d); trap 'rm -rf "$out"' EXIT; }
[[ -x node_modules/.bin/esbuild ]] || npm ci --no-audit --no-fund --ignore-scripts >/dev/null
# The notice that both licences require in every copy; the permission has the same text in both.
years() { sed -n 's/^Copyright [^0-9]*\([0-9].*\)/Copyright (c) \1/p' "node_modules/$1/LICENSE" | head -n 1; }
notice="/* Holds three.js, $(years three), and uPlot, $(years uplot). MIT licence, of both:
$(sed -n '/^Permission/,$p' node_modules/uplot/LICENSE) */"
for name in view report; do
  node_modules/.bin/esbuild src/$name.js --bundle --minify --format=iife --target=es2022 --charset=ascii --loader:.css=text --legal-comments=none \
    --banner:js="$notice" --outfile="$out/$name.js" --log-level=warning
  # In a page nothing may end a script or a CDATA section.
  if grep -qE '</script|<!--|\]\]>' "$out/$name.js"; then echo "$out/$name.js contains a mark that ends a script"; exit 1; fi
done
if [[ $out != dist ]]; then diff -q "$out/view.js" dist/view.js && diff -q "$out/report.js" dist/report.js; fi
