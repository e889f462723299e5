#include <taut/base/exceptions.h>
#include <taut/io/case_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include <nlohmann/json.hpp>

namespace taut::io
{
namespace
{
using Json = nlohmann::json;

/// Turns the events of the JSON parser into entries. The parser has consumed
/// exactly the text up to the member's value when it reports the key, so
/// counting line ends up to there gives the line of the key.
class JsonScanner : public nlohmann::json_sax<Json>
{
public:
  JsonScanner(CaseText& text, const unsigned int& line)
      : text_(text), line_(line)
  {
  }

  bool key(std::string& key) override
  {
    key_ = tidy(key);
    key_line_ = line_;
    return true;
  }
  bool start_object(std::size_t) override
  {
    if (in_array_)
      refuse("an array holds numbers or names, not objects");
    if (++depth_ > 1)
    {
      open_.push_back(key_);
      text_.open_section(open_, key_line_);
    }
    return true;
  }
  bool end_object() override
  {
    if (--depth_ > 0)
      open_.pop_back();
    return true;
  }
  bool start_array(std::size_t) override
  {
    if (in_array_)
      refuse("an array holds numbers or names, not arrays");
    in_array_ = true;
    list_.clear();
    return true;
  }
  bool end_array() override
  {
    in_array_ = false;
    return take(list_);
  }
  bool null() override
  {
    refuse("null is no value");
  }
  bool boolean(bool value) override
  {
    return take(value ? "true" : "false");
  }
  bool number_integer(std::int64_t value) override
  {
    return take(std::to_string(value));
  }
  bool number_unsigned(std::uint64_t value) override
  {
    return take(std::to_string(value));
  }
  bool number_float(double, const std::string& digits) override
  {
    return take(digits);
  }
  bool string(std::string& value) override
  {
    return take(tidy(value));
  }
  bool binary(Json::binary_t&) override
  {
    refuse("binary data is no value");
  }
  bool parse_error(std::size_t, const std::string&,
                   const nlohmann::detail::exception& error) override
  {
    throw BadInput(fmt::format("this is not JSON: {}", error.what()),
                   text_.file(), line_, "");
  }

private:
  [[noreturn]] void refuse(const std::string& message) const
  {
    throw BadInput(message, text_.file(), key_line_, join(open_, key_));
  }
  bool take(const std::string& value)
  {
    if (depth_ == 0)
      refuse("a case is a JSON object");
    if (in_array_)
      list_ += (list_.empty() ? "" : ", ") + value;
    else
      text_.add({open_, key_, value, text_.file(), key_line_});
    return true;
  }

  CaseText& text_;
  const unsigned int& line_;
  SectionPath open_;
  std::string key_;
  unsigned int key_line_ = 0;
  unsigned int depth_ = 0;
  bool in_array_ = false;
  std::string list_;
};

/// Counts the line ends that pass.
class CountingIterator
{
public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* position, unsigned int& line)
      : position_(position), line_(&line)
  {
  }
  reference operator*() const
  {
    return *position_;
  }
  CountingIterator& operator++()
  {
    *line_ += *position_ == '\n' ? 1 : 0;
    ++position_;
    return *this;
  }
  bool operator==(const CountingIterator& other) const
  {
    return position_ == other.position_;
  }
  bool operator!=(const CountingIterator& other) const
  {
    return !(*this == other);
  }

private:
  const char* position_;
  unsigned int* line_;
};
} // namespace

void scan_json(const std::string& content, CaseText& text)
{
  unsigned int line = 1;
  JsonScanner scanner(text, line);
  const char* begin = content.data();
  Json::sax_parse(CountingIterator(begin, line),
                  CountingIterator(begin + content.size(), line), &scanner);
}
} // namespace taut::io
