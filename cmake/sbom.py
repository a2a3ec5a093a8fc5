#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints what the packages of a release are made of, as SPDX 2.3 (a software bill of materials).

Usage: sbom.py BUILD: a build tree of the preset "packages", after `cpack -G DEB`. The facts are those of the build and no list by
hand: the headers that the compiler has read (ninja), what the packages depend on (dpkg), and package-lock.json of npm.
"""
import datetime
import json
import os
import re
import subprocess
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[1]


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def installed(names):
    """Returns {package of Debian: version} of those that are installed."""
    rows = subprocess.run(["dpkg-query", "-W", "-f", "${binary:Package} ${Version}\n", *sorted(names)],
                          capture_output=True, text=True).stdout.split("\n")
    return {row.split()[0].split(":")[0]: row.split()[1] for row in rows if len(row.split()) == 2}


def compiled_in(build):
    """Returns the packages of Debian that have headers which the compiler has read, or static libraries of the module."""
    headers = set(re.findall(r"^ +(/usr/\S+)$", output("ninja", "-C", build, "-t", "deps"), re.M))
    headers |= {str(path) for path in Path("/usr/lib/llvm-19/lib").glob("**/libclang_rt.builtins-wasm32.a")}
    real = sorted({os.path.realpath(header) for header in headers})
    rows = subprocess.run(["dpkg", "-S", *real], capture_output=True, text=True).stdout
    return {owner.split(":")[0] for row in rows.split("\n") if row for owner in row.rsplit(": ", 1)[0].split(", ")}


def depended_on(packages):
    """Returns the packages of Debian in Depends of our packages that are not ours."""
    depends = ",".join(output("dpkg-deb", "-f", str(package), "Depends") for package in packages)
    ours = {output("dpkg-deb", "-f", str(package), "Package").strip() for package in packages}
    return {re.split(r"[ (|:]", name.strip())[0] for name in depends.split(",") if name.strip()} - ours


def of_npm(lock):
    """Returns the rows of a package-lock.json: name, version, license, SHA-512 in hexadecimal."""
    import base64
    for path, row in json.loads(lock.read_text())["packages"].items():
        if path:
            digest = base64.b64decode(row["integrity"].removeprefix("sha512-")).hex()
            yield path.removeprefix("node_modules/"), row["version"], row.get("license", "NOASSERTION"), digest


def main(build):
    packages = sorted(Path(build).glob("*.deb"))
    if not packages:
        sys.exit(f"sbom.py: {build} has no packages: run `cpack -G DEB` there")
    version = output("dpkg-deb", "-f", str(packages[0]), "Version").strip()
    date = datetime.datetime.fromtimestamp(int(os.environ.get("SOURCE_DATE_EPOCH", "0")), datetime.timezone.utc)
    parts = []
    relations = [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": "SPDXRef-mirocup"}]

    def add(name, number, license, address, relation, **more):
        identity = "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", name).strip("-")
        if identity not in {part["SPDXID"] for part in parts}:
            parts.append({"SPDXID": identity, "name": name, "versionInfo": number, "downloadLocation": "NOASSERTION",
                          "filesAnalyzed": False, "licenseConcluded": "NOASSERTION", "licenseDeclared": license,
                          "copyrightText": "NOASSERTION",
                          "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                            "referenceLocator": address}], **more})
        if relation:
            relations.append({"spdxElementId": "SPDXRef-mirocup", "relationshipType": relation, "relatedSpdxElement": identity})

    add("mirocup", version, "MIT", f"pkg:deb/mirocup@{version}", None)
    loaded = depended_on(packages)
    for kind, names in (("DYNAMIC_LINK", loaded), ("STATIC_LINK", compiled_in(build))):
        for name, number in sorted(installed(names).items()):
            add(name, number, "NOASSERTION", f"pkg:deb/debian/{name}@{number}", kind)
    for lock in sorted(PROJECT.glob("browser/**/package-lock.json")):
        for name, number, license, digest in of_npm(lock):
            add(name, number, license, f"pkg:npm/{name.replace('@', '%40')}@{number}", "CONTAINS",
                checksums=[{"algorithm": "SHA512", "checksumValue": digest}])
    json.dump({"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"mirocup-{version}",
               "documentNamespace": f"https://spdx.org/spdxdocs/mirocup-{version}-{int(date.timestamp())}",
               "creationInfo": {"created": date.strftime("%Y-%m-%dT%H:%M:%SZ"), "creators": ["Tool: mirocup-sbom.py"]},
               "packages": parts, "relationships": relations}, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
