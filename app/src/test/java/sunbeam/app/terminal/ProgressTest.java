package sunbeam.app.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import sunbeam.app.terminal.ProgressDisplay.Progress;

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
        ProgressDisplay silent = display(true).silence();
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
}
