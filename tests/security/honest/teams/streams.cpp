// SPDX-License-Identifier: MIT
#include "tests/security/honest/honest.hpp"

#include <fstream>
#include <iostream>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>

void Honest::decide(const Observation& now, Command& command) {
  std::ifstream tuning("tuning.txt");
  double speed = 20.0;
  if (tuning) tuning >> speed;
  std::ofstream("debug.txt") << now.tick << std::endl;
  try {
    if (std::stod("not a number") > 0.0) speed = 0.0;
  } catch (const std::invalid_argument&) {
    speed += 1.0;
  }
  try {
    throw now.tick;
  } catch (std::uint32_t tick) {
    if (tick % 50 == 0) std::cout << "tick " << tick << std::endl;
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << speed;
  command.wheels[0] = {std::stod(text.str()), speed};
  if (now.tick == 0) std::cerr << "with streams and exceptions" << std::endl;
}
