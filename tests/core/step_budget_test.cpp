// SPDX-License-Identifier: MIT
#include <sspql/core/step_budget.hpp>

#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

using sspql::StepBudget;

TEST(StepBudget, StartsEmptyAndEarnsUpToTheBank) {
    StepBudget budget(10, 25);
    EXPECT_TRUE(budget.exhausted());
    EXPECT_EQ(budget.balance(), 0);
    budget.earn();
    EXPECT_FALSE(budget.exhausted());
    EXPECT_EQ(budget.balance(), 10);
    budget.earn();
    budget.earn();
    EXPECT_EQ(budget.balance(), 25);
    EXPECT_EQ(budget.per_step(), 10u);
    EXPECT_EQ(budget.bank(), 25u);
}

TEST(StepBudget, WhatWasOverspentIsPaidBack) {
    StepBudget budget(10, 10);
    budget.earn();
    budget.spend(9);
    EXPECT_FALSE(budget.exhausted());
    budget.spend(16);
    EXPECT_TRUE(budget.exhausted());
    EXPECT_EQ(budget.balance(), -15);
    budget.earn();
    EXPECT_TRUE(budget.exhausted());
    budget.earn();
    EXPECT_EQ(budget.balance(), 5);
}

TEST(StepBudget, GrantsGoPastTheBankAndStay) {
    StepBudget budget(10, 20);
    budget.grant(100);
    EXPECT_EQ(budget.balance(), 100);
    budget.earn();
    EXPECT_EQ(budget.balance(), 100) << "above the bank nothing is earned, nor lost";
    budget.spend(95);
    budget.earn();
    EXPECT_EQ(budget.balance(), 15);
}

TEST(StepBudget, UnlimitedNeverRunsOut) {
    StepBudget budget = StepBudget::unlimited();
    for (int i = 0; i < 1000; ++i) budget.spend(1'000'000'000'000'000);
    EXPECT_FALSE(budget.exhausted());
    budget.earn();
    EXPECT_FALSE(budget.exhausted());
}

TEST(StepBudget, RefusesWhatMakesNoSense) {
    EXPECT_THROW(StepBudget(0, 10), std::invalid_argument);
    EXPECT_THROW(StepBudget(10, 9), std::invalid_argument);
    EXPECT_THROW(StepBudget(1'000'000'000'000'001, 1'000'000'000'000'001), std::invalid_argument);
    EXPECT_THROW(StepBudget(1, ~std::uint64_t{0}), std::invalid_argument);
    EXPECT_NO_THROW(StepBudget(1, 1));
    EXPECT_NO_THROW(StepBudget(1'000'000'000'000'000, 1'000'000'000'000'000));
}
