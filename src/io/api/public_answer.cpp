// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <findspace/answer.h>
#include <findspace/error.h>
#include <fmt/format.h>

#include "io/question/answer_data.h"

namespace findspace {

Answer::Found Answer::found() const { return data_->found; }
std::string Answer::text(const Telling& telling) const { return data_->text(telling); }
std::string Answer::json(const Telling& telling) const { return data_->json(telling); }
std::vector<std::string> Answer::endings() const {
  std::vector<std::string> out{".json"};
  for (const auto& [ending, make] : data_->files) out.push_back(ending);
  return out;
}
Region::Drawn Answer::file(std::string_view ending, const Telling& telling) const {
  if (ending == ".json") return {json(telling), {}};
  const auto found = data_->files.find(ending);
  if (found == data_->files.end())
    throw Error(ErrorCode::kUnsupported,
                fmt::format("the ending '{}' is none of {}", ending, fmt::join(endings(), " ")));
  return found->second(telling);
}
void Answer::write(std::string_view ending, const std::function<void(std::string_view)>& part,
                   const Telling& telling) const {
  if (ending == ".json" && data_->json_parts) return data_->json_parts(telling, part);
  part(file(ending, telling).text);
}
bool Answer::written_in_parts() const { return bool(data_->json_parts); }
const std::vector<std::string>& Answer::notes() const { return data_->notes; }
Place Answer::at() const {
  Place out;
  for (const exact::Real& c : data_->at) out.push_back(c.to_double());
  return out;
}
Check Answer::check() const {
  if (!data_->check) throw Error(ErrorCode::kBadValue, "this is no answer to a check");
  return data_->check();
}
std::optional<NearestPlace> Answer::nearest() const { return data_->nearest ? data_->nearest() : std::nullopt; }
std::vector<Measured> Answer::measured() const { return data_->measured ? data_->measured() : std::vector<Measured>(); }

std::optional<RegionBounds> Answer::region() const {
  return data_->region ? std::optional(data_->region()) : std::nullopt;
}
std::optional<SpaceRegion> Answer::space_region() const {
  return data_->space_region ? std::optional(data_->space_region()) : std::nullopt;
}
bool Answer::sampled() const { return data_->sampled; }
std::optional<LineMap> Answer::on_lines() const {
  return data_->line_map ? std::optional(data_->line_map()) : std::nullopt;
}
std::optional<Surface> Answer::surface() const {
  return data_->surface ? std::optional(data_->surface()) : std::nullopt;
}
std::optional<Optimum> Answer::best() const { return data_->best ? std::optional(data_->best()) : std::nullopt; }
std::vector<Interval> Answer::intervals() const {
  return data_->intervals ? data_->intervals() : std::vector<Interval>();
}
std::vector<Interval> Answer::possible() const { return data_->possible ? data_->possible() : std::vector<Interval>(); }
std::optional<PoseMap> Answer::poses() const { return data_->poses ? std::optional(data_->poses()) : std::nullopt; }

std::optional<Explanation> Answer::explanation() const { return data_->explanation; }
std::optional<Placement> Answer::placement() const {
  return data_->placement ? std::optional(data_->placement()) : std::nullopt;
}

}  // namespace findspace
