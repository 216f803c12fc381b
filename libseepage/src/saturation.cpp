#include "slope/seepage/saturation.hpp"

#include "require.hpp"

namespace slope::seepage {

void SaturationRange::check() const {
  require(maximum > 0.0 && maximum <= 1.0, "range.maximum", "above 0 and at most 1", maximum);
  require(residual >= 0.0 && residual < maximum, "range.residual", "at least 0 and below range.maximum", residual);
}

}  // namespace slope::seepage
