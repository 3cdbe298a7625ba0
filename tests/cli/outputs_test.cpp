// What a run writes: all of its files or none, never onto a file that is no output of it.
#include "run_program.h"

#include <array>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

namespace fs = std::filesystem;

class OutputFiles : public CliTest {
 protected:
  static constexpr const char* kCut = "PRIMER_2F.MPF --stock block.stl --voxel 5 -q ";
  void expect_refused(const std::string& arguments, const std::string& one,
                      const std::string& other) {
    const Outcome o = run(arguments);
    EXPECT_EQ(o.code, 2) << arguments << o.err;
    EXPECT_TRUE(contains(o.err, one) && contains(o.err, other)) << arguments << o.err;
  }
  void expect_no_litter() const {
    for (const auto& entry : fs::directory_iterator(folder_))
      EXPECT_FALSE(entry.path().filename().string().starts_with(".mrsim-")) << entry.path();
  }
};

TEST_F(OutputFiles, NeverReplaceAnInput) {
  const std::string program = read("PRIMER_2F.MPF"), stock = read("block.stl");
  fs::create_symlink("block.stl", folder_ / "link.stl");
  fs::create_hard_link(folder_ / "PRIMER_2F.MPF", folder_ / "hard.html");
  write("tools.toml", "[[tool]]\nid = 4\ntype = \"endmill\"\ndiameter = 5\n");
  const std::string tools = read("tools.toml"), cut = kCut;
  expect_refused(cut + "--report PRIMER_2F.MPF", "--report", "the program");
  expect_refused(cut + "--report hard.html", "hard.html", "PRIMER_2F.MPF");
  expect_refused(cut + "-o block.stl", "-o", "the stock");
  expect_refused(cut + "-o link.stl", "link.stl", "block.stl");
  expect_refused(cut + "-o ../" + folder_.filename().string() + "/block.stl", "-o", "the stock");
  expect_refused(cut + "--tools tools.toml --report tools.toml", "--report", "--tools");
  expect_refused(cut + "--nominal bar.stl --json bar.stl", "--json", "--nominal");
  expect_refused("compare block.stl bar.stl --json block.stl", "--json", "the part");
  expect_refused("compare block.stl bar.stl --junit ./bar.stl", "--junit", "the nominal");
  fs::copy(folder_ / "block.stl", folder_ / "block.png");
  expect_refused("render block.stl --nominal block.png -o block.png", "-o", "--nominal");
  write("j.toml", "program = \"PRIMER_2F.MPF\"\nvoxel = 5\nreport = \"j.toml\"\n");
  expect_refused("j.toml", "--report", "the job");
  EXPECT_EQ(read("PRIMER_2F.MPF"), program);
  EXPECT_EQ(read("block.stl"), stock);
  EXPECT_EQ(read("tools.toml"), tools);
}

TEST_F(OutputFiles, NeverReplaceASubprogram) {
  write("MAIN.MPF", "G54\nTRANS X0\nT1 M6\nG0 X0 Y0 Z5\nSUB\nM30\n");
  write("SUB.SPF", "G1 Z-1 F100\nG1 X20\nM17\n");
  expect_refused("MAIN.MPF --machine mill --tool 1=endmill:d=5 --voxel 5 --report SUB.SPF",
                 "--report", "a file of the program");
}

// A command that is refused may not know its inputs: --json that names one does not replace it.
TEST_F(OutputFiles, OfARefusalReplaceNoInput) {
  write("MAIN.MPF", "G54\nTRANS X0\nT1 M6\nG0 X0 Y0 Z5\nSUB\nM30\n");
  write("SUB.SPF", "G1 Z-1 F100\nG1 X20\nM17\n");
  write("job.toml", "program = \"PRIMER_2F.MPF\"\nvoxl = 5\n");
  write("tools.json", "{\"data\": []}");
  const std::string main = "MAIN.MPF --machine mill --tool 1=endmill:d=5 --voxel 5 ";
  const std::string program = read("PRIMER_2F.MPF"), sub = read("SUB.SPF");
  const std::string stock = read("block.stl"), tools = read("tools.json");
  for (const std::string& arguments : std::vector<std::string>{
           main + "--json SUB.SPF", main + "--junit SUB.SPF", main + "--unknown --json SUB.SPF",
           "MAIN.MPF PRIMER_2F.MPF --json PRIMER_2F.MPF", "job.toml --json PRIMER_2F.MPF",
           "job.toml --unknown --json tools.json",
           "--voxel 1 PRIMER_2F.MPF --json block.stl --tool",
           "compare bar.stl bar.stl block.stl --json block.stl",
           "compare bar.stl --json=block.stl --accept", "rest bar.stl bar.stl --json bar.stl",
           "rest bar.stl bar.stl block.stl --json block.stl"})
    EXPECT_NE(run(arguments).code, 0) << arguments;
  EXPECT_EQ(read("PRIMER_2F.MPF"), program);
  EXPECT_EQ(read("SUB.SPF"), sub);
  EXPECT_EQ(read("block.stl"), stock);
  EXPECT_EQ(read("tools.json"), tools);
}

