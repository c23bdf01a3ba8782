#!/usr/bin/env bash
# first_landing.sh [WORDS...]: the first landing on a bare machine, with the time of each stage. In a clean Debian 12 (debootstrap, network, root) with a copy of what is
# committed here: `./footfall run WORDS`. TRY_ROOT: where the clean Debian is kept for the next time.
set -euo pipefail
cd "$(dirname "$0")/../.."
((EUID == 0)) || { echo "first_landing.sh: needs root, for debootstrap and chroot" >&2; exit 2; }
command -v debootstrap >/dev/null || { echo "first_landing.sh: debootstrap is missing; apt-get install debootstrap" >&2; exit 2; }
base=${TRY_ROOT:-$(mktemp -d)}/bookworm
root=$base.first
clean() {
  for place in dev/shm proc sys; do ! mountpoint -q "$root/$place" || umount "$root/$place"; done
  rm -rf --one-file-system "$root"
}
trap 'clean; [[ -n ${TRY_ROOT-} ]] || rm -rf "$base"' EXIT
[[ -f $base/.ready ]] || { debootstrap --variant=minbase bookworm "$base" >"$base.log" 2>&1 || { tail "$base.log" >&2; exit 1; }; touch "$base/.ready"; }
clean
cp -a "$base" "$root"
mount --bind /dev/shm "$root/dev/shm"
mount -t proc proc "$root/proc"
mount -t sysfs sys "$root/sys"
printf '127.0.0.1 localhost %s\n' "$(hostname)" >"$root/etc/hosts"  # as every installed Debian has it
mkdir "$root/footfall"
git archive HEAD | tar -x -C "$root/footfall"
began=$(date +%s.%N)
chroot "$root" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin sh -c 'cd /footfall && exec ./footfall run "$@"' sh "$@" 2>&1 |
  while IFS= read -r line; do echo "$(awk -v a="$began" -v b="$(date +%s.%N)" 'BEGIN { printf "%6.1f s", b - a }')  $line"; done
awk -v a="$began" -v b="$(date +%s.%N)" 'BEGIN { printf "%6.1f s  in all\n", b - a }'
awk '/^model name/ { sub(/.*: /, ""); model = $0; ++n } END { printf "The machine: %s, %d cores.\n", model, n }' /proc/cpuinfo
