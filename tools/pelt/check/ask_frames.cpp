#include "tools/pelt/check/ask_frames.hpp"

#include "tools/pelt/check/ordered_work.hpp"
#include "tools/pelt/output/progress.hpp"

#include <algorithm>
#include <memory>

namespace pelt::tools::check {

Result<void> ask_frames(const CheckPlan& plan, const FrameIndices& indices, std::uint32_t threads,
                        const std::function<Result<void>(const FrameAnswer& answer)>& use) {
  threads = detail::Workers::count_or_available(threads);
  const auto workers =
      static_cast<std::uint32_t>(std::clamp<std::size_t>(indices.count(), 1, threads));
  std::vector<std::unique_ptr<CheckQuery>> queries(workers);  // each made by its own thread
  output::Progress progress(indices.count());
  const auto ask = [&](std::uint32_t worker, std::size_t index, FrameAnswer& answer) {
    std::unique_ptr<CheckQuery>& query = queries[worker];
    if (!query) query = std::make_unique<CheckQuery>(plan, threads / workers);
    return query->ask(indices.begin + index, answer);
  };
  const auto pass_on = [&](const FrameAnswer& answer) {
    progress.advance();
    return use(answer);
  };
  return OrderedWork<FrameAnswer>(indices.count(), workers, ask, pass_on).run();
}

}  // namespace pelt::tools::check
