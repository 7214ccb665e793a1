# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""What tools/house_figures.py counts, and what it does not."""
import unittest

from small_tree import TreeTest, said

import house_figures

CLASS = """
struct Small { int a = f(1); int area() const { return g(a); } };
class Big final : public Base<int> {
 public:
  Big(int a) : a_(a) { run(); }
  Big(const Big&) = delete;
  ~Big();
  void one();  // not this(one)
  int two(std::function<void(int)> visit) const { if (a_) { return three(); } return 0; }
  template <class T> static T generic(T value);
  bool operator==(const Big&) const = default;
  bool operator<(const Big& other) const;
  using Text = std::string (*)(int);
  friend void stranger(Big&);
  enum class Kind { kA, kB };
  struct Inner { void hidden(); };
 private:
  std::vector<std::pair<int, int>> three();
  std::function<int(int)> call_;
  int a_ = compute(3), b_{compute(4)};
};
"""


BIG = """
void Big::one() {}
namespace {
constexpr double kTiny = 0x1p-40, kFactor = 0x1p-1;
int helper(int a) { return a; }
}
void f() { try { g(); } catch (const Error& e) { if (e.code() != ErrorCode::kUnsupported) throw; other(); } }
"""
OTHER = """
bool Big::operator<(const Big& b) const { return true; }
namespace {
struct Local { int helper(); };
int helper() { return 1; }
}
void f() { try { g(); } catch (const Error&) { return; } }
// 0x1p-30 catch (const Error&) {}
"""
WORDS = """# A heading of many words that does not count

One two `x = f(y)`, four. Five six?

    code of many words in a line

* An item
  of five words

| a cell |
|---|
| short |
"""


class HouseFigures(TreeTest):
    def setUp(self):
        super().setUp()
        self.write("README.md", "One two three.\n")
        self.write("docs/a.md", WORDS)
        self.write("src/plane/sum/big.h", CLASS)
        self.write("src/plane/sum/big.cpp", BIG)
        self.write("src/plane/sum/other.cpp", OTHER)
        self.write("src/exact/number/real.cpp", "constexpr double kUnit = 0x1p-53;\n")

    def rows(self):
        status, text = said(house_figures, self.root, "--no-preprocessing")
        self.assertEqual(status, 0)
        return dict(line.strip("| ").split(" | ") for line in text.splitlines()[2:])

    def test_table(self):
        rows = self.rows()
        self.assertEqual(rows["files a folder, largest"], "3 (`src/plane/sum`)")
        self.assertEqual(rows["methods a class, largest 1"], "5 (`Big`, 1 private, 3 files)")
        self.assertEqual(rows["methods a class, largest 2"], "1 (`Inner`, 0 private, 1 files)")
        self.assertEqual(rows["words a sentence, docs/a.md"], "3.7 (longest 5)")
        self.assertEqual(rows["hexadecimal margins outside src/exact"], "1 in 1 files")
        self.assertEqual(rows["catches of `kUnsupported`"], "1 in 1 files")
        self.assertEqual(rows["catches of any `Error` that throw none"], "1")
        self.assertEqual(rows["equal names in anonymous namespaces of a folder"], "1 (most: 1, `src/plane/sum`)")

    def test_flat_layers_and_comparison(self):
        status, text = said(house_figures, self.root, "--no-preprocessing", "--compare", self.root)
        self.assertEqual(status, 0)
        self.assertIn("| | before | now |", text)
        self.write("src/plane/flat.cpp", "")
        self.assertEqual(self.rows()["folders of src with files"], "3")

    def test_methods(self):
        body = CLASS[CLASS.index("Base<int> {") + 11:CLASS.rindex("}")]
        self.assertEqual(house_figures.methods("Big", house_figures.without_comments(body)),
                         [("one", False), ("two", False), ("generic", False), ("operator<", False), ("three", True)])

    def test_sentences(self):
        text = ("It is so (e.g. 1.5 mm long, see [there](a.md)).\nAnd then: this too!\n\n```sh\na b c d\n```\n"
                "1. First item\n2. Second item here\n")
        self.assertEqual([len(words) for words in house_figures.sentences(text)], [9, 4, 2, 3])


if __name__ == "__main__":
    unittest.main()
