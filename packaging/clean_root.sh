#!/usr/bin/env bash
# packaging/clean_root.sh RELEASE FOLDER [COMMAND...]; clean_root.sh --remove FOLDER
# Runs COMMAND, or a shell, in a minimal Debian in FOLDER, which is made
# by mmdebstrap if it is not there (a minute, 300 MB). RELEASE: bookworm, trixie, testing.
# It has apt as this machine has it, git, sudo, an ordinary user `user` who may call sudo, and nothing else: no compiler, no
# compiler cache. A clone of this checkout's HEAD is in /home/user/footfall, where COMMAND starts as `user`.
#   ROOT_USER=root     as root, with the clone in /root/footfall
#   ROOT_PLACE=NAME    the clone in a folder of this name, blanks included
#   ROOT_ENV='A=1 B=2' more environment
#   ROOT_TRIAL=1       what COMMAND changes is gone afterwards
# As root, or as a user with subordinate ids (package uidmap) where user namespaces are allowed. Exit code 69: no root could be made.
set -euo pipefail
release=${1:?RELEASE} root=$(realpath -m "${2:?FOLDER}")
shift 2
checkout=$(cd "$(dirname "$0")/.." && pwd)
user=${ROOT_USER:-user} place=${ROOT_PLACE:-footfall}

space=(unshare --mount --pid --fork --kill-child)
((EUID == 0)) || space=(mmdebstrap --unshare-helper "${space[@]}")
[[ $release != --remove ]] || exec "${space[@]}" rm -rf --one-file-system "$root"
work=$(mktemp -d)
chmod 755 "$work"
trap 'rm -rf "$work"' EXIT

if [[ ! -d $root/bin ]]; then
  # The source of this machine's packages; of another distribution than Debian, the default of mmdebstrap.
  source=
  if grep -q '^ID=debian' /etc/os-release; then
    source=$({ cat /etc/apt/sources.list.d/*.sources /etc/apt/sources.list 2>/dev/null || true; } |
      sed -nE 's/^URIs: *([^ ]+).*/\1/p; s/^deb (\[[^]]*\] )?([^ ]+) .*/\2/p' | head -n 1)
  fi
  apt-config dump Acquire 2>/dev/null | grep -E '^Acquire::(Check-|[a-z]+::Proxy)' >"$work/apt" || true
  mmdebstrap --quiet --variant=minbase --include=git,ca-certificates,sudo --aptopt="$work/apt" \
    --customize-hook='chroot "$1" useradd --create-home --shell /bin/bash user' \
    --customize-hook='echo "user ALL=(ALL) NOPASSWD: ALL" >"$1/etc/sudoers.d/user"' \
    --customize-hook='echo "Defaults env_keep += \"http_proxy https_proxy no_proxy\"" >>"$1/etc/sudoers.d/user"' \
    "$release" "$root" ${source:+"$source"} >&2 || { "${space[@]}" rm -rf --one-file-system "$root"; exit 69; }
fi
git clone --quiet --no-hardlinks "$checkout" "$work/clone"

# With mounts and processes of its own, which end with it.
export root work user place
code=0
"${space[@]}" bash -euo pipefail -c '
  if [[ -n ${ROOT_TRIAL-} ]]; then  # a layer over the root, in memory
    mount -t tmpfs -o size=8g tmpfs /mnt
    mkdir /mnt/new /mnt/work /mnt/root
    mount -t overlay -o "lowerdir=$root,upperdir=/mnt/new,workdir=/mnt/work" overlay /mnt/root
    root=/mnt/root
  fi
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  mount -t tmpfs tmpfs "$root/dev/shm"
  mount -t tmpfs tmpfs "$root/tmp"  # Open MPI names folders there by numbers of processes, which begin at 1 again
  mount --rbind /sys "$root/sys"
  printf "127.0.0.1 localhost %s\n" "$(hostname)" >"$root/etc/hosts"  # without it mpirun waits for the name of the host
  [[ ! -e /etc/resolv.conf ]] || cat /etc/resolv.conf >"$root/etc/resolv.conf"
  home=/root
  [[ $user == root ]] || home=/home/$user
  if [[ ! -e $root$home/$place ]]; then
    cp -r "$work/clone" "$root$home/$place"
    chroot "$root" chown -R "$user:$user" "$home/$place"
  fi
  (($#)) || set -- bash
  chroot --userspec="$user:$user" "$root" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME="$home" USER="$user" TERM=dumb \
    http_proxy="${http_proxy-}" https_proxy="${https_proxy-}" no_proxy="${no_proxy-}" ${ROOT_ENV-} \
    bash -c "cd \"\$HOME/\$0\" && exec \"\$@\"" "$place" "$@"
' clean_root "$@" || code=$?
exit $code
