package sunbeam.app.faults;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.files.output.Overwrite;

/**
 * Commands that write, killed (SIGKILL) by strace at every system call that touches the output's folder or the cache: what
 * stands under a name is the old file or the new one, whole, and the same command once more comes to the undisturbed end.
 * Not among the tests: {@code ./sunbeam test -Dtest=KilledAtEveryCall}, with {@code
 * -Dsunbeam.most=N} for other than 20 calls of a kind at most, evenly spread over all of them.
 */
final class KilledAtEveryCall {
    private static final byte[] OLD = "what stood here before".getBytes(StandardCharsets.UTF_8);

    /** An HDF5 table takes a thousand writes to its temporary file. */
    private static final int MOST_OF_A_KIND = Math.max(2, Integer.getInteger("sunbeam.most", 20));

    @TempDir
    private Path folder;

    private Path out;
    private Path target;
    private Path tables;
    private Path directions;
    private TracedProgram program;

    @BeforeAll
    static void straceIsThere() throws Exception {
        assumeTrue(TracedProgram.isPossible(), "skipped: strace is missing, or may not trace here");
    }

    @BeforeEach
    void prepare() throws IOException {
        Path cache = Files.createDirectory(folder.resolve("cache"));
        tables = Files.createDirectory(cache.resolve("sunbeam"));
        out = Files.createDirectory(folder.resolve("out"));
        target = out.resolve("target.x");
        directions = Files.writeString(
                folder.resolve("directions.csv"),
                "theta_i,phi_i,theta_r,phi_r,wavelength\n0,0,10,180,550\n30,10,5,5,400\n");
        program = new TracedProgram(cache, folder.resolve("said.txt"));
    }

    /** Empty folders, with an old file under the output's name where one is to be replaced. */
    private void begin(Overwrite overwrite) throws IOException {
        for (Path place : List.of(out, tables)) {
            for (String name : files(place).keySet()) {
                Files.delete(place.resolve(name));
            }
        }
        if (overwrite == Overwrite.REPLACE) {
            Files.write(target, OLD);
        }
    }

    private List<String> arguments(String command, Overwrite overwrite) {
        List<String> arguments = new ArrayList<>(
                List.of(command.replace("DIRECTIONS", directions.toString()).split(" ")));
        arguments.addAll(List.of("--output", target.toString()));
        if (overwrite == Overwrite.REPLACE) {
            arguments.add("--force");
        }
        return arguments;
    }

    /** All files of a folder by their names. */
    private static Map<String, byte[]> files(Path place) throws IOException {
        try (Stream<Path> files = Files.list(place)) {
            Map<String, byte[]> contents = new TreeMap<>();
            files.forEach(file -> contents.put(file.getFileName().toString(), content(file)));
            return contents;
        }
    }

    private static byte[] content(Path file) {
        try {
            return Files.readAllBytes(file);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    private static boolean isTemporary(String name) {
        return name.startsWith(".sunbeam-") && name.endsWith(".part");
    }

    @ParameterizedTest
    @CsvSource({
        "REFUSE, mesh plane",
        "REPLACE, mesh plane",
        "REFUSE, precompute --patch blaze",
        "REPLACE, precompute --patch blaze",
        "REFUSE, reflectance --method reference --patch blaze --directions DIRECTIONS",
        "REPLACE, reflectance --method reference --patch blaze --directions DIRECTIONS",
        "REFUSE, inspect --patch blaze",
        "REPLACE, inspect --patch blaze",
    })
    void oldOrNewWholeAndSweptByTheNext(Overwrite overwrite, String command) throws Exception {
        List<String> arguments = arguments(command, overwrite);
        begin(overwrite);
        program.run(arguments);
        Map<String, byte[]> expected = files(out);
        Map<String, byte[]> cached = files(tables);
        begin(overwrite);
        TracedProgram.Calls calls = program.count(arguments, List.of(out, tables));
        // The temporary file, and the folder that has its name.
        assertThat(calls.counts().get("fsync")).isGreaterThanOrEqualTo(2);

        Map<Found, Integer> found = new EnumMap<>(Found.class);
        int kills = 0;
        for (Map.Entry<String, Integer> call : calls.counts().entrySet()) {
            for (int number : spread(call.getValue())) {
                String when = command + " (" + overwrite + "), killed at " + call.getKey() + " " + number;
                begin(overwrite);
                program.killAt(arguments, calls, call.getKey(), number);
                found.merge(checkWhatIsLeft(expected, cached, overwrite, when), 1, Integer::sum);
                kills++;
                program.run(arguments(command, Overwrite.REPLACE));
                assertSame(finished(out), expected, when + ", and once more");
                assertSame(finished(tables), cached, when + ", and once more");
            }
        }
        System.out.printf(
                "%s (%s): %d kills at %s calls; then there was %s%n", command, overwrite, kills, calls.counts(), found);
    }

    /** From the first to the last, evenly spread where there are more than the most. */
    private static int[] spread(int count) {
        int chosen = Math.min(count, MOST_OF_A_KIND);
        return IntStream.range(0, chosen)
                .map(index -> 1 + (int) ((long) index * (count - 1) / Math.max(1, chosen - 1)))
                .toArray();
    }

    /** What stands under the output's name after a kill. */
    private enum Found {
        NOTHING,
        OLD,
        NEW
    }

    private Found checkWhatIsLeft(
            Map<String, byte[]> expected, Map<String, byte[]> cached, Overwrite overwrite, String when)
            throws IOException {
        Map<String, byte[]> left = finished(out);
        Map<String, byte[]> leftTables = finished(tables);
        assertThat(cached.keySet()).as(when).containsAll(leftTables.keySet());
        leftTables.forEach(
                (name, content) -> assertThat(content).as(when + ": " + name).isEqualTo(cached.get(name)));
        assertThat(left.keySet()).as(when).isSubsetOf(Set.of("target.x"));
        byte[] content = left.get("target.x");
        if (content == null) {
            assertThat(overwrite).as(when + ": the old file is lost").isEqualTo(Overwrite.REFUSE);
            return Found.NOTHING;
        }
        if (overwrite == Overwrite.REPLACE && Arrays.equals(content, OLD)) {
            return Found.OLD;
        }
        assertThat(content).as(when).isEqualTo(expected.get("target.x"));
        return Found.NEW;
    }

    /** All but temporary files, which a later run sweeps after a day. */
    private static Map<String, byte[]> finished(Path folder) throws IOException {
        Map<String, byte[]> files = files(folder);
        files.keySet().removeIf(KilledAtEveryCall::isTemporary);
        return files;
    }

    private static void assertSame(Map<String, byte[]> actual, Map<String, byte[]> expected, String when) {
        assertThat(actual.keySet()).as(when).isEqualTo(expected.keySet());
        expected.forEach((name, content) ->
                assertThat(actual.get(name)).as(when + ": " + name).isEqualTo(content));
    }
}
