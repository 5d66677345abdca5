#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 2> quadratic_xpic{
    combination<shape::QuadraticBSpline, transfer::Xpic, update::Usl, double>(Shape::quadratic, Transfer::xpic,
                                                                              Update::usl),
    combination<shape::QuadraticBSpline, transfer::Xpic, update::Usf, double>(Shape::quadratic, Transfer::xpic,
                                                                              Update::usf)};

}  // namespace cavity
