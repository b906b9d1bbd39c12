package sunbeam.app.terminal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.work.Progress;

/** Lines of progress and sizes in bytes on the terminal. */
final class ProgressTest {
    private final ByteArrayOutputStream drawn = new ByteArrayOutputStream();
    private final AtomicLong nanoseconds = new AtomicLong();

    private ProgressDisplay display(boolean interactive) {
        return new ProgressDisplay(
                new PrintStream(drawn, true, StandardCharsets.US_ASCII), interactive, nanoseconds::get);
    }

    private String text() {
        return drawn.toString(StandardCharsets.US_ASCII);
    }

    @Test
    void withoutATerminalALineIsPrintedEveryTenSecondsAtMostAndAtTheEnd() {
        try (ProgressDisplay.Line line = display(false).new Line()) {
            for (int second = 0; second < 35; second++) {
                nanoseconds.set(Duration.ofSeconds(second).toNanos());
                line.accept("at " + second);
            }
        }
        assertThat(text().lines())
                .containsExactly("sunbeam: at 10", "sunbeam: at 20", "sunbeam: at 30", "sunbeam: at 34");
    }

    @Test
    void shortTasksThatFollowEachOtherShareThePaceOfLinesThatStay() {
        ProgressDisplay display = display(false);
        for (int second = 0; second < 25; second += 3) {
            nanoseconds.set(Duration.ofSeconds(second).toNanos());
            try (ProgressDisplay.Line line = display.new Line()) {
                nanoseconds.addAndGet(ProgressDisplay.DELAY.toNanos());
                line.accept("task of second " + second);
            }
        }
        assertThat(text().lines()).containsExactly("sunbeam: task of second 9", "sunbeam: task of second 21");
    }

    @Test
    void aShortTaskDrawsNothing() {
        try (Progress progress = display(true).start("rendering", 10)) {
            progress.step(10);
        }
        assertThat(text()).isEmpty();
    }

    @Test
    void aLongTaskIsDrawnAndLeavesAnEmptyLine() {
        try (Progress progress = display(true).start("rendering", 10)) {
            nanoseconds.set(ProgressDisplay.DELAY.toNanos());
            progress.step(5);
        }
        assertThat(text()).startsWith("\rrendering ").contains("50%");
        assertThat(text()).matches("(?s).*\r +\r").doesNotContain("\n");
    }

    @Test
    void aShorterLineCoversALongerOne() {
        try (ProgressDisplay.Line line = display(true).new Line()) {
            nanoseconds.set(ProgressDisplay.DELAY.toNanos());
            line.accept("long line");
            line.accept("short");
        }
        assertThat(text()).isEqualTo("\rlong line\rshort    \r     \r");
    }

    @Test
    void theInnerOfTwoTasksIsDrawnUntilItEnds() {
        ProgressDisplay display = display(true);
        try (ProgressDisplay.Line outer = display.new Line()) {
            nanoseconds.set(ProgressDisplay.DELAY.toNanos());
            try (ProgressDisplay.Line inner = display.new Line()) {
                nanoseconds.set(2 * ProgressDisplay.DELAY.toNanos());
                outer.accept("outer");
                inner.accept("inner");
            }
            assertThat(text()).isEqualTo("\rinner\r     \r");
            outer.accept("outer");
        }
        assertThat(text()).isEqualTo("\rinner\r     \r\router\r     \r");
    }

    @Test
    void programsInOneProcessShareNoState() {
        ProgressDisplay silent = display(true);
        silent.silence();
        try (ProgressDisplay.Line one = display(true).new Line();
                ProgressDisplay.Line other = display(true).new Line();
                Progress hidden = silent.start("hidden", 1)) {
            nanoseconds.set(ProgressDisplay.DELAY.toNanos());
            hidden.step(1);
            one.accept("one");
            other.accept("other");
            assertThat(text()).as("nothing of the silent one").isEqualTo("\rone\rother");
        }
    }

    @Test
    void nothingIsDrawnAfterTheEnd() {
        ProgressDisplay.Line line = display(true).new Line();
        nanoseconds.set(ProgressDisplay.DELAY.toNanos());
        line.close();
        line.accept("late");
        assertThat(text()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"0B, 0", "512 B, 512", "1kB, 1000", "1.5GB, 1500000000", "2 gb, 2000000000", "0.5 TB, 500000000000"})
    void unitsAreDecimal(String text, long bytes) {
        assertThat(ByteSize.parse(text)).isEqualTo(bytes);
    }

    @Test
    void invalidSizesAreReportedWithARemedy() {
        for (String wrong :
                new String[] {"", "1", "GB", "-1GB", "1,5GB", "1e3MB", "1 GBit", "1KiB", "2000000TB", "1..5GB"}) {
            assertThatThrownBy(() -> ByteSize.parse(wrong))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContainingAll("'" + wrong + "'", "give");
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 0 B", "999, 999 B", "1000, 1.0 kB", "999949, 999.9 kB", "999950, 1.0 MB", "8589934592, 8.6 GB"})
    void isWrittenInTheUnitThatFits(long bytes, String text) {
        assertThat(ByteSize.format(bytes)).isEqualTo(text);
    }
}
