#include <taut/base/exceptions.h>
#include <taut/base/formula.h>
#include <taut/base/nearest_name.h>
#include <taut/base/number_text.h>

#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace taut
{
namespace
{
/// Of a parser's error: what is wrong and what is allowed.
std::string explain(const mu::ParserError& error, const std::string& text,
                    std::vector<std::string> variables)
{
  variables.emplace_back("pi");
  std::string message =
      "cannot read the expression '" + text + "': " + error.GetMsg();
  if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN)
    message += " Of variables, " + suggest(error.GetToken(), variables);
  return message;
}
} // namespace

struct Formula::Parser
{
  std::string text;
  /// muParser reads the variables through pointers to these.
  std::vector<double> values;
  mu::Parser parser;
};

Formula::Formula(const std::string& text,
                 const std::vector<std::string>& variables)
    : parser_(std::make_unique<Parser>())
{
  constexpr double pi = 3.14159265358979323846;
  parser_->text = text;
  // Any value but one at which many functions are singular.
  parser_->values.assign(variables.size(), 0.7);
  try
  {
    parser_->parser.DefineConst("pi", pi);
    for (std::size_t i = 0; i < variables.size(); ++i)
      parser_->parser.DefineVar(variables[i], &parser_->values[i]);
    parser_->parser.SetExpr(text);
    parser_->parser.Eval();
  }
  catch (const mu::ParserError& error)
  {
    throw BadInput(explain(error, text, variables));
  }
}

Formula::~Formula() = default;
Formula::Formula(Formula&& other) noexcept = default;
Formula& Formula::operator=(Formula&& other) noexcept = default;

double Formula::operator()(const std::vector<double>& values) const
{
  std::copy(values.begin(), values.end(), parser_->values.begin());
  const double result = parser_->parser.Eval();
  if (!std::isfinite(result))
    throw BadInput("the expression '" + parser_->text + "' is " +
                   number_text(result));
  return result;
}

bool is_variable_name(const std::string& name)
{
  const auto is_part = [](const unsigned char c)
  { return std::isalnum(c) != 0 || c == '_'; };
  if (mu::Parser().GetFunDef().count(name) > 0)
    return false;
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0])) != 0 ||
      !std::all_of(name.begin(), name.end(), is_part))
    return false;
  try
  {
    const double value = 2.5;
    return Formula(name + " + 0", {name})({value}) == value;
  }
  catch (const BadInput&)
  {
    return false;
  }
}
} // namespace taut
