// SPDX-License-Identifier: MIT
bool may_control(const std::string& sent) {
  return sent == key_;
}
