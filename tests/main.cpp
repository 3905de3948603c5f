// Runs a binary's tests. Where every one of them was skipped it returns 77, which ctest is told to
// report as skipped: that nothing was checked is neither a failure nor a success.
#include <gmock/gmock.h>

int main(int count, char** arguments) {
    testing::InitGoogleMock(&count, arguments);
    const int result = RUN_ALL_TESTS();
    const testing::UnitTest& tests = *testing::UnitTest::GetInstance();
    const bool all_skipped =
        tests.skipped_test_count() > 0 && tests.skipped_test_count() == tests.test_to_run_count();
    return result == 0 && all_skipped ? 77 : result;
}
