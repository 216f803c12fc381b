#include "slope/seepage/face_pressure.hpp"

#include "slope/seepage/face_flow.hpp"
#include "slope/seepage/pore_flow.hpp"

namespace slope::seepage {

// A front is sharp where gravity does not hold it back.
FaceLaw law_of(const FacePressure& face, const PoreFlow& flow, double elevation, double /*head*/) {
  const std::size_t p = face.particle;
  const HeldFace held{flow.conductivity_at(p, face.pressure), flow.conductivity_at(p), flow.conductivity_slope(p),
                      face.rise, face.distance};
  FaceLaw law;
  law.face_head = face.pressure / flow.water().unit_weight() + elevation + face.rise;
  const double fall = held.fall();
  if (fall <= 0.0 || face.rise < 0.0) {
    const double mean = kirchhoff_mean(held.face, held.particle, face.rise);
    law.conductance = face.area * mean / face.distance;
    law.slope = face.area * settled_flow(held).slope;
    return law;
  }
  const FaceFlow wetting = wetting_flow(held, flow.wetting_front(p, face.pressure));
  law.conductance = face.area * wetting.flux / fall;
  law.slope = face.area * wetting.slope;
  return law;
}

}  // namespace slope::seepage
