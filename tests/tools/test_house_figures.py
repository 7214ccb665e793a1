# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
"""What tools/house_figures.py counts, and what it does not."""
import shutil
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
        self.assertEqual(rows["catches of `kUnsupported`"], "1 in 1 files (0 by `exact::tried`)")
        self.assertEqual(rows["catches of any `Error` that throw none"], "1")
        self.assertEqual(rows["equal names in anonymous namespaces of a folder"], "1 (most: 1, `src/plane/sum`)")

    def test_calls_that_catch_for_their_caller(self):
        self.write("src/plane/sum/other.cpp", """
void f() {
  auto a = exact::tried([&] { return g(h(1)); });
  return exact::tried([&] { return fail(1, ErrorCode::kSyntax); }, ErrorCode::kUnsupported);
  auto geometry = exact::tried([&] { return g(2); }, ErrorCode::kGeometry);
  tried_so_far(3);  // exact::tried([&] { return 1; })
}""")
        self.assertEqual(self.rows()["catches of `kUnsupported`"], "3 in 2 files (2 by `exact::tried`)")

    def test_flat_layers_and_comparison(self):
        status, text = said(house_figures, self.root, "--no-preprocessing", "--compare", self.root)
        self.assertEqual(status, 0)
        self.assertIn("| | before | now |", text)
        self.write("src/plane/flat.cpp", "")
        self.assertEqual(self.rows()["folders of src with files"], "3")

    def preprocessed(self, compiler, *options, configured_in=None):
        """The figures of the preprocessor for a file of one line that includes two of 200, one of them precompiled."""
        for name in ("common", "own"):
            self.write(f"src/{name}.h", "#pragma once\n" + "".join(f"extern int {name}_{k};\n" for k in range(200)))
        for name in ("big.cpp", "other.cpp"):
            self.write(f"src/plane/sum/{name}", '#include "common.h"\n#include "own.h"\nint one;\n')
        self.write("src/exact/number/real.cpp", '#include "common.h"\n')
        header = self.write("build/findspace_exact.dir/cmake_pch.hxx", '#include "common.h"\n')
        self.write("build/findspace_exact.dir/cmake_pch.hxx.pch", "never read\n")
        command = " ".join([compiler, f"-I{self.root}/src", *options, "-MD -MT $layer/x.o -MF x.d -o x.o -c x.cpp"]).replace("HEADER", header)
        if configured_in:
            self.write("build/CMakeCache.txt", f"CMAKE_HOME_DIRECTORY:INTERNAL={configured_in}\n")
            command = command.replace(self.root, configured_in)
        self.write("build/build.ninja", "rule cxx\n command = " + command + "\n" +
                   "".join(f"build {layer}.o: cxx {layer}.cpp\n layer = findspace_{layer}.dir\n" for layer in ("exact", "plane")))
        return [row[1] for row in house_figures.preprocessor_figures(self.root, "build")]

    def test_lines_after_the_precompiled_header_of_gcc(self):
        self.assertEqual(self.preprocessed("c++", "-Winvalid-pch -include HEADER"), ["401", "201"])

    def test_lines_of_a_checkout_that_had_another_path(self):
        self.assertEqual(self.preprocessed("c++", "-include HEADER", configured_in="/never/there"), ["401", "201"])
        self.assertEqual(house_figures.moved("/a/b/c /a/bc -I/a/b", "/a/b", "/d"), "/d/c /a/bc -I/d")

    @unittest.skipUnless(shutil.which("clang++"), "clang is not installed (tools/setup check)")
    def test_lines_after_the_precompiled_header_of_clang(self):
        options = "-Xclang -include-pch -Xclang HEADER.pch -Xclang -include -Xclang HEADER"
        self.assertEqual(self.preprocessed("clang++", options), ["401", "201"])

    def test_lines_without_a_precompiled_header(self):
        self.assertEqual(self.preprocessed("c++"), ["401", "401"])

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
