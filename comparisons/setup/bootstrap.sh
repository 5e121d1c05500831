# Sourced by comparisons/run and tests/run: a fresh Debian 12 becomes a build.
#
#   install_packages LIST...   the packages of the lists that are missing; nothing
#                              missing means no network is touched
#   configure_build ARG...     configures build/ (Ninja, Release)
#   run_build ARG...           builds, one unit at a time where memory is short
#
# Needs bash only. Every failure ends the caller with a message and status 1.

setup_folder="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
project_folder="$(cd "$setup_folder/../.." && pwd)"
build_folder="$project_folder/build"
lock_patience_s=600

say() { printf '%s\n' "[set-up] $*" >&2; }
fail() { printf '%s\n' "[set-up] $*" >&2; exit 1; }

# Lines "package [command]" of the lists, comments dropped.
listed_packages() {
  local list
  for list in "$@"; do sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$setup_folder/$list"; done
}

is_installed() {  # package [command]
  if [ -n "${2:-}" ] && command -v "$2" >/dev/null 2>&1; then return 0; fi
  # Not grep -q: it may close the pipe early, which pipefail would read as "missing".
  dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null | grep -x installed >/dev/null
}

require_debian_12() {  # LIST...
  local name='an unknown system' id='' version=''
  if [ -r /etc/os-release ]; then
    name="$(. /etc/os-release; printf '%s' "${PRETTY_NAME:-$ID}")"
    id="$(. /etc/os-release; printf '%s' "${ID:-}")"
    version="$(. /etc/os-release; printf '%s' "${VERSION_ID:-}")"
  fi
  if [ "$id" = debian ] && [ "$version" = 12 ]; then return 0; fi
  say "This is $name. The set-up knows Debian 12 (bookworm) and changes no other system."
  say "The packages it would need, by their Debian 12 names:"
  listed_packages "$@" | awk '{print "  " $1}' >&2
  fail "With those in place: cmake -S . -B build -G Ninja && cmake --build build"
}

# apt-get update keeps a lock of its own that no option waits for.
update_package_index() {  # PREFIX...
  local waited=0
  until "$@" apt-get -qq update; do
    [ "$waited" -ge 60 ] && { say "apt-get update failed; trying with the index as it is."; return 0; }
    sleep 10; waited=$((waited + 10))
    say "apt-get update failed or is locked; trying again ($waited s)."
  done
}

install_packages() {  # LIST...
  require_debian_12 "$@"
  local package command missing=()
  while read -r package command; do
    is_installed "$package" "$command" || missing+=("$package")
  done < <(listed_packages "$@")
  if [ "${#missing[@]}" -eq 0 ]; then return 0; fi

  local install="apt-get install -y --no-install-recommends ${missing[*]}"
  local prefix=(env DEBIAN_FRONTEND=noninteractive)
  if [ "$(id -u)" -ne 0 ]; then
    # sudo without a password, or with a terminal on which to ask for one.
    if command -v sudo >/dev/null 2>&1 && { sudo -n true 2>/dev/null || [ -t 0 ]; }; then
      prefix=(sudo "${prefix[@]}")
    else
      say "Packages are missing and this user cannot install them. As root:"
      printf '  apt-get update && %s\n' "$install" >&2
      exit 1
    fi
  fi
  say "Installing: ${missing[*]}"
  update_package_index "${prefix[@]}"
  "${prefix[@]}" apt-get -qq -o DPkg::Lock::Timeout="$lock_patience_s" -o Dpkg::Use-Pty=0 \
    install -y --no-install-recommends "${missing[@]}" >&2 ||
    fail "The installation failed. By hand, as root: apt-get update && $install"
}

# MemAvailable, or what the control group leaves where that is less [MiB].
free_memory_mib() {
  local free limit used
  free=$(awk '/^MemAvailable:/ {print int($2 / 1024)}' /proc/meminfo)
  limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || echo max)
  if [ "$limit" != max ]; then
    used=$(cat /sys/fs/cgroup/memory.current 2>/dev/null || echo 0)
    limit=$(((limit - used) / 1048576))
    if [ "$limit" -lt "$free" ]; then free=$limit; fi
  fi
  echo "$free"
}

configure_build() {  # CMAKE-ARGUMENT...
  cmake -S "$project_folder" -B "$build_folder" -G Ninja -DCMAKE_BUILD_TYPE=Release "$@" >&2 ||
    fail "CMake could not configure $build_folder."
}

run_build() {  # NINJA-ARGUMENT...
  local jobs
  jobs=$(nproc)
  # A unit with the whole of deal.II takes more than a gigabyte.
  if [ "$(free_memory_mib)" -lt 4096 ]; then jobs=1; fi
  ninja -C "$build_folder" -j "$jobs" "$@" >&2 || fail "The build failed."
}
