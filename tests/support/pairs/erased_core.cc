#include "support/pairs/erased_core.h"

namespace dgd_test {

template class CoreAnswers<dgd::Point<double>>;
template class CoreAnswers<dgd::Segment<double>>;
template class CoreAnswers<dgd::Triangle<double>>;
template class CoreAnswers<dgd::Box<double>>;
template class CoreAnswers<dgd::Polytope<double>>;
template class CoreAnswers<dgd::CoreReference<dgd::Polytope<double>>>;
template class CoreAnswers<dgd::Cylinder<double>>;
template class CoreAnswers<dgd::Cone<double>>;
template class CoreAnswers<dgd::Frustum<double>>;
template class CoreAnswers<dgd::Ellipsoid<double>>;
template class CoreAnswers<dgd::Point<float>>;
template class CoreAnswers<dgd::Segment<float>>;
template class CoreAnswers<dgd::Triangle<float>>;
template class CoreAnswers<dgd::Box<float>>;
template class CoreAnswers<dgd::Polytope<float>>;
template class CoreAnswers<dgd::CoreReference<dgd::Polytope<float>>>;
template class CoreAnswers<dgd::Cylinder<float>>;
template class CoreAnswers<dgd::Cone<float>>;
template class CoreAnswers<dgd::Frustum<float>>;
template class CoreAnswers<dgd::Ellipsoid<float>>;
template class CoreAnswers<dgd::Point<double, 2>>;
template class CoreAnswers<dgd::Box<double, 2>>;
template class CoreAnswers<dgd::Ellipsoid<double, 2>>;

}  // namespace dgd_test
