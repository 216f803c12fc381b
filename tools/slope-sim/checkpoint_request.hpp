#pragma once

namespace slope::tools {

/// From now on SIGUSR1 asks the run for a checkpoint, and no longer ends the program.
void catch_checkpoint_requests();

/// Whether somebody asked for a checkpoint since the last call.
[[nodiscard]] bool checkpoint_requested();

}  // namespace slope::tools
