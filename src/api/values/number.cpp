// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "findspace/number.h"

#include <fmt/format.h>

#include <cmath>

#include "api/values/region_data.h"
#include "api/values/shape_data.h"
#include "exact/number/real_text.h"
#include "findspace/error.h"
#include "formula/language/text.h"

namespace findspace {

Number::Number(double value) : text_(fmt::format("{}", value)) {
  if (!std::isfinite(value)) throw Error(ErrorCode::kBadValue, "a number must be finite");
}

namespace {

/// A decimal, or a fraction of two.
exact::Real value_of(const std::string& text) {
  const std::size_t slash = text.find('/');
  const exact::Real numerator = exact::Real::parse_decimal(std::string_view(text).substr(0, slash));
  if (slash == std::string::npos) return numerator;
  const exact::Real denominator = exact::Real::parse_decimal(std::string_view(text).substr(slash + 1));
  if (denominator.sign() == 0) throw Error(ErrorCode::kSyntax, fmt::format("'{}' is divided by 0", text));
  return numerator / denominator;
}

std::weak_ordering ordering(int sign) {
  return sign < 0 ? std::weak_ordering::less : sign > 0 ? std::weak_ordering::greater : std::weak_ordering::equivalent;
}

}  // namespace

double Number::value() const { return value_of(text_).to_double(); }
std::weak_ordering operator<=>(const Number& a, const Number& b) {
  return ordering(compare(value_of(a.text_), value_of(b.text_)));
}

namespace api {

exact::Real real_of(const Number& number) { return value_of(number.text()); }

plane::Grid grid_of(const Grid& grid) {
  static const std::string kUsual = Grid{}.step.text();
  static const plane::Grid usual(exact::Real::parse_decimal(kUsual));
  if (grid.step.text() == kUsual) return usual;
  exact::Real step = real_of(grid.step);
  if (step.sign() <= 0) throw Error(ErrorCode::kBadValue, "the step of a grid must be more than 0");
  return plane::Grid(std::move(step));
}

Grid public_grid(const plane::Grid& grid) { return {formula::decimal_text(grid.step())}; }

}  // namespace api

double Exact::value() const { return data_->value.to_double(); }

std::string Exact::text() const {
  exact::RealWriter writer;
  std::string text = writer.text(data_->value);
  return text.starts_with('#') ? "~" + fmt::format("{}", value()) : text;
}

std::string Exact::full_text() const {
  exact::RealWriter writer;
  const std::string text = writer.text(data_->value);
  std::string out;
  for (const std::string& definition : writer.definitions()) out += definition + "\n";
  return out + text;
}

Exact Exact::read(std::string_view full_text) {
  exact::RealReader reader;
  for (std::size_t end = full_text.find('\n'); end != std::string_view::npos; end = full_text.find('\n')) {
    reader.define(full_text.substr(0, end));
    full_text.remove_prefix(end + 1);
  }
  return Exact(std::make_shared<const Data>(Data{reader.read(full_text)}));
}

bool operator==(const Exact& a, const Exact& b) { return a.data_->value == b.data_->value; }

std::weak_ordering operator<=>(const Exact& a, const Exact& b) {
  return ordering(compare(a.data_->value, b.data_->value));
}

}  // namespace findspace
