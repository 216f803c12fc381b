#pragma once

#include <tbb/parallel_for.h>

#include <atomic>
#include <cstddef>
#include <thread>

namespace slope::solid {

// Calls visit(k) once for each part k < parts, on up to so many threads and in no order: what one call writes no other
// may touch. The calling thread waits for no thread that has not come to help, so that a busy machine costs little.
template <class Visit>
void share_out(std::size_t parts, int threads, const Visit& visit) {
  if (threads <= 1) {
    for (std::size_t k = 0; k < parts; ++k) visit(k);
    return;
  }
  std::atomic<std::size_t> next{0};
  const std::thread::id caller = std::this_thread::get_id();
  tbb::parallel_for(
      0, threads,
      [&](int) {
        for (std::size_t k = next++; k < parts; k = next++) visit(k);
        // gives up a core that others want now, not in the middle of the next part
        if (std::this_thread::get_id() != caller) std::this_thread::yield();
      },
      tbb::simple_partitioner{});
}

// Calls body(i) once for each i < n, like share_out().
template <class Body>
void for_each_index(std::size_t n, int threads, const Body& body) {
  constexpr std::size_t few = 100;             // are done before a second thread is awake
  constexpr std::size_t parts_per_thread = 4;  // threads that have less to do take more of them
  const std::size_t parts = threads <= 1 || n <= few ? 1 : parts_per_thread * static_cast<std::size_t>(threads);
  share_out(parts, parts == 1 ? 1 : threads, [&](std::size_t k) {
    const std::size_t end = (k + 1) * n / parts;
    for (std::size_t i = k * n / parts; i < end; ++i) body(i);
  });
}

}  // namespace slope::solid
