// SPDX-License-Identifier: MIT
//
// A library needs a source: this one is compiled with the headers of precompiled.cmake.
