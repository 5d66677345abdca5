#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 2> linear_flip{
    combination<shape::Linear, transfer::Flip, update::Usl, double>(Shape::linear, Transfer::flip, Update::usl),
    combination<shape::Linear, transfer::Flip, update::Musl, double>(Shape::linear, Transfer::flip, Update::musl)};

}  // namespace cavity
