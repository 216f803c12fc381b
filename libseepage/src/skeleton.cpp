#include "slope/seepage/skeleton.hpp"

#include "require.hpp"

namespace slope::seepage {

void Skeleton::check() const {
  const auto size_of = [this](const std::string& name, std::span<const double> field) {
    require(field.size() == size(), name, "one for each particle", static_cast<double>(field.size()));
  };
  size_of("y", y), size_of("volume", volume), size_of("porosity", porosity);
  for (std::size_t p = 0; p < size(); ++p) {
    require(std::isfinite(x[p]), "x", "a number", x[p]);
    require(std::isfinite(y[p]), "y", "a number", y[p]);
    require_above(0.0, "volume", volume[p]);
    require(porosity[p] > 0.0 && porosity[p] < 1.0, "porosity", "above 0 and below 1", porosity[p]);
  }
}

void MirrorWalls::check() const {
  require(right > left, "walls.right", "above walls.left", right);
  require(top > base, "walls.top", "above walls.base", top);
}

}  // namespace slope::seepage
