package sunbeam.app.commands.cache;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.FloatBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.Sunbeam;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.shader.ArrayLayout;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.shader.ShaderTablesFile;
import sunbeam.precompute.shader.TableArray;
import sunbeam.precompute.table.TableLabel;

final class CacheCommandTest {
    @TempDir
    private Path home;

    private Path folder;
    private StringWriter out = new StringWriter();
    private StringWriter err = new StringWriter();

    @BeforeEach
    void folder() throws IOException {
        folder = Files.createDirectories(home.resolve(".cache/sunbeam"));
    }

    private int run(String... arguments) {
        out = new StringWriter();
        err = new StringWriter();
        return new Sunbeam(new Environment(Map.of(), home), new PrintWriter(out), new PrintWriter(err)).run(arguments);
    }

    /** A table of 4000 bytes and a header, last used so many seconds after some time. */
    private Path table(String name, int used) throws IOException {
        Path file = folder.resolve(name + ".tables");
        ShaderTables tables = new ShaderTables.Builder("full_grid")
                .array(TableArray.of(ArrayLayout.flat("numbers", 1000, 1, 1), new float[1000]))
                .build(1, 1);
        ShaderTablesFile.write(file, name, new TableLabel(name + "'s skin", "a plan for " + name), tables);
        return Files.setLastModifiedTime(file, FileTime.fromMillis(1_700_000_000_000L + 1000L * used));
    }

    @Test
    void listsWhatForWhichSurfaceHowLargeAndWhenUsedTheLastUsedFirst() throws IOException {
        table("first", 0);
        table("second", 90);
        Files.write(folder.resolve("damaged.tables"), new byte[10]);
        Files.write(folder.resolve("not-ours.txt"), new byte[10]);
        assertThat(run("cache")).isZero();
        assertThat(out.toString()).startsWith(folder + ": 3 tables, 8.").doesNotContain("not-ours");
        assertThat(out.toString().lines().skip(3))
                .satisfiesExactly(
                        line -> assertThat(line).contains("10 B", "?", "not usable", "truncated"),
                        line -> assertThat(line)
                                .contains("4.", " kB", "2023-11-1", "second's skin", "a plan for second"),
                        line -> assertThat(line).contains("first's skin", "a plan for first"));
        assertThat(err.toString()).isEmpty();
    }

    @Test
    void theLimitHoldsAtOnceAndTakesThoseThatWereUsedLongestAgo() throws IOException {
        Path old = table("old", 0);
        Path middle = table("middle", 50);
        Path fresh = table("fresh", 90);
        assertThat(run("cache", "--limit", "9kB")).isZero();
        assertThat(old).doesNotExist();
        assertThat(middle).exists();
        assertThat(fresh).exists();
        assertThat(out.toString()).contains("at most 9.0 kB; removed 1 table, ", "; left 2 tables, ");
        run("cache");
        assertThat(out.toString()).contains("of at most 9.0 kB");
        assertThat(run("cache", "--limit", "0 B")).isZero();
        assertThat(run("cache", "--limit", "default")).isZero();
        assertThat(out.toString()).contains("at most 2.0 GB");
        assertThat(run("cache", "--limit", "3GB")).isZero();
        assertThat(out.toString()).contains("left 0 tables");
    }

    @Test
    void clearingLeavesWhatIsNoTableAndWhatOthersRead() throws IOException {
        Path file = table("open", 0);
        ShaderTables read = ShaderTablesFile.read(file, "open");
        Path foreign = Files.write(folder.resolve("not-ours.txt"), new byte[10]);
        Path halfWritten = Files.write(folder.resolve(".sunbeam-00000000-1-0.part"), new byte[10]);
        assertThat(run("cache", "--clear")).isZero();
        assertThat(out.toString()).contains("removed 1 table, 4.");
        assertThat(folder.toFile().listFiles()).containsExactlyInAnyOrder(foreign.toFile(), halfWritten.toFile());
        FloatBuffer layer = read.arrays().get(0).layer(0);
        assertThat(layer.get(999)).as("read from a file that is gone").isZero();
    }

    @Test
    void aMissingFolderIsAnEmptyCache() throws IOException {
        Files.delete(folder);
        assertThat(run("cache")).isZero();
        assertThat(out.toString()).isEqualTo(folder + ": 0 tables, 0 B of at most 2.0 GB\n");
        assertThat(run("cache", "--clear")).isZero();
        assertThat(folder).doesNotExist();
    }

    @Test
    void wrongLimitsAreOneLineAndRemoveNothing() throws IOException {
        Path file = table("kept", 0);
        for (String wrong : new String[] {"5", "-1GB", "2 apples", "1e9B", "", "99999999TB", "NaN GB"}) {
            assertThat(run("cache", "--limit", wrong)).as(wrong).isEqualTo(2);
            assertThat(err.toString().lines()).hasSize(1);
            assertThat(err.toString()).contains("--limit").contains("give");
        }
        assertThat(run("cache", "--limit", "1GB", "--clear")).isEqualTo(2);
        assertThat(file).exists();
    }

    @Test
    void aDamagedLimitIsToldAndTheUsualOneHolds() throws IOException {
        Files.writeString(folder.resolve("limit"), "lots");
        assertThat(run("cache")).isZero();
        assertThat(out.toString()).contains("of at most 2.0 GB");
        assertThat(err.toString().lines()).hasSize(1);
        assertThat(err.toString()).contains(folder.resolve("limit").toString(), "cache --limit");
        assertThat(run("cache", "--limit", "1MB")).isZero();
        assertThat(run("cache")).isZero();
        assertThat(err.toString()).isEmpty();
    }

    @Test
    void aFolderThatCannotBeMadeIsOneLine() throws IOException {
        Files.delete(folder);
        Files.delete(home.resolve(".cache"));
        Files.createFile(home.resolve(".cache"));
        assertThat(run("cache")).isZero();
        assertThat(run("cache", "--limit", "1GB")).isEqualTo(6);
        assertThat(err.toString().lines()).hasSize(1);
        assertThat(err.toString()).contains("XDG_CACHE_HOME");
    }
}
