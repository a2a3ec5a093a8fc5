// SPDX-License-Identifier: MIT
// One of 17 units in one room.
