#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Builds the packages twice, in folders of different depth, as another user, at another date, in another time zone, language and
# umask, and compares them and the browser module byte for byte. Prints their SHA-256.
# Usage: tests/release/reproducible.sh [-o FOLDER]: leaves packages and SHA256SUMS there. Exit 3 if this computer cannot do it.
#
# Catches a path, a date, a random number or an order of files of the building computer in what is released.
set -euo pipefail
root=$(realpath "$(dirname "$0")/../..")
output=
[[ ${1:-} != -o ]] || output=$(realpath -m "${2:?a folder is expected}")
for tool in faketime setpriv dpkg-shlibdeps; do
  command -v "$tool" >/dev/null || { echo "$tool is missing: cmake/install_packages.sh cmake/packages-install.txt" >&2; exit 3; }
done
[[ $(id -u) -eq 0 ]] || { echo "root is needed: the second build is another user's" >&2; exit 3; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
chmod 755 "$folder"
SOURCE_DATE_EPOCH=$(git -C "$root" log -1 --format=%ct)
export SOURCE_DATE_EPOCH

# build FOLDER: the packages of the last commit. Runs as whoever calls it.
build='
  cd "$0"
  cmake --preset packages >/dev/null
  cmake --build --preset packages >build.log 2>&1 || { tail -n 50 build.log; exit 1; }
  cd build/packages
  umask 022  # cpack writes it into a package
  cpack -G DEB >cpack.log 2>&1 || { tail -n 50 cpack.log; exit 1; }
'
first=$folder/a
second=$folder/another/folder/of/mirocup
git clone -q "$root" "$first"
git clone -q "$root" "$second"
chown -R 1500:1500 "$folder/another"
echo "== here and now" >&2
bash -ec "$build" "$first"
echo "== another folder, user, date, time zone, language and umask" >&2
(
  umask 027
  setpriv --reuid 1500 --regid 1500 --clear-groups env HOME="$folder/another" TZ=Pacific/Auckland LC_ALL=C.UTF-8 \
    faketime -f +40d bash -ec "$build" "$second"
)

bad=0
mkdir "$folder/release"
for file in "$first"/build/packages/*.deb "$first"/build/packages/browser/mirocup.wasm; do
  if ! cmp "$file" "${file/#$first/$second}"; then
    bad=1
    ! command -v diffoscope >/dev/null || diffoscope --text - "$file" "${file/#$first/$second}" | head -n 60 || true
  fi
  cp "$file" "$folder/release/"
done
"$first/cmake/sbom.py" "$first/build/packages" >"$folder/release/mirocup.spdx.json"
(cd "$folder/release" && sha256sum -- * | tee SHA256SUMS)
if [[ -n $output ]]; then
  mkdir -p "$output"
  cp "$folder/release"/* "$output/"
fi
exit "$bad"
