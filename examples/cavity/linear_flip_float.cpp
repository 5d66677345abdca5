#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 1> linear_flip_float{
    combination<shape::Linear, transfer::Flip, update::Musl, float>(Shape::linear, Transfer::flip, Update::musl)};

}  // namespace cavity
