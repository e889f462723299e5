#include <taut/lumped/run_all.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace taut::lumped
{
void run_all(const std::size_t n, const std::function<void(std::size_t)>& task,
             unsigned int threads)
{
  if (threads == 0)
    threads = std::max(1u, std::thread::hardware_concurrency());
  std::atomic<std::size_t> next{0};
  const auto work = [&]
  {
    try
    {
      for (std::size_t i = next++; i < n; i = next++)
        task(i);
    }
    catch (...)
    {
      next = n;
      throw;
    }
  };
  std::vector<std::future<void>> others;
  for (std::size_t i = 1; i < std::min<std::size_t>(threads, n); ++i)
    others.push_back(std::async(std::launch::async, work));
  std::exception_ptr failure;
  const auto keep = [&](const auto& part)
  {
    try
    {
      part();
    }
    catch (...)
    {
      if (!failure)
        failure = std::current_exception();
    }
  };
  keep(work);
  for (auto& other : others)
    keep([&] { other.get(); });
  if (failure)
    std::rethrow_exception(failure);
}
} // namespace taut::lumped
