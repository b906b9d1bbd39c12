package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class SparingTest {
    @Test
    void halfOfTheProcessorsAreLeftToOthers() {
        Set<Thread> threads = ConcurrentHashMap.newKeySet();
        long sum = Sparing.call(() -> IntStream.range(0, 100_000)
                .parallel()
                .peek(i -> threads.add(Thread.currentThread()))
                .asLongStream()
                .sum());
        assertThat(sum).isEqualTo(100_000L * 99_999 / 2);
        assertThat(threads)
                .hasSizeBetween(1, Math.max(1, Runtime.getRuntime().availableProcessors() / 2))
                .doesNotContain(Thread.currentThread());
    }

    @Test
    void itPausesUntilNothingHasMovedForAWhile() {
        Sparing sparing = new Sparing();
        long start = System.nanoTime();
        sparing.pause();
        assertThat(System.nanoTime() - start).as("nothing moves").isLessThan(1_000_000_000L);
        sparing.hold();
        long held = System.nanoTime();
        sparing.pause();
        // No sooner than it says; later, machines may be busy.
        assertThat(System.nanoTime() - held).isGreaterThan(1_400_000_000L);
    }

    @Test
    void whatGoesWrongIsThrownAsItIs() {
        RuntimeException problem = new IllegalStateException("no table");
        assertThatThrownBy(() -> Sparing.call(() -> {
                    throw problem;
                }))
                .isSameAs(problem);
        Error noMemory = new OutOfMemoryError("Java heap space");
        assertThatThrownBy(() -> Sparing.call(() -> {
                    throw noMemory;
                }))
                .isSameAs(noMemory);
    }
}
