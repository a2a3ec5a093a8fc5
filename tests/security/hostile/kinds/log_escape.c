/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  fputs(
      "\x1b[2J\x1b]0;title\a\xc2\x9b"
      "1m\xff\xe2\x80\xae<script>\r\n",
      stderr);
}
