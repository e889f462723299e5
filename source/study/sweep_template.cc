#include "sweep_template.h"

#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>

#include <algorithm>

#include "sweep_number.h"

namespace taut::study
{
Template::Template(const std::string& text, const TemplateNames& names)
{
  std::size_t position = 0;
  while (position < text.size())
  {
    const std::size_t open = text.find_first_of("{}", position);
    if (open != position)
      pieces_.push_back({text.substr(position, open - position), {}, {}});
    if (open == std::string::npos)
      return;
    const std::size_t close = text.find_first_of("{}", open + 1);
    if (text[open] == '}' || close == std::string::npos || text[close] == '{')
      throw BadInput("a brace has no partner in '" + text +
                     "'; an expression stands as {expression}");
    add_brace(trim(text.substr(open + 1, close - open - 1)), names);
    position = close + 1;
  }
}

void Template::add_brace(const std::string& content, const TemplateNames& names)
{
  const auto name = std::find(names.texts.begin(), names.texts.end(), content);
  Piece piece;
  if (name != names.texts.end())
    piece.variable = name - names.texts.begin();
  else
    piece.formula = Formula(content, names.numbers);
  pieces_.push_back(std::move(piece));
}

std::string Template::fill(const TemplateValues& values) const
{
  std::string text;
  for (const Piece& piece : pieces_)
  {
    if (piece.variable)
      text += values.texts[*piece.variable];
    else if (piece.formula)
      text += make_number_text((*piece.formula)(values.numbers));
    else
      text += piece.literal;
  }
  return text;
}
} // namespace taut::study
