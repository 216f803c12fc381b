#pragma once

#include <string>
#include <vector>

#include "slope/couple/document.hpp"

namespace slope::couple::test {

/// What keeps a document from being valid under a JSON Schema. A keyword that the checker does not know is reported
/// too, so that none is passed over.
[[nodiscard]] std::vector<std::string> schema_violations(const Document& schema, const Document& document,
                                                         const std::string& path = "");

}  // namespace slope::couple::test
