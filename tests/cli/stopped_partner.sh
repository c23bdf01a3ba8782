#!/usr/bin/env bash
# stopped_partner.sh FOOTFALL OUT PROGRAM [PHASE]: one program of a coupled run is stopped (SIGSTOP). After coupling.timeout the other says so,
# the run ends with exit code 1, and nothing is left behind.
set -u
source "$(dirname "$0")/run_to_end.sh"
program=$3 phase=${4:-window}
start_run "$1" "$2" "$phase" --set coupling.timeout=2
stopped=$(processes_of "$program" | head -n 1)
[[ -n $stopped ]] || die "$program was not found"
kill -STOP "$stopped"
start=$(now)
wait_for_end 60 || die "still there: $(processes_of "" | tr '\n' ' ')"
echo "$phase, $program stopped: ended with code $code after $(((gone - start) / 1000000)) s"
[[ $code == 1 ]] || die "exit code $code, expected 1"
grep -q 'has said nothing for\|nothing for 2\|has been stopped for' said.txt || die "no message tells of the silent partner"
grep -q '"status": "failed"' run/summary.json || die "the summary does not say failed"
exit 0
