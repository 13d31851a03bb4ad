// element.html: element tests of one or more materials as a page that opens without a network.
#pragma once

#include "page/payload.hpp"
#include "run/element/element.hpp"

#include <string>
#include <vector>

namespace terp {

struct ElementOnPage {
  std::string material, law;
  ElementResult result;
};

/// title: what was done, in words. written: time, UTC, ISO 8601.
Payload element_payload(
    const std::string& title, const std::vector<ElementOnPage>& elements, const std::string& written);

}  // namespace terp
