// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Contact-iterations per second of Box2D on a settled bed: standard input has a line `disc x y radius mass` for each
// grain and `wall x y nx ny` for each wall. Called by benchmarks/contact_dynamics.py; prints one line of JSON.
//
// Profile::solveVelocity of a step covers the loop of velocity iterations (and storing impulses once). It is wall time,
// so its fraction of the step is multiplied by the CPU time of the step.
#include <box2d/box2d.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <numbers>
#include <string>

namespace {

constexpr float gravity = 1.0f;
constexpr float friction = 0.5f;
constexpr int velocity_iterations = 50;
constexpr int position_iterations = 3;
constexpr int steps_to_settle = 600;
constexpr int steps_to_time = 40;
constexpr float half_length = 1000.0f;

double cpu_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void add_disc(b2World& world, float x, float y, float radius, float mass) {
  b2BodyDef body;
  body.type = b2_dynamicBody;
  body.position.Set(x, y);
  body.allowSleep = false;
  b2CircleShape shape;
  shape.m_radius = radius;
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = mass / (std::numbers::pi_v<float> * radius * radius);
  fixture.friction = friction;
  fixture.restitution = 0.0f;
  world.CreateBody(&body)->CreateFixture(&fixture);
}

/// Edges of Box2D have a skin, so a wall is moved back by it.
void add_wall(b2World& world, const b2Vec2& point, const b2Vec2& normal) {
  const b2Vec2 middle = point - b2_polygonRadius * normal;
  const b2Vec2 along(-normal.y, normal.x);
  b2EdgeShape shape;
  shape.SetTwoSided(middle - half_length * along, middle + half_length * along);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.friction = friction;
  fixture.restitution = 0.0f;
  const b2BodyDef body;
  world.CreateBody(&body)->CreateFixture(&fixture);
}

bool read_bed(std::istream& bed, b2World& world) {
  std::string kind;
  float x = 0.0f;
  float y = 0.0f;
  float a = 0.0f;
  float b = 0.0f;
  while (bed >> kind >> x >> y >> a >> b) {
    if (kind == "disc") {
      add_disc(world, x, y, a, b);
    } else {
      add_wall(world, {x, y}, {a, b});
    }
  }
  return bed.eof() && world.GetBodyCount() > 0;
}

int touching(const b2World& world) {
  int count = 0;
  for (const auto* c = world.GetContactList(); c != nullptr; c = c->GetNext()) count += c->IsTouching() ? 1 : 0;
  return count;
}

/// The root mean square of the speeds of the discs.
double typical_speed(const b2World& world) {
  double sum = 0.0;
  double discs = 0.0;
  for (const auto* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (body->GetType() != b2_dynamicBody) continue;
    sum += static_cast<double>(body->GetLinearVelocity().LengthSquared());
    discs += 1.0;
  }
  return std::sqrt(sum / discs);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: repose_box2d_bench TIME_STEP < BED\n";
    return 2;
  }
  const float dt = std::strtof(argv[1], nullptr);
  b2World world(b2Vec2(0.0f, -gravity));
  world.SetAllowSleeping(false);
  world.SetContinuousPhysics(false);
  if (!(dt > 0.0f) || !read_bed(std::cin, world)) {
    std::cerr << "repose_box2d_bench: no time step, or no bed\n";
    return 2;
  }
  for (int k = 0; k < steps_to_settle; ++k) world.Step(dt, velocity_iterations, position_iterations);
  double visits = 0.0;
  double seconds = 0.0;
  for (int k = 0; k < steps_to_time; ++k) {
    const double start = cpu_time();
    world.Step(dt, velocity_iterations, position_iterations);
    const auto& profile = world.GetProfile();
    seconds += (cpu_time() - start) * static_cast<double>(profile.solveVelocity / profile.step);
    visits += static_cast<double>(velocity_iterations) * touching(world);
  }
  std::cout << "{\"contacts\": " << touching(world) << ", \"contact_iterations\": " << visits
            << ", \"cpu_seconds\": " << seconds
            << ", \"speed_over_gdt\": " << typical_speed(world) / static_cast<double>(gravity * dt) << "}\n";
  return 0;
}
