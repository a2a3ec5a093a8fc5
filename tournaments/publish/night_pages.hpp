// SPDX-License-Identifier: MIT
//
// A night as pages, as text for a mail, and as JSON.
#pragma once

#include "tournaments/publish/night.hpp"
#include "tournaments/publish/site_file.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace mirocup::league {

// Makes night.html with the digests of all teams, and digests/TEAM.html for each team. `overview`
// and `night` must outlive the pages.
FileMakers night_pages(const Overview& overview, const Night& night);

// Returns the digest of a team as part of a page. `root` leads to the top of the site.
std::string digest_html(const Overview& overview, const Night& night, const TeamDigest& digest,
                        const std::string& root);

// Returns the digest of a team as lines for a mail. Links begin with `address`; if `address` is
// empty, the text has no links.
std::string digest_text(const Overview& overview, const Night& night, const TeamDigest& digest,
                        const std::string& address = "");

nlohmann::ordered_json digest_json(const Overview& overview, const TeamDigest& digest);

}  // namespace mirocup::league
