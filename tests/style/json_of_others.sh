#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Fails on a line that takes a value from JSON by a function of the library which throws if the value has another type, or
# that parses JSON by the library. Whoever wrote the JSON would then decide whether the program ends. JsonReader
# (record/json_reader.hpp), text_in(), value_in() and get_ptr() do not throw.
set -euo pipefail
cd "$(dirname "$0")/../.."
if git grep -nE '(\.|->)(value\([^)]|get<|get_to\(|get_ref<)|[jJ]son::parse\(' -- '*.cpp' '*.hpp' ':!tests' ':!labs/tests' ':!labs/bench' ':!record/json_reader.?pp'; then
  echo "read these values by record::JsonReader, value_in() or text_in()" >&2
  exit 1
fi
