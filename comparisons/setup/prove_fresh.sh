#!/usr/bin/env bash
# Proves the set-up: a minimal Debian 12 root, a clone of HEAD, both commands inside.
set -euo pipefail

if [ "${1:-}" = --help ] || [ "${1:-}" = -h ]; then
  cat <<'HELP'
usage: comparisons/setup/prove_fresh.sh [--keep] [--root DIR] [--logs DIR] [run|tests]...

As root, on a Debian with mmdebstrap: makes a minimal Debian 12 in DIR (default:
a new folder under $TMPDIR), clones the current HEAD into it (uncommitted changes
are left out), and runs `bash comparisons/run` and `bash tests/run` there, or only
the ones named. Packages come through this machine's apt configuration, npm's
through its npm configuration; both are copied when the script runs.

  --root DIR   where the root goes; an existing one made by this script is refused
  --logs DIR   where the logs go (default: build/fresh)
  --keep       leave the root in place afterwards (it is kept on failure too)

Status 0 when each command ended with 0. The logs are bootstrap.log, run.log,
tests.log and packages.txt (every package with its version).
HELP
  exit 0
fi

project_folder="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
root='' logs="$project_folder/build/fresh" keep=no wanted=()
while [ $# -gt 0 ]; do
  case "$1" in
    --root) root="$2"; shift 2 ;;
    --logs) logs="$2"; shift 2 ;;
    --keep) keep=yes; shift ;;
    run | tests) wanted+=("$1"); shift ;;
    *) echo "prove_fresh: unknown argument $1 (--help)" >&2; exit 2 ;;
  esac
done
[ "${#wanted[@]}" -gt 0 ] || wanted=(run tests)
[ "$(id -u)" -eq 0 ] || { echo "prove_fresh: needs root (chroot, mount)" >&2; exit 2; }
command -v mmdebstrap >/dev/null || { echo "prove_fresh: apt-get install mmdebstrap" >&2; exit 2; }
[ -n "$root" ] || root="$(mktemp -d)/debian-12"
[ ! -e "$root" ] || { echo "prove_fresh: $root exists" >&2; exit 2; }
mkdir -p "$logs" "$(dirname "$root")"

mounted=()
unmount_all() {
  local i
  for ((i = ${#mounted[@]} - 1; i >= 0; i--)); do umount -l "${mounted[i]}" || true; done
  mounted=()
}
trap unmount_all EXIT
mount_into_root() {  # TYPE SOURCE PLACE [OPTIONS]
  mount -t "$1" ${4:+-o "$4"} "$2" "$root$3"
  mounted+=("$root$3")
}

copy_into_root() {  # PATH...: this machine's configuration, where it has one
  local path
  for path in "$@"; do
    if [ -e "$path" ]; then mkdir -p "$root$(dirname "$path")" && cp -aL "$path" "$root$(dirname "$path")/"; fi
  done
}

echo "prove_fresh: minimal Debian 12 in $root"
# The host's sources, restricted to what Debian itself signs.
sources=(/etc/apt/sources.list.d/debian.sources)
if [ ! -r "${sources[0]}" ]; then sources=(/etc/apt/sources.list); fi
mmdebstrap --variant=minbase --include=ca-certificates,git bookworm "$root" "${sources[@]}" \
  >"$logs/bootstrap.log" 2>&1 || { tail -n 20 "$logs/bootstrap.log" >&2; exit 1; }

copy_into_root /etc/resolv.conf /etc/hosts /etc/apt/apt.conf.d /etc/apt/auth.conf.d \
  /etc/apt/trusted.gpg.d /usr/local/share/ca-certificates /etc/ssl/certs/ca-certificates.crt \
  /etc/npmrc "$HOME/.npmrc"
mount --bind "$root" "$root"  # a root that is a mount, as a machine's is: name spaces of mounts need one
mounted+=("$root")
mount_into_root proc proc /proc
mount_into_root sysfs sysfs /sys ro
mount_into_root tmpfs tmpfs /dev mode=755
for device in null zero full random urandom tty; do cp -a "/dev/$device" "$root/dev/"; done
ln -s /proc/self/fd "$root/dev/fd"; ln -s fd/0 "$root/dev/stdin"
ln -s fd/1 "$root/dev/stdout"; ln -s fd/2 "$root/dev/stderr"
mkdir "$root/dev/shm" "$root/dev/pts"
mount_into_root tmpfs tmpfs /dev/shm
mount_into_root devpts devpts /dev/pts newinstance,ptmxmode=0666,mode=620
ln -s pts/ptmx "$root/dev/ptmx"

git clone --quiet --no-hardlinks "$project_folder" "$root/root/rebound"
git -C "$root/root/rebound" checkout --quiet --detach "$(git -C "$project_folder" rev-parse HEAD)"

# Inside, only what a login would have, and the machine's network settings.
network=()
for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY \
  SSL_CERT_FILE NODE_EXTRA_CA_CERTS; do
  if [ -n "${!name:-}" ]; then network+=("$name=${!name}"); fi
done
run_inside() {  # NAME COMMAND
  local begin=$SECONDS status=0
  chroot "$root" env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    LANG=C.UTF-8 ${network[@]+"${network[@]}"} bash -c "cd /root/rebound && $2" \
    >"$logs/$1.log" 2>&1 </dev/null || status=$?
  echo "prove_fresh: $2 -> status $status, $((SECONDS - begin)) s, $logs/$1.log"
  return "$status"
}

result=0
for name in "${wanted[@]}"; do
  case "$name" in
    run) run_inside run 'bash comparisons/run' || result=1 ;;
    tests) run_inside tests 'bash tests/run' || result=1 ;;
  esac
done
chroot "$root" dpkg-query -W >"$logs/packages.txt"
unmount_all
if [ "$keep" = no ] && [ "$result" -eq 0 ]; then rm -rf --one-file-system "$root"; else echo "prove_fresh: kept $root"; fi
if [ "$result" -eq 0 ]; then tail -n 1 "$logs"/{run,tests}.log 2>/dev/null || true; fi
exit "$result"
