// The functions of fmt, compiled once for all sources: its shared library takes as long to load as
// a small file to be read, and from headers alone every source would compile them again.
#include <fmt/format-inl.h>

FMT_BEGIN_NAMESPACE

namespace detail {

template auto thousands_sep_impl(locale_ref) -> thousands_sep_result<char>;
template auto decimal_point_impl(locale_ref) -> char;
template auto dragonbox::to_decimal(float) noexcept -> dragonbox::decimal_fp<float>;
template auto dragonbox::to_decimal(double) noexcept -> dragonbox::decimal_fp<double>;

}  // namespace detail

FMT_END_NAMESPACE
