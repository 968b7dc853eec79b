// Records that cannot be read, and what is said of them.
#include "tests/sweep/files/record_texts.h"

using namespace record_texts;
using Catch::Contains;
using Catch::EndsWith;
using Catch::StartsWith;

TEST_CASE("decimal commas are named as such")
{
    CHECK(errors("time;position\n0,5;1\n").at(0) ==
          "run.csv:2:1: time: is \"0,5\", expected a finite number or an empty cell; these seem to be decimal commas, "
          "write decimal points");
    CHECK(only_error("time,position\n0,5,1,2\n") ==
          "run.csv:2:1: has 4 cells, the header has 2; these seem to be decimal commas, write decimal points");
    CHECK_THAT(errors("time;position\n0;1,x\n").at(0), EndsWith("or an empty cell"));
}

TEST_CASE("tables that are none")
{
    CHECK(only_error("") == "run.csv: is empty, expected a header row such as time,position");
    CHECK(only_error("# only a comment\n") == "run.csv: is empty, expected a header row such as time,position");
    CHECK(only_error("time,position\n") == "run.csv: has a header and no rows");
    CHECK(only_error("0,1\n1,2\n") ==
          "run.csv:1:1: there is no header row, expected names such as time,reference_position,position");
    CHECK(only_error(std::string("\x89PNG\r\n\x1a\n\0\0", 10)) ==
          "run.csv:2:1: is not text, expected a CSV table (plain or gzip)");
    CHECK_THAT(errors(std::string("ti\0me,position\n", 15)).at(0), StartsWith("run.csv:1:3: is not text"));
    CHECK_THAT(errors(std::string("time,position\n0,\x01\x02\n", 19)).at(0), StartsWith("run.csv:2:"));
    CHECK_THAT(only_error(std::string(3u << 20, 'x')), Contains("run.csv:1:1: the line is longer than 1 MiB"));
    const std::string zip = gzipped(std::string("time,position\n") + std::string(40000, '\n') + "0,1\n");
    CHECK_THAT(only_error(zip.substr(0, zip.size() - 12)), Contains("damaged or cut off"));
    std::string damaged = zip;
    damaged[damaged.size() - 6] ^= 1;  // inside the check sum
    CHECK_THAT(only_error(damaged), Contains("damaged or cut off"));
    // what is not compressed stands in the archive as it is, and its checksum far behind: one bit turns a digit into a
    // letter, or into a control character
    std::string rows = "time,position\n";
    for (int i = 0; i < 40000; ++i) rows += std::to_string(i) + ",1\n";
    const std::string archive = gzipped(rows, "wb0");
    for (const char flipped : {0x40, 0x20}) {
        std::string spoilt = archive;
        spoilt[spoilt.find("\n7,1") + 3] ^= flipped;
        CHECK(only_error(spoilt) == "run.csv: the archive is damaged or cut off (incorrect data check)");
    }
    const Joint joint = joint_of("prismatic");
    CHECK_THAT(messages_of([&] { read_record(shared_directory() / "absent.csv", joint); }).at(0),
               EndsWith("there is no such file"));
    CHECK_THAT(messages_of([&] { read_record(shared_directory().path(), joint); }).at(0),
               EndsWith("is a folder, expected a CSV file"));
}

TEST_CASE("headers that do not do")
{
    CHECK_THAT(only_error("t,position\n0,1\n"),
               StartsWith("run.csv:1:1: has no column time; its columns are t, position"));
    CHECK_THAT(only_error("time,effort_command\n0,1\n"),
               StartsWith("run.csv:1:1: has no measured signal, expected one of position, velocity,"));
    CHECK_THAT(only_error("time,posiiton\n0,1\n"),
               Contains("; its columns are time, posiiton (did you mean \"position\"?), [record.columns] can"));
    CHECK_THAT(only_error("time,elbow_position,wrist_position\n0,1,1\n"),
               EndsWith("; its columns are time, elbow_position, wrist_position, [record.columns] can give them other "
                        "names; they name the joints elbow, wrist: diagnose --joint elbow reads its columns"));
    CHECK(only_error("time,position,position\n0,1,1\n") ==
          "run.csv:1:1: column \"position\" appears twice in the header");
    CHECK(only_error("time,angle\n0,1\n", "[record.columns]\nposition = \"anlge\"\n") ==
          "record.toml:2:1: record.columns.position: run.csv has no column \"anlge\", its columns are time, angle; "
          "did you mean \"angle\"?");
    CHECK_THAT(only_error("time,x\n0,1\n", "[record.columns]\nposition = \"x\"\nvelocity = \"x\"\n"),
               Contains("column \"x\" is already position"));
}

TEST_CASE("rows that do not do")
{
    CHECK(only_error("time,position\n0,1\n1\n") == "run.csv:3:1: has 1 cells, the header has 2");
    CHECK(only_error("time,position\n0,1,2\n") == "run.csv:2:1: has 3 cells, the header has 2");
    CHECK(only_error("time,position\n0,abc\n") ==
          "run.csv:2:3: position: is \"abc\", expected a finite number or an empty cell");
    CHECK_THAT(only_error("time,position\n0,1.5x\n"), StartsWith("run.csv:2:3: position: is \"1.5x\""));
    CHECK_THAT(only_error("time,position\n0,inf\n"), StartsWith("run.csv:2:3: position: is \"inf\""));
    CHECK_THAT(only_error("time,position\n0,1e999\n"), StartsWith("run.csv:2:3: position: is \"1e999\""));
    CHECK(only_error("time,position\n,1\n") == "run.csv:2:1: time: is missing, every row needs one");
    CHECK(only_error("position,time\n1,nan\n") == "run.csv:2:3: time: is missing, every row needs one");
    CHECK(only_error("time,position\n1,1\n1,2\n") ==
          "run.csv:3:1: time: is 1, the same as in the row before; expected ascending time");
    CHECK(only_error("time,position\n2,1\n1,1\n") ==
          "run.csv:3:1: time: is 1, earlier than 2 before; expected ascending time");
    CHECK(only_error("time,position\n0,\n1,NA\n") == "run.csv: every measured signal is missing in every row");
    CHECK(only_error("time,position\n0,1\n1,1\n2,1\n", "", {2}) ==
          "run.csv:4:1: has more than 2 rows, split the record or keep every n-th row");
    std::string junk = "time,position\n";
    for (int i = 0; i < 1000; ++i) junk += "x,y" + std::to_string(i) + "\n";
    CHECK(errors(junk).size() == 21);
    CHECK(errors(junk).back() == "run.csv: and more; only the first 20 errors are shown");
}

TEST_CASE("a record without a position says what it has instead")
{
    CHECK_THAT(read("time,velocity,posiiton\n0,1,1\n1,1,1\n").no_position,
               EndsWith("run.csv:1:1: has no column position; its columns are time, velocity, posiiton (did you mean "
                        "\"position\"?), [record.columns] can give them other names"));
    CHECK_THAT(read("time,velocity,elbow_position\n0,1,1\n1,1,1\n").no_position,
               EndsWith("; they name the joint elbow: diagnose --joint elbow reads its columns"));
    CHECK_THAT(read("time,velocity,position\n0,1,\n1,1,\n").no_position,
               EndsWith("run.csv: every cell of its column position is empty"));
    CHECK(read("time,velocity,position\n0,1,1\n1,1,1\n").no_position.empty());
    CHECK(read("time,velocity\n0,1\n1,1\n", "[record.constants]\nposition = 0\n").no_position.empty());
}
