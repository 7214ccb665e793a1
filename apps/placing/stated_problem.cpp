// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "placing/stated_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <optional>

#include "findspace/error.h"
#include "findspace/text.h"
#include "placing/packing_report.h"

namespace findspace::app {
namespace {

struct Drawing {
  std::filesystem::path file;
  int count = 1;
};

/// Whether shapes of that dimension are read from such a file.
bool has_shapes(const std::string& word, int dimension) {
  std::string ending = std::filesystem::path(word).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::vector<std::string> known = drawing_endings(dimension);
  return std::find(known.begin(), known.end(), ending) != known.end();
}
bool is_drawing(const std::string& word) { return has_shapes(word, 2); }

constexpr int kMostCopies = 1000000;

/// "x12"
std::optional<int> count_of(const std::string& word) {
  const bool digits = word.find_first_not_of("0123456789", 1) == std::string::npos;
  if (word.size() < 2 || word[0] != 'x' || !digits) return std::nullopt;
  int count = 0;
  const auto [end, error] = std::from_chars(word.data() + 1, word.data() + word.size(), count);
  if (error != std::errc{} || count > kMostCopies)
    throw Error(ErrorCode::kUsage, fmt::format("{}: a count is from 0 to {}", word, kMostCopies));
  return count;
}

[[noreturn]] void refuse_word(const std::string& word) {
  if (count_of(word)) throw Error(ErrorCode::kUsage, fmt::format("{}: a count follows a drawing", word));
  throw Error(ErrorCode::kUsage, fmt::format("{}: a drawing ({}) and how many of it are meant, such as bracket.dxf "
                                             "x12; a problem in JSON stands alone",
                                             printable(word), fmt::join(drawing_endings(2), " ")));
}

/// Counts of the same file are added.
std::vector<Drawing> added_up(const std::vector<Drawing>& named) {
  std::vector<Drawing> result;
  for (const Drawing& drawing : named) {
    const auto same = [&](const Drawing& other) { return other.file == drawing.file; };
    const auto known = std::find_if(result.begin(), result.end(), same);
    if (known == result.end())
      result.push_back(drawing);
    else if ((known->count += drawing.count) > kMostCopies)
      throw Error(ErrorCode::kUsage,
                  fmt::format("{}: its counts together are above {}", drawing.file.string(), kMostCopies));
  }
  return result;
}

std::vector<Drawing> drawings_of(const std::vector<std::string>& words) {
  std::vector<Drawing> result;
  bool counted = true;
  for (const std::string& word : words) {
    if (is_drawing(word)) {
      if (printable(word) != word)
        throw Error(ErrorCode::kUsage,
                    fmt::format("{}: parts are called as their files, and this name is not UTF-8", printable(word)));
      result.push_back({std::filesystem::path(word).lexically_normal(), 1});
      counted = false;
    } else if (const std::optional<int> count = count_of(word); count && !counted) {
      result.back().count = *count;
      counted = true;
    } else {
      refuse_word(word);
    }
  }
  return added_up(result);
}

/// The name of a part: that of its file, with its folder where two files are called so.
std::string name_of(const Drawing& drawing, const std::vector<Drawing>& all) {
  const auto same = [&](const Drawing& other) { return other.file.stem() == drawing.file.stem(); };
  return (std::count_if(all.begin(), all.end(), same) > 1 ? drawing.file : drawing.file.stem()).string();
}

std::string item_json(const Drawing& drawing, const std::string& name, const Options& o) {
  std::string file = fmt::format(R"("file": {}, "parts": "outlines")", json_string(drawing.file.string()));
  if (o.layer) file += fmt::format(", \"layer\": {}", json_string(*o.layer));
  const std::string angles = json_list(o.angles, [](const std::string& angle) { return json_string(angle); });
  return fmt::format(
      "{{\"id\": {}, \"demand\": {}, \"allowed_orientations\": {}, \"mirrored\": {}, \"tilt\": {}, \"shape\": {{{}}}}}",
      json_string(name), drawing.count, angles, o.mirrored, json_string(o.tilt.value_or("0")), file);
}

/// "600,400", as many as are needed.
std::string sheet_json(const std::string& size) {
  const std::size_t comma = size.find(',');
  return fmt::format(R"("sheets": [{{"id": "sheet", "count": {}, "width": {}, "height": {}}}])", kMostCopies,
                     json_string(size.substr(0, comma)), json_string(size.substr(comma + 1)));
}

StatedProblem drawn_problem(const std::vector<std::string>& words, const Options& o) {
  const std::vector<Drawing> drawings = drawings_of(words);
  if (o.height.has_value() == o.sheet.has_value())
    throw Error(ErrorCode::kUsage, "drawings are packed into a strip (--height H) or onto sheets (--sheet W,H)");
  StatedProblem result{{}, {}, true};
  std::string items;
  for (const Drawing& drawing : drawings) {
    const std::string name = name_of(drawing, drawings);
    items += (items.empty() ? "" : ",\n ") + item_json(drawing, name, o);
    result.name += (result.name.empty() ? "" : ", ") + name;
  }
  const std::string container = o.sheet ? sheet_json(*o.sheet) : "\"strip_height\": \"0\"";
  result.text = fmt::format("{{\"name\": {}, \"unit\": {}, {},\n\"items\": [\n {}]}}\n", json_string(result.name),
                            json_string(o.unit.value_or("mm")), container, items);
  return result;
}

/// Without the line and column of the problem that was made of drawings: nobody wrote that. Names may have brackets.
Error without_made_place(const Error& e, const std::string& name) {
  std::string place = e.place();
  const std::string made = fmt::format(" ({}:", name);
  const std::size_t from = place.find(made),
                    to = from == std::string::npos ? from : place.find(')', from + made.size());
  if (to == std::string::npos) return e;
  Error out(e.code(), e.message(), place.erase(from, to + 1 - from));
  for (const auto& [x, y] : e.geometry()) out.at(x, y);
  return out;
}

}  // namespace

std::vector<std::string> files_among(const std::vector<std::string>& words) {
  std::vector<std::string> files;
  for (const std::string& word : words)
    if (!count_of(word)) files.push_back(word);
  return files;
}

StatedProblem stated_problem(const std::vector<std::string>& words, const Options& options) {
  if (is_drawing(words[0]) || words.size() > 1) return drawn_problem(words, options);
  if (has_shapes(words[0], 3)) refuse_word(words[0]);
  if (options.sheet || !options.angles.empty() || options.mirrored || options.tilt || options.unit || options.layer)
    throw Error(
        ErrorCode::kUsage,
        "--sheet, --angles, --tilt, --mirrored, --unit and --layer are for drawings; a problem says them itself");
  return {read_text(words[0], options.input_limit), words[0]};
}

Packing stated_packing(const StatedProblem& stated, const Options& options) {
  PackReading asked = pack_reading(options, stated.name);
  if (stated.drawn) {
    asked.folder = std::filesystem::current_path();
    asked.read.files = true;  // those that are named
    asked.read.root.clear();
  }
  try {
    return Packing::json(stated.text, asked);
  } catch (const Error& e) {
    if (!stated.drawn) throw;
    throw without_made_place(e, stated.name);
  }
}

SolidPacking stated_solids(const StatedProblem& stated, const Options& options) {
  if (options.height)
    throw Error(ErrorCode::kUsage, "--height is of strips in the plane; in space the height is sought", stated.name);
  return SolidPacking::json(stated.text, pack_reading(options, stated.name));
}

}  // namespace findspace::app
