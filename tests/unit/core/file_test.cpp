#include "core/file.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

using namespace platen::core;
namespace fs = std::filesystem;

namespace {

struct Files : testing::Test {
  fs::path folder = fs::temp_directory_path() / ("platen_file_test." + std::to_string(::getpid()));
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }
  std::size_t count() const {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  }
};

} // namespace

TEST_F(Files, AreReadAsTheyWereWritten) {
  const std::string content("a\0b\n", 4);
  write_file(folder / "x.csv", content);
  EXPECT_EQ(read_file(folder / "x.csv"), content);
  EXPECT_EQ(count(), 1u) << "the temporary file stays behind";
}

TEST_F(Files, KeepTheirOldContentWhenTheNewOneCannotBeWritten) {
  // /dev/full is a disk without space: a write there fails as one on a full disk does.
  fs::create_symlink("/dev/full", temporary_name(folder / "x.csv"));
  std::ofstream(folder / "x.csv") << "old";
  EXPECT_THROW(write_file(folder / "x.csv", "new"), IoError);
  EXPECT_EQ(read_file(folder / "x.csv"), "old");
  EXPECT_EQ(count(), 1u);
}

TEST_F(Files, ThatAreNotThereOrAreFoldersAreErrorsOfInput) {
  EXPECT_THROW((void)read_file(folder / "missing"), IoError);
  EXPECT_THROW((void)read_file(folder), IoError);
}

TEST_F(Files, AFolderUnderAFileCannotBePrepared) {
  write_file(folder / "x", "");
  try {
    prepare_folder(folder / "x" / "y");
    FAIL();
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("name another with -o"), std::string::npos) << error.what();
  }
}

TEST_F(Files, TemporaryNamesKeepTheExtension) {
  EXPECT_EQ(temporary_name("out/curve.svg").extension(), ".svg");
}
