// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The benchmark: one run, every contender on the same input, medians and ratios as a Markdown table on standard output
// (and as JSON with --json FILE). bench/README.md says what the columns mean and how results are kept.
//
// usage: findspace_bench [--only TEXT] [--limit SECONDS] [--json FILE]
#include <malloc.h>
#include <sys/utsname.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "contenders.h"
#include "measure.h"
#include "plane/base/parallel.h"

namespace bench {
namespace {

using Job = std::function<std::size_t()>;

// One input: for every contender the job on it, empty where it does not do that.
struct Row {
  std::string name;
  std::function<Job(const Contender&)> job;
};
struct Table {
  std::string title;
  std::vector<Row> rows;
};

Row sum_row(std::string name, Polygon a, Polygon b) {
  return {std::move(name), [a = std::move(a), b = std::move(b)](const Contender& c) -> Job {
            if (c.sum_alone) return c.sum_alone(a, b);
            return c.sum ? Job([&] { return c.sum(a, b); }) : Job();
          }};
}

// Every ordered pair of parts, or every `step`-th one.
Row pairs_row(const std::string& instance, std::size_t step) {
  auto parts = nesting(instance);
  std::string count = std::to_string((parts.size() * parts.size() + step - 1) / step);
  return {instance + ", " + count + " pairs", [parts = std::move(parts), step](const Contender& c) -> Job {
            if (!c.sum) return {};
            if (c.pairs) return [&] { return c.pairs(parts, step); };
            return [&] {
              std::size_t total = 0, n = parts.size();
              for (std::size_t k = 0; k < n * n; k += step) total += c.sum(parts[k / n], parts[k % n]);
              return total;
            };
          }};
}

Row offset_row(const std::string& name, const Polygon& a, double r) {
  return {name + (r > 0 ? " out" : " in"),
          [a, r](const Contender& c) -> Job { return c.offset ? Job([&] { return c.offset(a, r); }) : Job(); }};
}

Table sums() {
  Table table{"Sums of two polygons (the sign map at level 0), ms", {}};
  for (int n : {10, 30, 100, 300, 1000}) {
    std::string text = std::to_string(n);
    table.rows.push_back(sum_row("smooth " + text, smooth(n, 1), smooth(n, 2)));
    table.rows.push_back(sum_row("star " + text, star(n, 1), star(n, 2)));
    table.rows.push_back(sum_row("comb " + text, comb(n, 1, 0), comb(n, 2, 127)));
  }
  table.rows.push_back(sum_row("smooth 1000 x star 10", smooth(1000, 1), star(10, 2)));
  table.rows.push_back(sum_row("star 1000 x smooth 10", star(1000, 1), smooth(10, 2)));
  table.rows.push_back(sum_row("comb 1000 x comb 10", comb(1000, 1, 0), comb(10, 2, 127)));
  return table;
}

Table real_parts() {
  Table table{"All pairs of parts of a nesting instance, ms in all", {}};
  for (const char* name : {"swim", "shirts", "trousers", "albano"}) table.rows.push_back(pairs_row(name, 1));
  table.rows.push_back(pairs_row("gardeyn9", 37));
  return table;
}

Table offsets() {
  Table table{"Offsets, ms", {}};
  for (int n : {10, 30, 100, 300, 1000, 3000}) {
    for (double r : {50000., -50000.}) {
      table.rows.push_back(offset_row("smooth " + std::to_string(n), smooth(n, 1), r));
      table.rows.push_back(offset_row("star " + std::to_string(n), star(n, 1), r));
    }
  }
  return table;
}

Table overlays() {
  Table table{"Union of polygons, ms", {}};
  for (int count : {10, 100, 1000}) {
    for (double depth : {0.5, 3.0}) {
      auto all = litter(count, depth, 7);
      std::string name = std::to_string(count) + " polygons of 10 vertices, " + (depth < 1 ? "sparse" : "dense");
      table.rows.push_back(
          {name, [all](const Contender& c) -> Job { return c.unite ? Job([&] { return c.unite(all); }) : Job(); }});
    }
  }
  return table;
}

std::vector<Contender> contenders() {
  std::vector<Contender> all = ours();
  auto add = [&](std::vector<Contender> more) { all.insert(all.end(), more.begin(), more.end()); };
#ifdef FINDSPACE_WITH_CGAL
  add(cgal_rivals());
#endif
#ifdef FINDSPACE_WITH_CLIPPER
  add(clipper_rivals());
#endif
#ifdef FINDSPACE_WITH_GEOS
  add(geos_rivals());
#endif
  return all;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value < 10 ? "%.3g" : "%.0f", value);
  return text;
}

std::string cell(const Measurement& m, double limit_s) {
  using enum Measurement::Outcome;
  switch (m.outcome) {
    case kNone:
      return "–";
    case kTooLong:
      return "> " + number(limit_s * 1000);
    case kFailed:
      return "failed";
    case kDone:
      return number(m.median_ms) + " (" + number(m.peak_mib) + ")";
  }
  return "";
}

std::string ratio(const Measurement& mine, const Measurement& other, double limit_s) {
  using enum Measurement::Outcome;
  if (mine.outcome != kDone || (other.outcome != kDone && other.outcome != kTooLong)) return "–";
  if (other.outcome == kTooLong) return "> " + number(limit_s * 1000 / mine.median_ms);
  return number(other.median_ms / mine.median_ms);
}

std::string first_line(const char* file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(key, 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

nlohmann::json machine() {
  utsname name{};
  uname(&name);
  char date[32];
  std::time_t now = std::time(nullptr);
  std::strftime(date, sizeof date, "%Y-%m-%d", std::gmtime(&now));
  return {{"date", date},
          {"processor", first_line("/proc/cpuinfo", "model name")},
          {"cores", std::thread::hardware_concurrency()},
          {"system", name.sysname + std::string(" ") + name.machine},
          {"compiler", __VERSION__}};
}

struct Options {
  std::string only, json;
  double limit_s = 60;
};

bool has_column(const Table& table, const Contender& c) { return bool(table.rows.front().job(c)); }

// Runs one table row by row and prints it as it grows.
nlohmann::json run(const Table& table, const std::vector<Contender>& all, const Options& options) {
  std::vector<const Contender*> columns;
  for (const Contender& c : all) {
    if (has_column(table, c) || &c == &all.front()) columns.push_back(&c);
  }
  std::cout << "\n## " << table.title << " (peak MiB)\n\n| input |";
  for (const Contender* c : columns) std::cout << ' ' << c->name << " |";
  for (std::size_t k = 1; k < columns.size(); ++k) std::cout << ' ' << columns[k]->name << " : ours |";
  std::cout << "\n|---|";
  for (std::size_t k = 1; k < 2 * columns.size(); ++k) std::cout << "---:|";
  std::cout << std::endl;

  nlohmann::json rows = nlohmann::json::array();
  for (const Row& row : table.rows) {
    if (!options.only.empty() && (table.title + " " + row.name).find(options.only) == std::string::npos) continue;
    std::vector<Measurement> found;
    for (const Contender* c : columns) found.push_back(measure(row.job(*c), options.limit_s));
    std::cout << "| " << row.name << " |";
    for (const Measurement& m : found) std::cout << ' ' << cell(m, options.limit_s) << " |";
    for (std::size_t k = 1; k < found.size(); ++k)
      std::cout << ' ' << ratio(found[0], found[k], options.limit_s) << " |";
    std::cout << std::endl;
    nlohmann::json entry{{"input", row.name}};
    for (std::size_t k = 0; k < found.size(); ++k) {
      const Measurement& m = found[k];
      if (m.outcome == Measurement::Outcome::kNone) continue;
      if (m.outcome != Measurement::Outcome::kDone) {
        entry[columns[k]->name] = {{"outcome", m.outcome == Measurement::Outcome::kTooLong ? "too long" : "failed"}};
        continue;
      }
      entry[columns[k]->name] = {
          {"ms", m.median_ms}, {"runs", m.runs}, {"peak_mib", m.peak_mib}, {"result_vertices", m.result}};
    }
    rows.push_back(entry);
  }
  return {{"title", table.title}, {"rows", rows}};
}

Options parsed(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    std::string key = argv[i];
    if (i + 1 == argc || (key != "--only" && key != "--limit" && key != "--json")) {
      std::cerr << "usage: findspace_bench [--only TEXT] [--limit SECONDS] [--json FILE]\n";
      std::exit(2);
    }
    std::string value = argv[++i];
    if (key == "--only") options.only = value;
    if (key == "--json") options.json = value;
    if (key == "--limit") options.limit_s = std::stod(value);
  }
  return options;
}

/// Memory once given back stays with the process, as in a program that runs on; otherwise every large vector of the
/// measured loop is mapped anew. For all contenders alike.
void keep_memory() {
#ifdef __GLIBC__
  constexpr int kMost = 32 << 20;
  mallopt(M_MMAP_THRESHOLD, kMost);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  Options options = parsed(argc, argv);
  keep_memory();
  const findspace::plane::ThreadLimit one(1);
  auto all = contenders();
  nlohmann::json report = machine();
  report["limit_s"] = options.limit_s;
  std::cout << "# Benchmark, " << report["date"].get<std::string>() << "\n\n"
            << report["processor"].get<std::string>() << ", " << report["cores"] << " cores, "
            << report["system"].get<std::string>() << ", g++ " << report["compiler"].get<std::string>()
            << ". One thread each, medians of processor time (below 0.1 ms: by the clock); limit "
            << number(options.limit_s) << " s a measurement.\n";
  for (const Table& table : {sums(), real_parts(), offsets(), overlays()}) {
    report["tables"].push_back(run(table, all, options));
  }
  if (!options.json.empty()) std::ofstream(options.json) << report.dump(1) << '\n';
  return 0;
}

}  // namespace bench

int main(int argc, char** argv) { return bench::main(argc, argv); }
