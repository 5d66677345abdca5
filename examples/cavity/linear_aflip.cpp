#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 2> linear_aflip{
    combination<shape::Linear, transfer::AffineFlip, update::Usl, double>(Shape::linear, Transfer::aflip, Update::usl),
    combination<shape::Linear, transfer::AffineFlip, update::Musl, double>(Shape::linear, Transfer::aflip,
                                                                           Update::musl)};

}  // namespace cavity
