#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Fails on a file that clang-format would write differently. Usage: format.sh; to mend: clang-format -i FILE
set -euo pipefail
cd "$(dirname "$0")/../.."
find core system plugins idl record web server tournaments programs browser labs tests -name '*.cpp' -o -name '*.hpp' -o -name '*.c' -o -name '*.h' |
  sort | xargs clang-format --dry-run --Werror
