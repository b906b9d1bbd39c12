package sunbeam.app.longrun;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sunbeam.app.gpu.NeedsDisplay;

/**
 * Long work that is killed (SIGKILL) at random moments and begun again, until it has been killed so often. Whenever a run
 * reaches its end, its files must be those of a run that nobody disturbed, byte by byte save for times; and at each kill
 * what was finished before must be there as it was: not made again, not lost. Not among the tests: {@code ./sunbeam test
 * -Dtest=KilledLongWork -Dsunbeam.kills=50}, with {@code -Dsunbeam.seed=N} for other moments and {@code
 * -Dsunbeam.work=TABLE} for one of {@link LongWork} alone, and {@code -Dsunbeam.again=0.8} to kill what was killed once more, in
 * four of five cases, so that fewer runs come to their end.
 */
@NeedsDisplay
final class KilledLongWork {
    // Share of what was killed that is killed once more.
    private static final double AGAIN = Double.parseDouble(System.getProperty("sunbeam.again", "0.5"));
    private static final long MINUTES_OF_ONE_RUN = 60;
    private static final String IN_TIME = "ended in " + MINUTES_OF_ONE_RUN + " minutes";

    private static final long LOOK_EVERY_MILLISECONDS = 20;

    @TempDir
    private Path folder;

    private int kills;
    private int killsWithParts;
    private int partsKept;
    private int ends;
    private int mostParts;

    @ParameterizedTest
    @EnumSource(LongWork.class)
    void whatWasKilledComesToTheSameEnd(LongWork work) throws Exception {
        String wanted = System.getProperty("sunbeam.work", work.name());
        assumeTrue(wanted.contains(work.name()), "skipped: -Dsunbeam.work=" + wanted);
        SplittableRandom random = new SplittableRandom(
                Long.getLong("sunbeam.seed", 1) + work.name().hashCode());
        int most = Integer.getInteger("sunbeam.kills", 50);
        Path cache = folder.resolve("cache");
        LongWork.Place undisturbed = new LongWork.Place(folder.resolve("undisturbed"), cache);
        assertThat(run(work, undisturbed, Kill.NEVER)).as(IN_TIME).isTrue();
        long start = System.nanoTime();
        LongWork.Place second = new LongWork.Place(folder.resolve("second"), cache);
        assertThat(run(work, second, Kill.NEVER)).as(IN_TIME).isTrue();
        // The first run made tables that others find in the cache.
        long duration = System.nanoTime() - start;
        Map<String, String> expected = work.result(undisturbed);
        assertSame(expected, work.result(second), "two runs that nobody disturbed");

        while (kills < most) {
            untilItsEnd(work, new LongWork.Place(folder.resolve("killed-" + ends), cache), random, duration, expected);
            ends++;
            report(work, duration);
        }
    }

    /** After each end, as the next may take long. */
    private void report(LongWork work, long duration) {
        System.out.printf(
                Locale.ROOT,
                "%s: %d kills, %d of them with finished parts, which were kept %d times; %d ends like the undisturbed (%.1f s)%n",
                work,
                kills,
                killsWithParts,
                partsKept,
                ends,
                duration * 1e-9);
    }

    /** One piece of work, killed until a run comes to its end. */
    private void untilItsEnd(
            LongWork work, LongWork.Place place, SplittableRandom random, long duration, Map<String, String> expected)
            throws Exception {
        Map<String, String> parts = Map.of();
        List<String> moments = new ArrayList<>();
        boolean ended = false;
        while (!ended) {
            // What was killed may go on to its end, every second time unless said otherwise.
            Kill kill = moments.isEmpty() || random.nextDouble() < AGAIN
                    ? Kill.draw(random, duration, Math.max(1, mostParts - work.finished(place)))
                    : Kill.NEVER;
            ended = run(work, place, kill);
            moments.add(ended ? "nothing" : kill.toString());
            String when = work + ", killed after " + moments;
            if (work.partsStay(place)) {
                Map<String, String> now = work.parts(place);
                assertThat(now).as(when + ": what was finished is as it was").containsAllEntriesOf(parts);
                parts = now;
            }
            if (!ended) {
                kills++;
                killsWithParts += parts.isEmpty() ? 0 : 1;
                partsKept += parts.size();
            }
        }
        assertSame(expected, work.result(place), work + ", killed after " + moments);
    }

