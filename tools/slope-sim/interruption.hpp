#pragma once

namespace slope::tools {

/// From now on the first SIGINT or SIGTERM only asks the run to stop; a second one ends the program at once.
void catch_interruptions();

/// Whether somebody asked the run to stop.
[[nodiscard]] bool interrupted();

}  // namespace slope::tools
