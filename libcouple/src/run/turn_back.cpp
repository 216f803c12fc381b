#include "turn_back.hpp"

namespace slope::couple {

void turn_back(const Frame& frame, ParticleTable& table) {
  for (Point& point : table.position) point = frame.position(point);
  if (!frame.is_mirrored()) return;
  for (auto* vectors : {&table.displacement, &table.velocity, &table.darcy_velocity}) {
    for (Point& vector : *vectors) negate(vector[0]);
  }
  for (auto* tensors : {&table.stress_effective, &table.strain}) {
    for (PlaneTensor& tensor : *tensors) negate(tensor.xy);
  }
}

void turn_back(const Frame& frame, Summary& summary) {
  const auto lift = [&](FailureZone& zone) {
    if (zone.area == 0.0) return;
    zone.lowest = frame.height(zone.lowest);
    zone.highest = frame.height(zone.highest);
  };
  const auto turn = [&](Slide& slide) {
    if (frame.is_mirrored()) slide.direction = -slide.direction;
    if (slide.toe) slide.toe = frame.position(*slide.toe);
  };
  if (summary.onset_time) summary.onset_position = frame.position(summary.onset_position);
  if (summary.zone_at_onset) lift(*summary.zone_at_onset);
  if (summary.zone_at_10_cm) lift(*summary.zone_at_10_cm);
  lift(summary.zone_at_end);
  if (summary.slide_at_10_cm) turn(*summary.slide_at_10_cm);
  turn(summary.slide_at_end);
}

}  // namespace slope::couple
