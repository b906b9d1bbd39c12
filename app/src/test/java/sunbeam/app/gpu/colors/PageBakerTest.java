package sunbeam.app.gpu.colors;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.BitSet;
import java.util.List;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import java.util.function.LongConsumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.colortable.TableLevels;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;

@Timeout(60)
class PageBakerTest {
    private static final TableLevels LEVELS = TableLevels.within(
            1e-2,
            GaussianArea.STANDARD.with(CoherenceWindow.ofCoherenceLength(4e-6)).with(Average.ENSEMBLE),
            1e-7);

    private final Semaphore arrived = new Semaphore(0);

    /** @param source by what is to be told of progress */
    private static LevelSources sources(Function<LongConsumer, ColorSource> source) {
        return new LevelSources() {
            @Override
            public TableLevels levels() {
                return LEVELS;
            }

            @Override
            public ColorSource open(int level, LongConsumer done) {
                return source.apply(done);
            }
        };
    }

    /** Fails the first time. */
    private static LevelSources failingOnce(Throwable failure) {
        AtomicInteger calls = new AtomicInteger();
        return sources(done -> asked -> {
            if (calls.getAndIncrement() == 0 && failure instanceof Error error) {
                throw error;
            }
            if (calls.get() == 1 && failure instanceof RuntimeException exception) {
                throw exception;
            }
            return new float[asked.length];
        });
    }

    private void makesAfter(Throwable failure) throws InterruptedException {
        int page = LEVELS.slices() + 40;
        BitSet pages = new BitSet();
        pages.set(page);
        try (PageBaker baker = new PageBaker(new PageSources(failingOnce(failure)), arrived::release)) {
            baker.want(List.of(pages), List.of(new BitSet()));
            assertThat(arrived.tryAcquire(30, TimeUnit.SECONDS)).isTrue();
            assertThatThrownBy(baker::poll).isSameAs(failure);
            assertThat(baker.poll()).as("told once").isEmpty();

            baker.want(List.of(pages), List.of(new BitSet()));
            assertThat(arrived.tryAcquire(30, TimeUnit.SECONDS)).isTrue();
            PageBaker.Baked baked = baker.poll().orElseThrow();
            assertThat(baked.pages()).containsExactly(page);
            assertThat(baked.coefficients()).hasSize(1);
        }
    }

    @Test
    void whatFailedIsToldOnceAndMadeWhenItIsAskedForAgain() throws InterruptedException {
        makesAfter(new IllegalStateException("no colors"));
    }

    /** Counts its steps, and never ends but when it is told to. */
    private static LevelSources endless(AtomicInteger steps) {
        return sources(done -> asked -> {
            while (true) {
                steps.incrementAndGet();
                done.accept(0);
            }
        });
    }

    private static void awaitAStep(AtomicInteger steps) throws InterruptedException {
        int before = steps.get();
        while (steps.get() == before) {
            Thread.sleep(1);
        }
    }

    @Test
    void whatIsBeingMadePausesWhilePicturesAreDrawnAndEndsWithTheBaker() throws InterruptedException {
        AtomicInteger steps = new AtomicInteger();
        BitSet pages = new BitSet();
        pages.set(LEVELS.slices() + 40);
        try (PageBaker baker = new PageBaker(new PageSources(endless(steps)), arrived::release)) {
            baker.want(List.of(pages), List.of(new BitSet()));
            awaitAStep(steps);

            int checks = 0;
            while (checks < 20) {
                long start = System.nanoTime();
                baker.hold();
                int before = steps.get();
                Thread.sleep(10);
                int after = steps.get();
                // Later than that it may have gone on.
                if (System.nanoTime() - start < 200_000_000) {
                    // One that had begun.
                    assertThat(after).isBetween(before, before + 1);
                    checks++;
                }
            }
            awaitAStep(steps);
        }
        int atTheEnd = steps.get();
        Thread.sleep(50);
        assertThat(steps).hasValue(atTheEnd);
    }

    /** Whoever waits for colors does not pause for the pictures that it waits for, and nobody waits for the other. */
    @Test
    void whatSomebodyWaitsForIsMadeAtOnceBesideTheBackground() throws InterruptedException {
        AtomicInteger steps = new AtomicInteger();
        LevelSources stepping = sources(done -> asked -> {
            for (int i = 0; i < 100; i++) {
                steps.incrementAndGet();
                done.accept(0);
            }
            return new float[asked.length];
        });
        PageSources sources = new PageSources(stepping);
        try (PageBaker baker = new PageBaker(sources, arrived::release)) {
            int[] pages = sources.grids().get(0).reachable().stream().limit(400).toArray();
            for (int i = 0; i + 1 < pages.length; i += 2) {
                BitSet wanted = new BitSet();
                wanted.set(pages[i]);
                baker.want(List.of(wanted), List.of(new BitSet()));
                BitSet needed = new BitSet();
                needed.set(pages[i + 1]);
                sources.bakeAll(
                        List.of(needed), (level, made) -> assertThat(made).hasSize(1));
                baker.hold();
            }
            assertThat(steps).hasValueGreaterThan(100);
        }
    }

    private static LevelSources dark() {
        return sources(done -> asked -> new float[asked.length]);
    }

    private static BitSet page(int number) {
        BitSet page = new BitSet();
        page.set(number);
        return page;
    }

    @Test
    void whatNobodyWaitsForComesAfterWhatIsAskedFor() throws InterruptedException {
        PageSources sources = new PageSources(dark());
        int[] pages = sources.grids().get(0).reachable().stream().limit(3).toArray();
        try (PageBaker baker = new PageBaker(sources, arrived::release)) {
            List<BitSet> later = List.of(page(pages[0]));
            baker.want(List.of(page(pages[1])), later);
            assertThat(arrived.tryAcquire(30, TimeUnit.SECONDS)).isTrue();
            assertThat(baker.poll().orElseThrow().pages()).containsExactly(pages[1]);
            // At once, and not behind it.
            baker.want(List.of(page(pages[2])), later);
            assertThat(arrived.tryAcquire(30, TimeUnit.SECONDS)).isTrue();
            assertThat(baker.poll().orElseThrow().pages()).containsExactly(pages[2]);
            assertThat(arrived.tryAcquire(30, TimeUnit.SECONDS)).isTrue();
            assertThat(baker.poll().orElseThrow().pages()).containsExactly(pages[0]);
        }
    }

    @Test
    void soIsWhatFoundNoMemory() throws InterruptedException {
        makesAfter(new OutOfMemoryError("Java heap space"));
    }
}
