// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "report/axis.hpp"
#include "report/line_chart.hpp"
#include "report/occurrences.hpp"

namespace sspql::report {
namespace {

LineChart chart_of(std::vector<Series> series) {
    LineChart chart;
    chart.x_label = "episode";
    chart.y_label = "steps";
    chart.series = std::move(series);
    return chart;
}

TEST(Axis, LinearTicksAreNice) {
    const Axis axis = linear_axis(0.0, 371.0, 6);
    EXPECT_EQ(axis.ticks, (std::vector<double>{0.0, 100.0, 200.0, 300.0, 400.0}));
    EXPECT_DOUBLE_EQ(axis.fraction(100.0), 0.25);
    EXPECT_EQ(axis.fraction(1000.0), 1.0);  // drawn at the end
    EXPECT_TRUE(std::isnan(axis.fraction(std::nan(""))));
    EXPECT_EQ(tick_text(linear_axis(0.0, 0.3, 3).ticks[1]), "0.1");
    EXPECT_EQ(linear_axis(-1.0, 1.0, 4).ticks, (std::vector<double>{-1.0, -0.5, 0.0, 0.5, 1.0}));
}

TEST(Axis, EndsThatSpanNothing) {
    for (const Axis& axis :
         {linear_axis(0.0, 0.0, 5), linear_axis(7.0, 7.0, 5), linear_axis(-2.0, -2.0, 5),
          linear_axis(std::nan(""), 1.0, 5), log_axis(0.0, -1.0), log_axis(5.0, 5.0), whole_axis(1.0, 1.0, 10)}) {
        EXPECT_LT(axis.low, axis.high);
        EXPECT_FALSE(axis.ticks.empty());
    }
}

TEST(Axis, WholeAndLogarithmicTicks) {
    EXPECT_EQ(whole_axis(1.0, 30.0, 10).ticks, (std::vector<double>{1.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0}));
    EXPECT_EQ(whole_axis(1.0, 1.0, 10).ticks, (std::vector<double>{1.0}));
    EXPECT_EQ(whole_axis(1.0, 3.0, 10).ticks, (std::vector<double>{1.0, 2.0, 3.0}));
    EXPECT_EQ(log_axis(12.0, 370.0).ticks, (std::vector<double>{10.0, 20.0, 50.0, 100.0, 200.0, 500.0}));
    EXPECT_EQ(log_axis(1.0, 1e6).ticks.size(), 7u);
    EXPECT_DOUBLE_EQ(log_axis(10.0, 1000.0).fraction(100.0), 0.5);
    EXPECT_EQ(tick_text(0.0), "0");
    EXPECT_EQ(tick_text(2e6), "2e6");
    EXPECT_EQ(tick_text(1500.0), "1500");
}

TEST(LineChart, DrawsALineABandAndTheLegend) {
    const std::string text =
        line_chart(chart_of({{"a & b", {10.0, 5.0, 4.0}, {1.0, 1.0, 1.0}}, {"c", {3.0, 2.0}}})).element();
    EXPECT_EQ(count(text, "<polyline"), 2u);
    EXPECT_EQ(count(text, "opacity=\"0.18\""), 1u);
    EXPECT_GE(count(text, ">a &amp; b</text>"), 1u);
    EXPECT_EQ(count(text, "no data"), 0u);
    EXPECT_EQ(count(text, "nan"), 0u);
}

TEST(LineChart, OneEpisodeIsAPoint) {
    const std::string text = line_chart(chart_of({{"a", {10.0}, {2.0}}})).element();
    EXPECT_EQ(count(text, "<polyline"), 0u);
    EXPECT_GE(count(text, "<circle"), 1u);
    EXPECT_EQ(count(text, "nan"), 0u);
}

TEST(LineChart, NoDataSaysSo) {
    for (const LineChart& chart :
         {chart_of({}), chart_of({{"a", {}}}), chart_of({{"a", {std::nan(""), std::nan("")}}})}) {
        const std::string text = line_chart(chart).element();
        EXPECT_EQ(count(text, ">no data</text>"), 1u);
        EXPECT_EQ(count(text, "nan"), 0u);
    }
    EXPECT_EQ(value_range(chart_of({})).high, 1.0);
}

TEST(LineChart, NotANumberLeavesAGap) {
    const double none = std::nan("");
    const std::string text =
        line_chart(chart_of({{"a", {4.0, 3.0, none, 2.0, 1.0}, {1.0, 1.0, none, none, 0.0}}})).element();
    EXPECT_EQ(count(text, "<polyline"), 2u);
    EXPECT_EQ(count(text, "opacity=\"0.18\""), 1u);
    EXPECT_EQ(count(text, "nan"), 0u);
}

TEST(LineChart, RangeStartsAtZeroUnlessValuesAreNegative) {
    EXPECT_EQ(value_range(chart_of({{"a", {50.0, 40.0}, {60.0, 1.0}}})).low, 0.0);
    EXPECT_EQ(value_range(chart_of({{"a", {50.0, 40.0}, {60.0, 1.0}}})).high, 110.0);
    EXPECT_EQ(value_range(chart_of({{"a", {-50.0, -40.0}, {10.0, 1.0}}})).low, -60.0);
    EXPECT_EQ(value_range(chart_of({{"a", {-50.0, -40.0}}})).high, 0.0);
    LineChart chart = chart_of({{"a", {5.0}}});
    chart.reference = ReferenceLine{"J*", 8.0};
    EXPECT_EQ(value_range(chart).high, 8.0);
    EXPECT_EQ(count(line_chart(chart).element(), ">J*</text>"), 1u);
}

TEST(LineChart, LogarithmicScaleLeavesOutWhatItCannotShow) {
    LineChart chart = chart_of({{"a", {1000.0, 0.0, -3.0, 10.0}, {2000.0}}});
    chart.logarithmic = true;
    EXPECT_EQ(value_range(chart).low, 10.0);
    EXPECT_EQ(value_range(chart).high, 3000.0);
    const std::string text = line_chart(chart).element();
    EXPECT_EQ(count(text, "nan"), 0u);
    EXPECT_EQ(count(text, "inf"), 0u);
}

TEST(LineChart, SmallMultiplesShareAxesAndKeepColours) {
    const LineChart all = chart_of({{"a", {10.0, 5.0}}, {"b", {100.0, 50.0}}});
    const std::vector<LineChart> charts = small_multiples(all, 300.0, 200.0);
    ASSERT_EQ(charts.size(), 2u);
    EXPECT_EQ(charts[1].title, "b");
    EXPECT_EQ(charts[1].series[0].ink, Ink::series1);
    EXPECT_EQ(charts[0].y_range->high, 100.0);
    EXPECT_EQ(line_chart(charts[0]).width(), 300.0);
}

}  // namespace
}  // namespace sspql::report
