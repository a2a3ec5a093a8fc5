/* SPDX-License-Identifier: MIT */
/* Empty, because teams use nothing of this header. */
