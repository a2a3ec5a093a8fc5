// SPDX-License-Identifier: MIT
//
// mirocup-labs: what serves research. `mirocup NAME` starts this program for each of its commands.
#include "labs/programs/commands.hpp"
#include "record/match_record.hpp"
#include "system/child_process.hpp"
#include "system/commands.hpp"
#include "system/locations.hpp"
#include "system/run_program.hpp"

namespace mirocup::labs {

Error become_bench(std::vector<std::string> arguments) {
  return system::become_sibling_program("mirocup-bench", std::move(arguments),
                                        "-D MIROCUP_LABS=ON -D MIROCUP_TESTS=ON");
}

// The program's name is that of the one which people call.
static Result<int> run(int argc, char** argv) {
  if (argc > 1 && argv[1] == std::string("bench"))
    return tl::unexpected(become_bench({argv + 2, argv + argc}));
  system::Commands commands("mirocup", "The commands of mirocup that serve research.",
                            record::software_version(),
                            "mirocup help COMMAND explains a command, with examples.");
  for (Add* const add :
       {add_export, add_tune, add_record_as_seen, add_identify, add_validate, add_new})
    add(commands);
  commands.add_other({"bench",
                      for_engineers,
                      "Compare speed and error with other engines: mirocup bench --help",
                      {"mirocup bench --quick"}});
  return commands.run(argc, argv, system::house_teams());
}

}  // namespace mirocup::labs

int main(int argc, char** argv) {
  return mirocup::system::run_program([&] { return mirocup::labs::run(argc, argv); });
}
