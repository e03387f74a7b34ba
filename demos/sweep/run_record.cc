#include "sweep/run_record.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace dgd_demos {
namespace {

using nlohmann::json;
using Status = RunRecord::Status;

constexpr const char* kNever = "never";

// JSON has neither infinity nor NaN.
json Encode(double value) {
  if (std::isnan(value)) return nullptr;
  if (std::isinf(value)) return kNever;
  return value;
}

double Decode(const json& value) {
  if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (value == kNever) return std::numeric_limits<double>::infinity();
  return value.get<double>();
}

Status StatusNamed(const std::string& name) {
  for (const Status status : {Status::kDone, Status::kLost, Status::kFailed}) {
    if (name == NameOf(status)) return status;
  }
  throw std::runtime_error("no status: " + name);
}

}  // namespace

const char* NameOf(Status status) {
  switch (status) {
    case Status::kDone:
      return "done";
    case Status::kLost:
      return "lost";
    case Status::kFailed:
      break;
  }
  return "failed";
}

std::string ToLine(const RunRecord& record) {
  json figures = json::object();
  for (std::size_t i = 0; i < record.figures.size(); ++i) figures[Figures()[i].key] = Encode(record.figures[i]);
  return json{{"run", record.number},
              {"status", NameOf(record.status)},
              {"message", record.message},
              {"build_type", record.build_type},
              {"figures", figures}}
      .dump(-1, ' ', false, json::error_handler_t::replace);
}

RunRecord ParseRunRecord(std::string_view line) try {
  const json object = json::parse(line);
  RunRecord record{
      object.at("run"), StatusNamed(object.at("status")), object.at("message"), object.at("build_type"), {}};
  if (record.status == Status::kFailed) return record;
  for (const Figure& figure : Figures()) record.figures.push_back(Decode(object.at("figures").at(figure.key)));
  return record;
} catch (const json::exception&) {  // Its text quotes the line, and names no place in it that helps.
  throw std::runtime_error("no complete record of a run");
}

}  // namespace dgd_demos
