package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;

final class StartJournalTest {
    @Test
    void theFirstTimeCountsAndStagesStandInTheirOrder() {
        Instant start = Instant.EPOCH;
        AtomicReference<Instant> now = new AtomicReference<>(start.plusMillis(1200));
        StartJournal journal = new StartJournal(start, now::get);
        journal.reached(StartJournal.Stage.WINDOW);
        now.set(start.plusMillis(3400));
        journal.reached(StartJournal.Stage.WINDOW);
        journal.reached(StartJournal.Stage.COLORS);
        assertThat(journal.report())
                .isEqualTo("since the process began: window 1.2 s, first anti-aliased picture 3.4 s");
    }
}
