package sunbeam.app.terminal.progress;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

final class ProgressTest {
    private final ByteArrayOutputStream drawn = new ByteArrayOutputStream();
    private final AtomicLong nanoseconds = new AtomicLong();
    private final Pace pace = new Pace(nanoseconds::get);

    private Terminal terminal(boolean interactive) {
        return new Terminal(new PrintStream(drawn, true, StandardCharsets.US_ASCII), interactive, 60);
    }

    private String text() {
        return drawn.toString(StandardCharsets.US_ASCII);
    }

    @Test
    void whereNoTerminalIsALineStaysEveryTenSecondsAtMost() {
        try (ProgressLine line = new ProgressLine(terminal(false), nanoseconds::get, pace)) {
            for (int second = 0; second < 35; second++) {
                nanoseconds.set(Duration.ofSeconds(second).toNanos());
                line.accept("at " + second);
            }
        }
        assertThat(text().lines()).containsExactly("sunbeam: at 10", "sunbeam: at 20", "sunbeam: at 30");
    }

    @Test
    void shortTasksThatFollowEachOtherShareThePaceOfLinesThatStay() {
        for (int second = 0; second < 25; second += 3) {
            nanoseconds.set(Duration.ofSeconds(second).toNanos());
            try (ProgressLine line = new ProgressLine(terminal(false), nanoseconds::get, pace)) {
                nanoseconds.addAndGet(Progress.DELAY.toNanos());
                line.accept("task of second " + second);
            }
        }
        assertThat(text().lines()).containsExactly("sunbeam: task of second 9", "sunbeam: task of second 21");
    }

    @Test
    void aLongTaskIsToldInAPlainLineWhereNoTerminalIs() {
        try (Progress progress = Progress.start("rendering", 10, terminal(false), nanoseconds::get, pace)) {
            progress.step(5);
            nanoseconds.set(Pace.INTERVAL.toNanos());
        }
        // The bar's thread may have put the first line into words before the step; the first line that is due stays.
        assertThat(text()).matches("sunbeam: rendering: (0|50) %\\R");
    }

    @Test
    void aShortTaskDrawsNothing() {
        try (Progress progress = Progress.start("rendering", 10, terminal(true), nanoseconds::get, pace)) {
            progress.step(10);
        }
        assertThat(text()).isEmpty();
    }

    @Test
    void aLongTaskIsDrawnAndLeavesAnEmptyLine() {
        try (Progress progress = Progress.start("rendering", 10, terminal(true), nanoseconds::get, pace)) {
            nanoseconds.set(Progress.DELAY.toNanos());
            progress.step(5);
        }
        assertThat(text()).startsWith("\rrendering [").contains("50 %");
        assertThat(text()).endsWith("\r" + " ".repeat(59) + "\r").doesNotContain("\n");
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void nothingIsDrawnForWhoWantsItQuiet(boolean interactive) {
        Progress.setQuiet(true);
        try (Progress progress = Progress.start("rendering", 10, terminal(interactive), nanoseconds::get, pace)) {
            nanoseconds.set(Pace.INTERVAL.toNanos());
            progress.step(5);
        } finally {
            Progress.setQuiet(false);
        }
        assertThat(text()).isEmpty();
    }

    @Test
    void aShorterLineCoversALongerOne() {
        try (ProgressLine line = new ProgressLine(terminal(true), nanoseconds::get, pace)) {
            nanoseconds.set(Progress.DELAY.toNanos());
            line.accept("long line");
            line.accept("short");
        }
        assertThat(text()).isEqualTo("\rlong line\rshort    \r     \r");
    }

    @Test
    void ofATaskWithinATaskTheInnerOneIsDrawnUntilItEnds() {
        try (ProgressLine outer = new ProgressLine(terminal(true), nanoseconds::get, pace)) {
            nanoseconds.set(Progress.DELAY.toNanos());
            try (ProgressLine inner = new ProgressLine(terminal(true), () -> nanoseconds.get() * 2, pace)) {
                nanoseconds.set(2 * Progress.DELAY.toNanos());
                outer.accept("outer");
                inner.accept("inner");
            }
            assertThat(text()).isEqualTo("\rinner\r     \r");
            outer.accept("outer");
        }
        assertThat(text()).isEqualTo("\rinner\r     \r\router\r     \r");
    }

    @Test
    void nothingIsDrawnAfterTheEnd() {
        ProgressLine line = new ProgressLine(terminal(true), nanoseconds::get, pace);
        nanoseconds.set(Progress.DELAY.toNanos());
        line.close();
        line.accept("late");
        assertThat(text()).isEmpty();
    }

    private static Optional<Duration> seconds(long seconds) {
        return Optional.of(Duration.ofSeconds(seconds));
    }

    @Test
    void theLineHasAsMuchAsFits() {
        assertThat(TimeLeftRenderer.render("x", 0.25, seconds(30), 40))
                .isEqualTo("x [====>              ]  25 %, 30 s left")
                .hasSizeLessThanOrEqualTo(40);
        assertThat(TimeLeftRenderer.render("x", 0.5, seconds(90), 40)).endsWith(" 1:30 min left");
        assertThat(TimeLeftRenderer.render("x", 0.1, seconds(9 * 3600), 40)).endsWith(" 9:00 h left");
        assertThat(TimeLeftRenderer.render("x", 0.01, Optional.empty(), 40)).endsWith("]   1 %");
        assertThat(TimeLeftRenderer.render("Colors of a scan of a very long name", 0.25, seconds(30), 40))
                .isEqualTo("Colors of a scan of a..  25 %, 30 s left");
        assertThat(TimeLeftRenderer.render("x", 1, seconds(0), 40)).contains("=] 100 %");
        assertThat(TimeLeftRenderer.plain("x", 0.25, seconds(30))).isEqualTo("x: 25 %, 30 s left");
    }

    /** Of a task that takes 20 s before its first step and then a second for each hundredth. */
    @Test
    void theTimeLeftFollowsFromTheStepsAndNotFromWhatComesBeforeThem() {
        TimeLeft left = new TimeLeft();
        assertThat(left.at(0, Duration.ofSeconds(15))).isEmpty();
        assertThat(left.at(0.01, Duration.ofSeconds(21))).isEmpty();
        assertThat(left.at(0.04, Duration.ofSeconds(24))).isEmpty();
        assertThat(left.at(0.11, Duration.ofSeconds(31))).isEqualTo(seconds(89));
        assertThat(left.at(0.61, Duration.ofSeconds(81))).isEqualTo(seconds(39));
        assertThat(left.at(1, Duration.ofMinutes(2))).isEqualTo(seconds(0));
    }

    @Test
    void widthsBeyondReasonAreBounded() {
        assertThat(Terminal.columns("")).isEqualTo(80);
        assertThat(Terminal.columns("100")).isEqualTo(100);
        assertThat(Terminal.columns("-5")).isEqualTo(40);
        assertThat(Terminal.columns("99999")).isEqualTo(120);
    }
}
