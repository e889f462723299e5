#include <taut/base/nearest_name.h>

#include <algorithm>
#include <cctype>

namespace taut
{
namespace
{
std::string to_lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](const unsigned char c) { return std::tolower(c); });
  return text;
}

/// Fewest insertions, deletions, replacements and swaps of neighbours that turn
/// `a` into `b`, no letter being edited twice.
std::size_t compute_distance(const std::string& a, const std::string& b)
{
  const std::size_t columns = b.size() + 1;
  std::vector<std::size_t> table((a.size() + 1) * columns);
  const auto cost = [&](const std::size_t i,
                        const std::size_t j) -> std::size_t&
  { return table[i * columns + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i)
    cost(i, 0) = i;
  for (std::size_t j = 0; j <= b.size(); ++j)
    cost(0, j) = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t replaced =
          cost(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
      cost(i, j) = std::min({cost(i - 1, j) + 1, cost(i, j - 1) + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        cost(i, j) = std::min(cost(i, j), cost(i - 2, j - 2) + 1);
    }
  return cost(a.size(), b.size());
}
} // namespace

std::string nearest_name(const std::string& name,
                         const std::vector<std::string>& known)
{
  const std::string lower_name = to_lower(name);
  std::string nearest;
  std::size_t smallest = name.size() / 2 + 1;
  for (const auto& candidate : known)
  {
    const auto distance = compute_distance(lower_name, to_lower(candidate));
    if (distance < smallest)
    {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string suggest(const std::string& name,
                    const std::vector<std::string>& known)
{
  std::string text = "known are: ";
  for (std::size_t i = 0; i < known.size(); ++i)
    text += (i == 0 ? "" : ", ") + known[i];
  if (known.empty())
    text += "none";
  const std::string nearest = nearest_name(name, known);
  if (!nearest.empty())
    text += "; did you mean '" + nearest + "'?";
  return text;
}
} // namespace taut
