#!/usr/bin/env bash
# packaging/clean_root.sh RELEASE FOLDER [COMMAND...]: runs COMMAND, or a shell, in a minimal Debian in FOLDER, which is made
# by mmdebstrap if it is not there (a minute, 300 MB). RELEASE: bookworm, trixie.
# It has apt as this machine has it, git, sudo, an ordinary user `user` who may call sudo, and nothing else: no compiler, no
# compiler cache. A clone of this checkout's HEAD is in /home/user/footfall, where COMMAND starts as `user`.
#   ROOT_USER=root     as root, with the clone in /root/footfall
#   ROOT_PLACE=NAME    the clone in a folder of this name beside it, blanks included
#   ROOT_ENV='A=1 B=2' more environment
#   ROOT_TRIAL=1       what COMMAND changes is gone afterwards
# As root, or as a user with subordinate ids (package uidmap) where user namespaces are allowed. Exit code 69: no root could be made.
set -euo pipefail
release=${1:?RELEASE} root=${2:?FOLDER}
shift 2
checkout=$(cd "$(dirname "$0")/.." && pwd)
user=${ROOT_USER:-user} place=${ROOT_PLACE:-footfall}

space=(unshare --mount --pid --fork --kill-child)
((EUID == 0)) || space+=(--user --map-root-user --map-auto)

if [[ ! -d $root/bin ]]; then
  # The source of this machine's packages; of another distribution than Debian, the default of mmdebstrap.
  source=
  if grep -q '^ID=debian' /etc/os-release; then
    source=$({ cat /etc/apt/sources.list.d/*.sources /etc/apt/sources.list 2>/dev/null || true; } |
      sed -nE 's/^URIs: *([^ ]+).*/\1/p; s/^deb (\[[^]]*\] )?([^ ]+) .*/\2/p' | head -n 1)
  fi
  options=$(mktemp)
  apt-config dump Acquire 2>/dev/null | grep -E '^Acquire::(Check-|[a-z]+::Proxy)' >"$options" || true
  mmdebstrap --quiet --variant=minbase --include=git,ca-certificates,sudo --aptopt="$options" \
    --customize-hook='chroot "$1" useradd --create-home --shell /bin/bash user' \
    --customize-hook='echo "user ALL=(ALL) NOPASSWD: ALL" >"$1/etc/sudoers.d/user"' \
    --customize-hook='echo "Defaults env_keep += \"http_proxy https_proxy no_proxy\"" >>"$1/etc/sudoers.d/user"' \
    "$release" "$root" ${source:+"$source"} >&2 || exit 69
  rm -f "$options"
fi

# Its own mounts and processes, which end with it.
export release root checkout user place
exec "${space[@]}" bash -euo pipefail -c '
  if [[ -n ${ROOT_TRIAL-} ]]; then  # a layer over the root, in memory
    mkdir -p "$root.trial"
    mount -t tmpfs -o size=8g tmpfs "$root.trial"
    mkdir "$root.trial/new" "$root.trial/work" "$root.trial/root"
    mount -t overlay -o "lowerdir=$root,upperdir=$root.trial/new,workdir=$root.trial/work" overlay "$root.trial/root"
    root=$root.trial/root
  fi
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  mount -t tmpfs tmpfs "$root/dev/shm"
  mount --rbind /sys "$root/sys"
  printf "127.0.0.1 localhost %s\n" "$(hostname)" >"$root/etc/hosts"  # without it mpirun waits for the name of the host
  [[ ! -e /etc/resolv.conf ]] || cat /etc/resolv.conf >"$root/etc/resolv.conf"
  home=/root
  [[ $user == root ]] || home=/home/$user
  if [[ ! -e $root$home/$place ]]; then
    git clone --quiet --no-hardlinks "$checkout" "$root$home/$place"
    chroot "$root" chown -R "$user:$user" "$home/$place"
  fi
  (($#)) || set -- bash
  exec chroot --userspec="$user:$user" "$root" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME="$home" USER="$user" TERM=dumb \
    http_proxy="${http_proxy-}" https_proxy="${https_proxy-}" no_proxy="${no_proxy-}" ${ROOT_ENV-} \
    bash -c "cd \"\$HOME/\$0\" && exec \"\$@\"" "$place" "$@"
' clean_root "$@"
