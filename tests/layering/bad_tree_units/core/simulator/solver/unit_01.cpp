// SPDX-License-Identifier: MIT
// The source of a header is no unit of its own.
