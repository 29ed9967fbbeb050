// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/view/frame_arrays.hpp"

#include "repose/core/errors.hpp"
#include "repose/run_folder/moments.hpp"
#include "repose/view/arrays.hpp"

#include <limits>

namespace repose {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t fixed_flag = 1;
constexpr std::uint32_t base_flag = 2;

void push(std::vector<float>& values, const Vec<2>& vector) {
  values.push_back(static_cast<float>(vector[0]));
  values.push_back(static_cast<float>(vector[1]));
}

/// Adds arrays in the precision of the message.
class Arrays {
 public:
  Arrays(ArrayMessage& message, Precision precision) : message_(message), packed_(precision == Precision::packed) {}

  template <class T>
  void add(const std::string& name, const std::vector<T>& values, std::size_t columns = 1) {
    if (packed_) {
      message_.add_packed(name, values, columns);
    } else {
      message_.add(name, values, columns);
    }
  }

  bool packed() const { return packed_; }

 private:
  ArrayMessage& message_;
  bool packed_;
};

void add_grains(Arrays& arrays, const OrderedGrains<2>& grains) {
  std::vector<std::uint32_t> id, flags, material;
  std::vector<float> position, velocity, spin, radius;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains->line[k];
    id.push_back(static_cast<std::uint32_t>(grains->id[k]));
    flags.push_back((grain.fixed() ? fixed_flag : 0) | (grains->base[k] != 0 ? base_flag : 0));
    material.push_back(grains->material[k]);
    push(position, grain.position);
    push(velocity, grain.velocity);
    spin.push_back(static_cast<float>(grain.rim_velocity / grain.radius));
    radius.push_back(static_cast<float>(grain.radius));
  }
  arrays.add("id", id);
  arrays.add("position", position, 2);
  arrays.add("velocity", velocity, 2);
  arrays.add("spin", spin);
  arrays.add("radius", radius);
  arrays.add("flags", flags);
  arrays.add("material", material);
}

void add_contacts(Arrays& arrays, const Moment<2>& moment, bool forces) {
  std::vector<std::uint32_t> pair, sliding;
  std::vector<float> normal, point, normal_force, tangential_force;
  const auto place = [&](std::int64_t id) { return static_cast<std::uint32_t>(*moment.grains.find(id)); };
  for (const auto& contact : moment.contacts.list) {
    const auto first = place(contact.first);
    pair.push_back(first);
    pair.push_back(contact.second >= 0 ? place(contact.second)
                                       : std::numeric_limits<std::uint32_t>::max() -
                                             static_cast<std::uint32_t>(wall_partner(contact.second)));
    push(normal, contact.normal);
    push(point, moment.grains->line[first].position - contact.normal * contact.first_lever);
    normal_force.push_back(static_cast<float>(contact.normal_force));
    tangential_force.push_back(static_cast<float>(contact.tangential_force));
    sliding.push_back(contact.sliding ? 1 : 0);
  }
  arrays.add("pair", pair, 2);
  if (!arrays.packed()) {  // else they follow from the centres, the radii and the walls
    arrays.add("normal", normal, 2);
    arrays.add("point", point, 2);
  }
  if (!forces) return;
  arrays.add("normal_force", normal_force);
  arrays.add("tangential_force", tangential_force);
  arrays.add("sliding", sliding);
}

}  // namespace

std::string frame_arrays(const std::string& key, const Moment<2>& moment, const std::vector<RecordedWall<2>>& walls,
                         bool forces, Precision precision) {
  auto lines = Json::array();
  for (const auto& line : lines_of(walls, moment)) {
    lines.push_back({{"number", line.number},
                     {"name", walls[static_cast<std::size_t>(line.number)].name},
                     {"from", {line.from[0], line.from[1]}},
                     {"to", {line.to[0], line.to[1]}}});
  }
  ArrayMessage message(Json{{"key", key}, {"time", moment.time}, {"walls", lines}});
  Arrays arrays(message, precision);
  add_grains(arrays, moment.grains);
  add_contacts(arrays, moment, forces);
  return message.bytes();
}

}  // namespace repose
