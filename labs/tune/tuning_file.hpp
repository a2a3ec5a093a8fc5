// SPDX-License-Identifier: MIT
//
// The folder of a search. tune.json holds the marks of every candidate that has played, so that a
// stopped search can continue and gives the same result. course.svg shows the course of the search.
#pragma once

#include "labs/tune/tuning.hpp"
#include "system/files.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace mirocup::league {

class TuningFile {
 public:
  // Opens a folder, or makes it. `identity` is everything on which the marks depend. The error is
  // Errc::input if the folder holds a search with another identity.
  static Result<TuningFile> open(system::Files& files, const std::string& folder,
                                 nlohmann::ordered_json identity);

  // Returns the marks of a candidate; null if the marks are not known.
  const std::vector<Mark>* find(const std::string& key) const;
  // Keeps the marks of a candidate. The marks are on disk when the function returns.
  Result<void> keep(const std::string& key, std::vector<Mark> marks);

  int known() const { return static_cast<int>(marks_.size()); }

 private:
  TuningFile(system::Files& files, std::string path, nlohmann::ordered_json identity)
      : files_(&files), path_(std::move(path)), identity_(std::move(identity)) {}

  system::Files* files_;
  std::string path_;
  nlohmann::ordered_json identity_;
  std::map<std::string, std::vector<Mark>> marks_;
};

// Returns the course of a search as a picture: the goals of the candidates, and mean and spread of
// each parameter, by generation.
std::string course_svg(const TuningOptions& options, const std::vector<Generation>& course);

}  // namespace mirocup::league
