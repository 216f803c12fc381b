#pragma once

#include <tbb/parallel_for.h>

#include <atomic>
#include <cstddef>
#include <thread>

namespace slope::seepage {

// Up to so many indices are done before a second thread is awake: of loops over particles, and of those that take a few
// operations on each entry only.
constexpr std::size_t few = 100, few_products = 16 * 1024;

// Calls body(i) once for each i < n, on up to so many threads and in no order: what one call writes no other may touch.
// The calling thread waits for no thread that has not come to help, so that a busy machine costs little. Up to
// `alone` indices it takes alone.
template <class Body>
void for_each_index(std::size_t n, int threads, const Body& body, std::size_t alone = few) {
  constexpr std::size_t parts_per_thread = 4;  // threads that have less to do take more of them
  if (threads <= 1 || n <= alone) {
    for (std::size_t i = 0; i < n; ++i) body(i);
    return;
  }
  const std::size_t parts = parts_per_thread * static_cast<std::size_t>(threads);
  std::atomic<std::size_t> next{0};
  const std::thread::id caller = std::this_thread::get_id();
  tbb::parallel_for(
      0, threads,
      [&](int) {
        for (std::size_t k = next++; k < parts; k = next++) {
          const std::size_t end = (k + 1) * n / parts;
          for (std::size_t i = k * n / parts; i < end; ++i) body(i);
        }
        // gives up a core that others want now, not in the middle of the next part
        if (std::this_thread::get_id() != caller) std::this_thread::yield();
      },
      tbb::simple_partitioner{});
}

}  // namespace slope::seepage
