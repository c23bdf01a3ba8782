#!/usr/bin/env bash
# Pictures of a run: RUN/deflection.png and RUN/drag.png over time (plots.gp), and RUN/rake.png: grains, coloured by speed, and bent tines at one moment,
# seen from ahead and above. Needs awk and gnuplot, no screen.
#   pictures.sh RUN [FRAME]     FRAME: number of a file RUN/bodies_NNNN.vtu; 10 unless given. Frames are 0.1 s apart.
set -euo pipefail
run=${1:?usage: pictures.sh RUN [FRAME]}
frame=${2:-10}
bodies=$(printf '%s/bodies_%04d.vtu' "$run" "$frame")
grains=$run/grains_$((frame * 2000)).txt     # 0.1 s of steps of 5e-5 s
for file in "$bodies" "$grains"; do [[ -f $file ]] || { echo "pictures.sh: no $file" >&2; exit 2; }; done
here=$(cd "$(dirname "$0")" && pwd)
gnuplot -e "run='$run'" "$here/plots.gp"

# Everything becomes a list of discs: nearness to the eye, place on the picture, radius, colour value (speed of a grain [m/s]; -1: a tine), drawn from
# far to near. Parallel projection; the eye looks from azimuth -40 and elevation 38 degrees.
project() {
  awk -v kind="$1" '
    BEGIN { a = -40 * 3.14159265 / 180; e = 38 * 3.14159265 / 180 }
    function disc(x, y, z, r, value) {
      printf "%.5f %.5f %.5f %.5f %.5f\n", (x * cos(a) + y * sin(a)) * cos(e) + z * sin(e), -x * sin(a) + y * cos(a),
        z * cos(e) - (x * cos(a) + y * sin(a)) * sin(e), r, value
    }
    kind == "grains" && /ITEM: ATOMS/ { go = 1; next }
    kind == "grains" && go { disc($2, $3, $4, $8, sqrt($5 * $5 + $6 * $6 + $7 * $7)) }
    kind == "tines" && /Name="Points"/ { gsub(/.*ascii">|<.*/, ""); n = split($0, p, " ") }
    kind == "tines" && /Name="connectivity"/ { gsub(/.*ascii">|<.*/, ""); m = split($0, link, " ") }
    kind == "tines" && /Name="offsets"/ {
      gsub(/.*ascii">|<.*/, ""); k = split($0, last, " ")
      for (i = 1; i <= k; i++) if (last[i] - (i > 1 ? last[i - 1] : 0) == 2) {
        from = link[last[i] - 1]; to = link[last[i]]
        for (t = 0; t < 1; t += 0.1) {
          for (c = 0; c < 3; c++) q[c] = (1 - t) * p[3 * from + 1 + c] + t * p[3 * to + 1 + c]
          disc(q[0], q[1], q[2], 0.006, -1)
        }
      }
    }' "$2"
}
{ project grains "$grains"; project tines "$bodies"; } | sort -g > "$run/rake.discs"
gnuplot <<END
set terminal pngcairo size 1000,700 font "DejaVu Sans,11"
set output "$run/rake.png"
set title sprintf("Grains and bent tines after %.1f s", $frame * 0.1)
unset border; unset tics; unset key
set size ratio -1
set palette defined (0 "#e9dfc7", 0.1 "#cfae70", 0.25 "#7fae8a", 0.5 "#1f6fa8", 0.6 "#123c6b")
set cbrange [0:0.6]
set colorbox user origin 0.90,0.25 size 0.02,0.5
set cbtics 0.2
set cblabel "speed of the grains [m/s]"
set rmargin 16
set style fill solid 1.0 border rgb "#5a4a35"
set style circle noclip
tine = 0xc0392b
plot "$run/rake.discs" using 2:3:4:(\$5 < 0 ? tine : palette(\$5)) with circles lc rgb variable lw 0.3, \
  "" using (NaN):(NaN):(0) with points lc palette           # for the colour bar
END
rm "$run/rake.discs"
printf '%s\n' "$run/rake.png" "$run/deflection.png" "$run/drag.png"
