#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 1> linear_xpic{
    combination<shape::Linear, transfer::Xpic, update::Musl, double>(Shape::linear, Transfer::xpic, Update::musl)};

}  // namespace cavity
