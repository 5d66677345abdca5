#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 1> cubic_aflip_float{
    combination<shape::CubicBSpline, transfer::AffineFlip, update::Usl, float>(Shape::cubic, Transfer::aflip,
                                                                               Update::usl)};

}  // namespace cavity
