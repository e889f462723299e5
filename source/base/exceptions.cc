#include <taut/base/exceptions.h>

namespace taut
{
namespace
{
std::string compose(const std::string& message, const std::string& file,
                    const unsigned int line, const std::string& key)
{
  std::string text = file;
  if (line > 0)
    text += ":" + std::to_string(line);
  if (!text.empty())
    text += ": ";
  if (!key.empty())
    text += "'" + key + "': ";
  return text + message;
}
} // namespace

BadInput::BadInput(const std::string& message)
    : std::runtime_error(message), message_(message)
{
}

BadInput::BadInput(const std::string& message, const std::string& file,
                   const unsigned int line, const std::string& key)
    : std::runtime_error(compose(message, file, line, key)), message_(message),
      file_(file), line_(line), key_(key)
{
}
} // namespace taut