    private static void assertSame(Map<String, String> expected, Map<String, String> actual, String when) {
        assertThat(actual.keySet()).as(when).isEqualTo(expected.keySet());
        expected.forEach((name, content) -> assertThat(actual.get(name).equals(content))
                .as(when + ": " + name + " is the same")
                .isTrue());
    }

    /** Runs the program in a process of its own; returns whether it came to its end before it was killed. */
    private boolean run(LongWork work, LongWork.Place place, Kill kill) throws IOException, InterruptedException {
        work.prepare(place);
        Path said = folder.resolve("said.txt");
        List<String> words = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Djava.awt.headless=true",
                "-XX:TieredStopAtLevel=1",
                "-Djogamp.gluegen.UseTempJarCache=" + System.getProperty("jogamp.gluegen.UseTempJarCache", "true"),
                "-Djava.library.path=" + System.getProperty("java.library.path", ""),
                "-cp",
                System.getProperty("java.class.path"),
                "sunbeam.app.Main"));
        words.addAll(work.command(place));
        ProcessBuilder builder = new ProcessBuilder(words)
                .directory(place.folder().toFile())
                .redirectErrorStream(true)
                .redirectOutput(said.toFile());
        builder.environment().put("XDG_CACHE_HOME", work.cache(place).toString());
        int before = work.finished(place);
        Process process = builder.start();
        try (UnfinishedColors.Watch watch = work.watch(place)) {
            long start = System.nanoTime();
            boolean ended = false;
            boolean killed = false;
            while (!ended && !killed) {
                ended = process.waitFor(LOOK_EVERY_MILLISECONDS, TimeUnit.MILLISECONDS);
                int parts = work.finished(place);
                mostParts = Math.max(mostParts, parts);
                killed = !ended && kill.isDue(System.nanoTime() - start, parts - before);
            }
            if (killed && kill.delayNanoseconds() > 0) {
                ended = process.waitFor(kill.delayNanoseconds(), TimeUnit.NANOSECONDS);
            }
            process.destroyForcibly().waitFor();
            assertThat(watch.complaint()).isEmpty();
            if (ended) {
                assertThat(process.exitValue()).as(Files.readString(said)).isZero();
            }
            return ended;
        }
    }

    /**
     * When a process is killed: when it has finished so many parts, or has worked for so long, whichever comes first; and
     * then a little later.
     */
    private record Kill(int parts, long afterNanoseconds, long delayNanoseconds) {
        static final Kill NEVER = new Kill(Integer.MAX_VALUE, TimeUnit.MINUTES.toNanos(MINUTES_OF_ONE_RUN), 0);
        /** About the time of a part. */
        private static final long LONGEST_DELAY = TimeUnit.MILLISECONDS.toNanos(300);

        /** One of four at any time from the start on, the others when there are finished parts. */
        static Kill draw(SplittableRandom random, long duration, int mostParts) {
            if (random.nextInt(4) == 0) {
                return new Kill(Integer.MAX_VALUE, random.nextLong(duration), 0);
            }
            return new Kill(random.nextInt(mostParts) + 1, NEVER.afterNanoseconds(), random.nextLong(LONGEST_DELAY));
        }

        boolean isDue(long nanoseconds, int finished) {
            return finished >= parts || nanoseconds >= afterNanoseconds;
        }

        @Override
        public String toString() {
            return parts == Integer.MAX_VALUE
                    ? String.format(Locale.ROOT, "%.3f s", afterNanoseconds * 1e-9)
                    : String.format(Locale.ROOT, "%d parts and %.3f s", parts, delayNanoseconds * 1e-9);
        }
    }
}
