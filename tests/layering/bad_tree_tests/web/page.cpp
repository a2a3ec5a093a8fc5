// SPDX-License-Identifier: MIT
//
// A comment may name tests/unit/web/page_test.cpp.
const char* const sample = "tests/programs/records/samples/leg.json";
