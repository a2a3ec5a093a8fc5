/* SPDX-License-Identifier: MIT */
int mirocup_entry_misspelt(void);
int mirocup_entry_misspelt(void) {
  return 0;
}
