#pragma once

namespace slope::solid {

/// What a return mapping came to: nothing, or where on the yield surface the stress ended.
enum class Return { elastic, face, edge, apex };

}  // namespace slope::solid
