#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Installs the Debian packages that are missing. Usage: install_packages.sh LIST... (files with one package a line).
# Uses neither the network nor sudo if all of them are installed. Exit 3 if it cannot install.
set -euo pipefail

# Some packages provide others: NodeSource's nodejs, for example, provides npm.
there=$(dpkg-query --show --showformat='${db:Status-Status} ${Package}, ${Provides}\n' | sed -n 's/^installed //p' |
  tr ',' '\n' | sed 's/(.*//; s/ //g')
missing=()
for package in $(cat "$@"); do
  grep -qxF "$package" <<<"$there" || missing+=("$package")
done
[[ ${#missing[@]} -eq 0 ]] && exit 0

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "these Debian packages are missing; install them as root: ${missing[*]}" >&2
    exit 3
  fi
  as_root=(sudo)
fi
echo "installing ${missing[*]}" >&2
export DEBIAN_FRONTEND=noninteractive
{ "${as_root[@]}" apt-get update -qq &&
  "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}"; } >&2 || {
  echo "apt-get could not install ${missing[*]}" >&2
  exit 3
}
