// SPDX-License-Identifier: MIT
// Every header of the simulation, and Box2D linked through sspql::sim.
#include <cstdio>

#include "all_of_sim.hpp"

#include <box2d/box2d.h>

int main() {
    b2World world(b2Vec2(0.0f, 0.0f));
    std::printf("%d bodies\n", world.GetBodyCount());
}
