#pragma once

namespace slope::tools {

/// From now on the first SIGINT, SIGTERM or SIGHUP only asks the run to stop; a second SIGINT or SIGTERM ends the
/// program at once.
void catch_interruptions();

/// Whether somebody asked the run to stop.
[[nodiscard]] bool interrupted();

}  // namespace slope::tools
