#pragma once

#include <span>

#include "slope/seepage/head_operator.hpp"

namespace slope::couple {

/// How much of a pressure field alternates from particle to particle (-): the root mean square over the particles of
///
///     d_p = sum_q g_pq (P_p - P_q - (grad P_p + grad P_q).(x_p - x_q) / 2) / sum_q g_pq,
///
/// over the range of P. Fields that vary quadratically give zero; an alternating field of amplitude A gives about A.
[[nodiscard]] double pressure_checkerboard(const seepage::HeadOperator& head_operator,
                                           const seepage::Skeleton& skeleton, std::span<const double> pressure);

}  // namespace slope::couple