TEST_F(OutputFiles, OfPicturesAndFramesReplaceNoInput) {
  write("MAIN.MPF", "G54\nTRANS X0\nT1 M6\nG0 X0 Y0 Z5\nSUB\nM30\n");
  write("SUB.SPF", "G1 Z-1 F100\nG1 X20\nM17\n");
  write("tools.toml", "[[tool]]\nid = 4\ntype = \"endmill\"\ndiameter = 5\n");
  fs::create_symlink("tools.toml", folder_ / "tools.svg");
  fs::create_symlink("block.stl", folder_ / "f-1.png");
  fs::create_symlink("block.stl", folder_ / "f-1.stl");
  fs::create_symlink("SUB.SPF", folder_ / "sub.svg");
  fs::create_symlink("SUB.SPF", folder_ / "sub-1.png");
  const std::string main = "MAIN.MPF --machine mill --tool 1=endmill:d=5 ";
  const std::string tools = read("tools.toml"), sub = read("SUB.SPF"), stock = read("block.stl");
  expect_refused("tools tools.toml -o new.svg -o tools.svg", "tools.svg", "the tools");
  expect_refused("trace " + main + "-o sub.svg", "sub.svg", "SUB.SPF");
  expect_refused("render " + main + "--frames 2 --voxel 5 -o sub.png", "sub-1.png", "SUB.SPF");
  expect_refused("render " + std::string(kCut) + "--frames 2 -o f.png", "f-1.png", "the stock");
  expect_refused(std::string(kCut) + "--frames 2 -o f.stl", "f-1.stl", "the stock");
  for (const char* side : {"--json", "--junit", "--report", "--history"})
    expect_refused(std::string(kCut) + "--frames 2 -o g.stl " + side + " g-1.stl", "g-1.stl", side);
  EXPECT_EQ(read("tools.toml"), tools);
  EXPECT_EQ(read("SUB.SPF"), sub);
  EXPECT_EQ(read("block.stl"), stock);
  for (const char* name : {"new.svg", "f-2.stl", "f-2.png"}) EXPECT_FALSE(exists(name)) << name;
}

TEST_F(OutputFiles, AreNotGivenTwice) {
  const std::string cut = kCut;
  write("a.ply", "old");
  fs::create_symlink("a.ply", folder_ / "b.ply");
  fs::create_symlink("new.ply", folder_ / "dangling.ply");
  expect_refused(cut + "-o a.ply -o b.ply", "a.ply", "b.ply");
  expect_refused(cut + "-o new.ply -o dangling.ply", "new.ply", "dangling.ply");
  expect_refused(cut + "-o a.ply --report a.ply", "-o", "--report");
  expect_refused("compare block.stl block.stl --json a.ply --junit b.ply", "--json", "--junit");
  expect_refused(cut + "--json a.ply --junit b.ply", "--json", "--junit");
  EXPECT_EQ(read("a.ply"), "old");
}

TEST_F(OutputFiles, FollowLinks) {
  fs::create_directory(folder_ / "there");
  fs::create_symlink("there/part.stl", folder_ / "part.stl");
  for (int i = 0; i < 2; ++i) {  // a dangling link, then one to the file
    EXPECT_EQ(run(std::string(kCut) + "-o part.stl").code, 0);
    EXPECT_TRUE(fs::is_symlink(folder_ / "part.stl"));
    EXPECT_GT(fs::file_size(folder_ / "there/part.stl"), 84u);
  }
  fs::create_symlink("loop.stl", folder_ / "loop.stl");
  EXPECT_EQ(run(std::string(kCut) + "-o loop.stl").code, 1);
}

TEST_F(OutputFiles, GoToDevicesAndPipes) {
  const std::string json = "compare block.stl block.stl --density 1 -q --json ";
  ASSERT_EQ(run(json + "r.json").code, 0);
  EXPECT_EQ(run(json + "/dev/stdout").out, read("r.json"));
  EXPECT_EQ(run(json + "-").out, read("r.json"));
  EXPECT_EQ(run(json + "/dev/null").code, 0);
  struct stat info {};
  ASSERT_EQ(::stat("/dev/null", &info), 0);
  EXPECT_TRUE(S_ISCHR(info.st_mode));
  fs::create_symlink("/dev/null", folder_ / "null.json");
  EXPECT_EQ(run(json + "null.json").code, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "null.json"));
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  std::string piped;
  std::thread reader([&] { piped = contents(folder_ / "pipe"); });
  EXPECT_EQ(run(json + "pipe").code, 0);
  reader.join();
  EXPECT_EQ(piped, read("r.json"));
  EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
}

