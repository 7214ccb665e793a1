// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/number/real_text.h"

#include "exact/number/real_node.h"
#include "findspace/error.h"

namespace findspace::exact {
namespace {

using detail::Access;
using detail::Node;
using detail::NodeKind;
using detail::Quadratic;

std::string closed_text(const Quadratic& c) {
  const std::string over = c.q == 1 ? "" : "/" + c.q.get_str();
  if (c.rational()) return c.p.get_str() + over;
  std::string root = (c.r == 1 ? "" : c.r == -1 ? "-" : c.r.get_str() + "*") + "sqrt(" + c.n.get_str() + ")";
  if (sgn(c.p) == 0) return root + over;
  std::string sum = c.p.get_str() + (sgn(c.r) > 0 ? "+" : "") + root;
  return over.empty() ? sum : "(" + sum + ")" + over;
}

/// Without a definition: nothing where the number is held as an operation.
std::string plain_text(const Real& x) {
  const Node* node = Access::node(x);
  if (!node) {
    const detail::Small small = Access::small(x);
    Quadratic value = detail::quadratic_of(small.p);
    value.q = small.q;
    return closed_text(value);
  }
  return is_closed(*node) ? closed_text(closed(*node)) : "";
}

/// A number as an operand.
std::string bracketed(const std::string& text) {
  return text.find_first_of("+-/*") == std::string::npos ? text : "(" + text + ")";
}

std::string operation_text(NodeKind kind, const std::string& a, const std::string& b) {
  switch (kind) {
    case NodeKind::kNeg:
      return "-" + bracketed(a);
    case NodeKind::kSqrt:
      return "sqrt(" + a + ")";
    case NodeKind::kAdd:
      return bracketed(a) + "+" + bracketed(b);
    case NodeKind::kSub:
      return bracketed(a) + "-" + bracketed(b);
    case NodeKind::kMul:
      return bracketed(a) + "*" + bracketed(b);
    default:
      return bracketed(a) + "/" + bracketed(b);
  }
}

class Parser {
 public:
  Parser(std::string_view text, const std::vector<Real>& defined) : text_(text), defined_(defined) {}

  Real all() {
    Real value = sum();
    if (at_ != text_.size()) fail("an operator or the end");
    return value;
  }

 private:
  static constexpr int kMostDeep = 64;

  [[noreturn]] void fail(const std::string& wanted) const {
    throw Error(ErrorCode::kSyntax, "an exact number '" + std::string(text_.substr(0, 60)) + "': " + wanted +
                                        " was expected at character " + std::to_string(at_ + 1));
  }
  bool take(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  std::string_view digits() {
    const std::size_t from = at_;
    while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') ++at_;
    if (at_ == from) fail("a digit");
    return text_.substr(from, at_ - from);
  }

  Real sum() {
    Real value = product();
    while (at_ < text_.size()) {
      if (take('+'))
        value += product();
      else if (take('-'))
        value -= product();
      else
        break;
    }
    return value;
  }

  Real product() {
    Real value = factor();
    while (at_ < text_.size()) {
      if (take('*'))
        value *= factor();
      else if (take('/'))
        value /= factor();
      else
        break;
    }
    return value;
  }

  Real in_brackets() {
    Real value = sum();
    if (!take(')')) fail("')'");
    return value;
  }

  Real factor() {
    if (++depth_ > kMostDeep) fail("something less deep");
    Real value = simple();
    --depth_;
    return value;
  }

  Real simple() {
    if (take('-')) return -factor();
    if (take('(')) return in_brackets();
    if (take('#')) return definition();
    if (text_.substr(at_, 5) == "sqrt(") {
      at_ += 5;
      return sqrt(in_brackets());
    }
    return Real::parse_decimal(digits());
  }

  Real definition() {
    const std::string_view number = digits();
    const std::size_t k = number.size() < 10 ? std::stoul(std::string(number)) : defined_.size();
    if (k >= defined_.size()) fail("a number defined before");
    return defined_[k];
  }

  std::string_view text_;
  const std::vector<Real>& defined_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

std::string RealWriter::text(const Real& x) {
  std::string plain = plain_text(x);
  if (!plain.empty()) return plain;
  // Operands before what is made of them, without recursion: graphs may be deep.
  const auto known = [&](const Real& r) { return known_.count(Access::node(r)) > 0 || !plain_text(r).empty(); };
  const auto name = [&](const Real& r) {
    const auto at = known_.find(Access::node(r));
    return at == known_.end() ? plain_text(r) : "#" + std::to_string(at->second);
  };
  std::vector<Real> todo{x};
  while (!todo.empty()) {
    const Real top = todo.back();
    if (known(top)) {
      todo.pop_back();
      continue;
    }
    if (Access::node(top)->kind == NodeKind::kPolynomialRoot) {
      throw Error(ErrorCode::kUnsupported, "a root of a polynomial has no text");
    }
    const detail::OperationNode& node = detail::operation(*Access::node(top));
    const bool unary = detail::is_unary(node.kind);
    const bool ready = known(node.a) && (unary || known(node.b));
    if (!ready) {
      if (!known(node.a)) todo.push_back(node.a);
      if (!unary && !known(node.b)) todo.push_back(node.b);
      continue;
    }
    todo.pop_back();
    known_.emplace(Access::node(top), definitions_.size());
    definitions_.push_back(operation_text(node.kind, name(node.a), unary ? "" : name(node.b)));
    kept_.push_back(top);
  }
  return name(x);
}

Real RealReader::read(std::string_view text) const { return Parser(text, defined_).all(); }

}  // namespace findspace::exact
