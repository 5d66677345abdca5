# Finds and installs Debian packages; to be sourced by the scripts that need them.

# Leaves those of the given packages that are not installed in `missing`.
find_missing() {
  missing=()
  local package
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
}

# Tries to install the given packages, as root or with sudo, and passes on apt's reasons if it cannot; leaves those that
# are still not there in `missing`.
install_packages() {
  find_missing "$@"
  [ ${#missing[@]} -eq 0 ] && return
  local as_root=() said
  if [ "$(id -u)" -ne 0 ]; then
    sudo -n true 2>/dev/null || return 0
    as_root=(sudo -n)
  fi
  echo "installing ${missing[*]}"
  "${as_root[@]}" apt-get update -qq >/dev/null 2>&1 || true
  said=$("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    "${missing[@]}" 2>&1 >/dev/null) || grep '^E:' <<<"$said" >&2 || true
  find_missing "$@"
}

# Installs the given packages, or ends the script with exit code 2 and names those that are missing.
demand_packages() {
  install_packages "$@"
  [ ${#missing[@]} -eq 0 ] && return
  echo "missing packages that could not be installed (root or sudo, and apt, are needed): ${missing[*]}" >&2
  exit 2
}
