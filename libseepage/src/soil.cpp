#include "slope/seepage/soil.hpp"

#include "require.hpp"

namespace slope::seepage {

namespace {

// Says of what the field is.
template <class Check>
void check_part(const std::string& name, const Check& check) {
  try {
    check();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(name + "." + error.what());
  }
}

}  // namespace

void Soil::check() const {
  check_part("retention", [this] { std::visit([](const auto& law) { law.check(); }, retention); });
  check_part("relative_permeability", [this] { relative_permeability.check(); });
  require_above(0.0, "hydraulic_conductivity", hydraulic_conductivity);
}

void Water::check() const {
  require_above(0.0, "density", density);
  require_above(0.0, "bulk_modulus", bulk_modulus);
  require_above(0.0, "gravity", gravity);
}

}  // namespace slope::seepage
