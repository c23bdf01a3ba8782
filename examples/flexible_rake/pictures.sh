#!/usr/bin/env bash
# Pictures of a run: RUN/deflection.png and RUN/drag.png over time (plots.gp), and RUN/rake.png: grains, coloured by speed, and bent tines at one moment,
# seen from ahead and above (footfall view --pictures).
#   pictures.sh RUN [TIME]     TIME [s]: of the picture; 1.0 unless given. Frames are 0.1 s apart. FOOTFALL: the program, if not the program of the checkout or
#                              the installed one.
set -euo pipefail
run=${1:?usage: pictures.sh RUN [TIME]}
here=$(cd "$(dirname "$0")" && pwd)
footfall=${FOOTFALL:-$here/../../footfall}
[[ -x $footfall ]] || footfall=footfall
picture=$("$footfall" view "$run" --pictures --times "${2:-1.0}" --camera=-40,38 --fastest 0.6 --width 850)
cp "$picture" "$run/rake.png"
gnuplot -e "run='$run'" "$here/plots.gp"
printf '%s\n' "$run/rake.png" "$run/deflection.png" "$run/drag.png"
