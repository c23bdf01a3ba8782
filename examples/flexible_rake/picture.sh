#!/usr/bin/env bash
# Draws grains and bent tines of one moment of a run, seen from above and to the side, as RUN/rake.png. Needs awk and gnuplot.
#   picture.sh RUN [FRAME]     FRAME: number of a file RUN/bodies_NNNN.vtu; the last one unless given. Frames are 0.1 s apart.
set -euo pipefail
run=${1:?usage: picture.sh RUN [FRAME]}
frame=${2:-$(ls "$run"/bodies_*.vtu | tail -1 | sed 's/.*_0*\([0-9]\+\)\.vtu/\1/')}
bodies=$(printf '%s/bodies_%04d.vtu' "$run" "$frame")
step=$((frame * 2000))                       # 0.1 s of steps of 5e-5 s
grains=$run/grains_$step.txt
[[ -f $grains ]] || { echo "picture.sh: no $grains" >&2; exit 2; }

# Everything becomes a list of discs: distance to the eye, place on the picture, radius, colour value. Grains: their height. Tines: discs
# along their segments, value -1. Parallel projection from azimuth -60 and elevation 30 degrees.
project() {
  awk -v kind="$1" '
    function disc(x, y, z, r, value,   c, s, e, f) {
      c = cos(-1.047); s = sin(-1.047); e = sin(0.52); f = cos(0.52)
      printf "%.5f %.5f %.5f %.5f %.5f\n", -x * s * f + y * c * f + z * e * 0.999, x * c + y * s, z * f - (-x * s + y * c) * e, r, value
    }
    kind == "grains" && /ITEM: ATOMS/ { go = 1; next }
    kind == "grains" && go { disc($2, $3, $4, $8, $4) }
    kind == "tines" && /Name="Points"/ { gsub(/.*ascii">|<.*/, ""); n = split($0, p, " ") }
    kind == "tines" && /Name="connectivity"/ { gsub(/.*ascii">|<.*/, ""); m = split($0, link, " ") }
    kind == "tines" && /Name="offsets"/ {
      gsub(/.*ascii">|<.*/, ""); k = split($0, last, " ")
      for (i = 1; i <= k; i++) if (last[i] - (i > 1 ? last[i - 1] : 0) == 2) {
        a = link[last[i] - 1]; b = link[last[i]]
        for (t = 0; t < 1; t += 0.1) {
          for (c = 0; c < 3; c++) q[c] = (1 - t) * p[3 * a + 1 + c] + t * p[3 * b + 1 + c]
          disc(q[0], q[1], q[2], 0.006, -1)
        }
      }
    }' "$2"
}
{ project grains "$grains"; project tines "$bodies"; } | sort -rg > "$run/rake.discs"
gnuplot <<END
set terminal pngcairo size 1400,900 font "DejaVu Sans,12"
set output "$run/rake.png"
unset border; unset tics; unset key; unset colorbox
set size ratio -1
set margins 0,0,0,0
set palette defined (-1 "#c0392b", -0.001 "#c0392b", 0 "#5b4636", 0.09 "#a58a63", 0.13 "#d9c49a", 0.2 "#f6e9c9")
set cbrange [-1:0.2]
set style fill solid 1.0 border rgb "#4a3b2a"
plot "$run/rake.discs" using 2:3:4:5 with circles lc palette lw 0.4
END
rm "$run/rake.discs"
echo "$run/rake.png"
