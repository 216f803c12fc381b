#pragma once

#include <vtkLogger.h>

namespace slope::tools {

/// While it lives, VTK keeps its messages to itself; what went wrong is told by an exception.
class QuietVtk {
 public:
  QuietVtk() : before_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~QuietVtk() { vtkLogger::SetStderrVerbosity(before_); }
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

 private:
  vtkLogger::Verbosity before_;
};

}  // namespace slope::tools