TEST_F(OutputFiles, GoToSockets) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = (folder_ / "socket").string();
  name.copy(address.sun_path, sizeof address.sun_path - 1);
  const int server = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(::bind(server, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  ASSERT_EQ(::listen(server, 1), 0);
  std::string got;
  std::thread reader([&] {
    const int fd = ::accept(server, nullptr, nullptr);
    std::array<char, 4096> piece;
    for (ssize_t n; (n = ::read(fd, piece.data(), piece.size())) > 0;)
      got.append(piece.data(), std::size_t(n));
    ::close(fd);
  });
  EXPECT_EQ(run("compare block.stl block.stl -q --json socket --junit r.xml").code, 0);
  reader.join();
  ::close(server);
  EXPECT_TRUE(got.starts_with("{")) << got;
  EXPECT_TRUE(fs::is_socket(folder_ / "socket"));
  EXPECT_TRUE(exists("r.xml"));
}

TEST_F(OutputFiles, AreAllThereOrNone) {
  for (const char* name : {"a.stl", "d.ply", "r.html"}) write(name, "old");
  const auto expect_old = [&] {
    for (const char* name : {"a.stl", "d.ply", "r.html"}) EXPECT_EQ(read(name), "old") << name;
    expect_no_litter();
  };
  const std::string cut = kCut;
  EXPECT_EQ(run(cut + "-o a.stl --report full/r.html").code, 1);
  EXPECT_EQ(run(cut + "-o a.stl -o d.ply --report /dev/full").code, 1);
  expect_old();
  EXPECT_EQ(run("compare block.stl block.stl -o d.ply --report r.html --json /dev/full").code, 1);
  expect_old();
  // Files of at most 20 kB: the report is larger. As a full disk, an error.
  const Outcome o = run(cut + "-o a.stl -o d.ply --report r.html", "ulimit -f 20;");
  EXPECT_EQ(o.code, 1) << o.err;
  EXPECT_TRUE(contains(o.err, "cannot write")) << o.err;
  expect_old();
}

// While a pipe is written to, before the files get their names, one place becomes a folder.
TEST_F(OutputFiles, ArePutBackWhereOneCannotBeReplaced) {
  for (const char* name : {"a.stl", "c.ply"}) write(name, "old");
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  std::thread reader([&] {
    const int fd = ::open((folder_ / "pipe").c_str(), O_RDONLY);
    fs::create_directory(folder_ / "b.obj");
    char byte;
    while (::read(fd, &byte, 1) > 0) {
    }
    ::close(fd);
  });
  const Outcome o = run(std::string(kCut) + "-o a.stl -o c.ply -o b.obj --report pipe");
  reader.join();
  EXPECT_EQ(o.code, 1) << o.err;
  EXPECT_TRUE(contains(o.err, "b.obj")) << o.err;
  EXPECT_EQ(read("a.stl"), "old");
  EXPECT_EQ(read("c.ply"), "old");
  expect_no_litter();
}

TEST_F(OutputFiles, LeftByADeadRunAreSettledByTheNext) {
  // As a run leaves them that dies after the first of two files: the journal has the old one.
  struct stat info {};
  write("a.stl", "new");
  ASSERT_EQ(::stat((folder_ / "a.stl").c_str(), &info), 0);
  const std::string token = ".mrsim-0123456789abcdef", folder = fs::canonical(folder_).string();
  const std::string a = folder + "/a.stl", b = folder + "/b.stl";
  write(token + "-0.old", "old");
  write(token + "-1.new", "new");
  const std::string entries = "1 " + std::to_string(info.st_ino) + " " + std::to_string(a.size()) +
                              "\n" + a + "\n0 1 " + std::to_string(b.size()) + "\n" + b + "\n";
  write(token + ".journal", "mrsim-journal 1\n2\n" + entries);
  ::chmod((folder_ / (token + ".journal")).c_str(), 0600);
  EXPECT_EQ(run("missing.MPF -o other.stl").code, 1);
  EXPECT_EQ(read("a.stl"), "old");
  EXPECT_FALSE(exists("b.stl"));
  expect_no_litter();
}

// What others may have written is not followed: a journal names files to be replaced.
TEST_F(OutputFiles, AreNotTouchedByAJournalThatOthersCouldHaveWritten) {
  const std::string token = ".mrsim-0123456789abcdef";
  const std::string victim = (fs::canonical(folder_) / "bar.stl").string();
  write(token + "-0.old", "stolen");
  write(token + ".journal",
        "mrsim-journal 1\n1\n1 1 " + std::to_string(victim.size()) + "\n" + victim + "\n");
  ::chmod((folder_ / (token + ".journal")).c_str(), 0666);
  const std::string bar = read("bar.stl");
  EXPECT_EQ(run("missing.MPF -o other.stl").code, 1);
  EXPECT_EQ(read("bar.stl"), bar);
  EXPECT_TRUE(exists(token + "-0.old"));
}

}  // namespace
}  // namespace mrsim
