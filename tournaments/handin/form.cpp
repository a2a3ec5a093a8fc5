// SPDX-License-Identifier: MIT
#include "tournaments/handin/form.hpp"

#include <charconv>

namespace mirocup::league {

std::string decoded_form_text(std::string_view coded) {
  std::string value;
  for (std::size_t i = 0; i < coded.size(); ++i) {
    unsigned code = 0;
    if (coded[i] == '%' && i + 2 < coded.size() &&
        std::from_chars(coded.data() + i + 1, coded.data() + i + 3, code, 16).ptr ==
            coded.data() + i + 3) {
      value += static_cast<char>(code);
      i += 2;
    } else {
      value += coded[i] == '+' ? ' ' : coded[i];
    }
  }
  return value;
}

}  // namespace mirocup::league
