#!/usr/bin/env bash
# quoting.sh FOOTFALL OUT: whatever a scene or an experiment of somebody else holds in its texts, nothing of it runs, and nothing is written outside.
set -u
footfall=$1 out=$2 here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$out" && mkdir -p "$out/work" && cd "$out/work" || exit 1
die() { echo "quoting.sh: $*"; cat "$out"/*.txt; exit 1; }
clean() { [[ -z $(find "$out" -name 'ran*') ]] || die "something of a scene's texts ran: $(find "$out" -name 'ran*')"; }
scenes=$here/../../inputs/accuracy/scenes

# A title, with plots and a page.
cat > scene.toml <<TOML
base = "$scenes/slider_crank.toml"
title = "\`touch ran_1\` \\" . system('touch ran_2') . \\" ' . system('touch ran_3') . ' \$(touch ran_4) <script>x</script>"
end_time = 0.02
[output]
plots = true
TOML
"$footfall" run scene.toml --out run --quiet >"$out/run.txt" 2>&1 || die "the run failed"
[[ -s run/plots/overview.png ]] || die "there are no plots"
"$footfall" report run >"$out/report.txt" 2>&1 || die "the report failed"
! grep -q '<script>x' run/report.html || die "a title is HTML in the page"
grep -q '&lt;script&gt;x' run/report.html || die "the page does not show the title"
clean

# The texts of an experiment.
experiment() { cat <<TOML
title = "t\`touch ran_5\`'\\""
x_name = "x\`touch ran_6\`'\\""
scene = "$scenes/slider_crank.toml"
settings = ["output.plots=false"]
until = 0.02
[[parameters]]
name = "p\`touch ran_7\`'"
settings = ["solver.rtol={value}"]
values = [1e-4, 1e-5]
[[figures]]
name = "f\`touch ran_8\`'"
key = "drift_position"
[[plots]]
name = "$1"
title = "\`touch ran_9\`'\\""
label = "\`touch ran_10\`'\\""
column = "crank.wz"
TOML
}
column=$(sed -n 2p run/history.csv | tr , '\n' | sed -n 2p)
experiment good | sed "s/crank.wz/$column/" > good.toml
"$footfall" sweep good.toml --out sweep >"$out/sweep.txt" 2>&1 || die "the sweep failed"
[[ -s sweep/good.png ]] || die "the sweep drew no picture"
clean
for name in ../../ran /tmp/ran .ran 'a b' "$(printf 'a%.0s' {1..120})"; do
  experiment "$name" > bad.toml
  "$footfall" sweep bad.toml --out bad >"$out/bad.txt" 2>&1
  [[ $? == 2 ]] || die "a plot named \"$name\" was not refused"
  grep -q 'bad.toml:.*plots[.].*name: is text "' "$out/bad.txt" || die "the message does not name the plot"
done
[[ ! -e bad ]] || die "a refused sweep wrote something"
clean

# A job array: names with blanks, quotes and marks stay names.
name="a b'c;touch ran_11;\`touch ran_12\`%a"
cp good.toml "$name.toml"
"$footfall" sweep "$name.toml" --out "$name" --slurm >"$out/slurm.txt" 2>&1 || die "--slurm"
printf '#!/bin/sh\nprintf "<%%s>\\n" "$@" > "$SAID"\n' > said.sh && chmod +x said.sh
sed "s#^[^# ]*/footfall #./said.sh #" "$name/sweep.sbatch" > job.sh
SAID=$out/words.txt SLURM_ARRAY_TASK_ID=1 bash job.sh || die "the job's line is broken"
grep -qxF "<$PWD/$name.toml>" "$out/words.txt" && grep -qxF "<$PWD/$name>" "$out/words.txt" || die "the job's words are not the names"
clean
cp good.toml $'a\ntouch ran_13\n.toml'
"$footfall" sweep $'a\ntouch ran_13\n.toml' --out line --slurm >"$out/slurm.txt" 2>&1
[[ $? == 2 ]] || die "a line end in a name was not refused"
clean
exit 0
