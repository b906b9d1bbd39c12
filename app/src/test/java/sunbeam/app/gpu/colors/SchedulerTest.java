package sunbeam.app.gpu.colors;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.fail;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import sunbeam.app.work.CancellationToken;

/** The scheduler on an executor that the test controls; events may occur during its work. */
final class SchedulerTest {
    private static final int LEVELS = 3;
    private static final int TILES = 12;

    @Test
    void nothingIsLostMadeTwiceOrMadeAfterTheEnd() {
        IntStream.range(0, 10_000)
                .forEach(seed -> assertThatCode(() -> new Interleaving(seed).run())
                        .as("seed %d", seed)
                        .doesNotThrowAnyException());
    }

    @Test
    void aTaskForIdleTimesDoesNotWaitForPrefetching() {
        ArrayDeque<Runnable> queue = new ArrayDeque<>();
        List<String> done = new ArrayList<>();
        CancellationToken token = new CancellationToken();
        Scheduler[] scheduler = new Scheduler[1];
        scheduler[0] = new Scheduler(
                new Scheduler.TileBaker() {
                    @Override
                    public Scheduler.BakedTiles bake(TileSet missing, CancellationToken baking) {
                        scheduler[0].whenIdle(token, () -> done.add("task"));
                        done.add(baking.isCancelled() ? "prefetching canceled" : "prefetching goes on");
                        throw new CancellationException();
                    }

                    @Override
                    public void close() {}
                },
                queue::add,
                () -> {});
        TileSet all = TileSet.none(LEVELS);
        all.of(0).set(0, TILES);
        scheduler[0].request(List.of(TileSet.none(LEVELS), TileSet.none(LEVELS), all));
        queue.remove().run();
        queue.remove().run();
        assertThat(done).containsExactly("prefetching canceled", "task");
    }

    /** One interleaving of requests, jobs, failures and the end. */
    private static final class Interleaving implements Scheduler.TileBaker {
        private final SplittableRandom random;
        private final ArrayDeque<Runnable> queue = new ArrayDeque<>();
        private final Scheduler scheduler;
        private final TileSet resident = TileSet.none(LEVELS);
        private List<TileSet> request = List.of();
        private boolean isInteractive;
        private boolean isClosed;
        private boolean isMakerClosed;
        private boolean isBusy;
        private boolean isTold;
        private boolean isOver;
        // Failures since the last request, and those that were taken.
        private int failures;
        private int reported;
        private int idle;
        private int idleDone;

        Interleaving(int seed) {
            random = new SplittableRandom(seed);
            scheduler = new Scheduler(this, queue::add, () -> {
                assertUnlocked();
                isTold = true;
            });
        }

        void run() {
            for (int step = random.nextInt(60); step > 0; step--) {
                act();
            }
            isOver = true;
            interactive(false);
            // Each turn bakes a tile, fails, runs a task, or is the last.
            for (int turns = 0; !queue.isEmpty(); turns++) {
                assertThat(turns).as("turns without an end").isLessThan(1000);
                queue.remove().run();
            }
            if (isClosed) {
                assertThat(isMakerClosed).as("closed").isTrue();
                assertThat(scheduler.poll()).isEmpty();
                return;
            }
            // Only failures that this test caused may be reported.
            boolean wasTold = isTold;
            int before = reported;
            take();
            assertThat(wasTold || reported == before).as("told of a failure").isTrue();
            assertThat(reported).as("failures that were reported").isGreaterThanOrEqualTo(Math.min(1, failures));
            assertThat(idleDone).as("tasks for idle times ").isEqualTo(idle);
            if (failures == 0) {
                assertThat(request).allMatch(wanted -> wanted.without(resident).isEmpty());
            }
        }

        private void act() {
            switch (random.nextInt(12)) {
                case 0, 1, 2 -> request();
                case 3 -> interactive(random.nextBoolean());
                case 4 -> take();
                case 5 -> idle();
                case 6 -> {
                    if (random.nextInt(8) == 0) {
                        isClosed = true;
                        scheduler.close();
                    }
                }
                default -> {
                    if (!isBusy && !queue.isEmpty()) {
                        queue.remove().run();
                    }
                }
            }
        }

        private void request() {
            request = List.of(someTiles(), someTiles(), someTiles());
            failures = 0;
            reported = 0;
            scheduler.request(
                    request.stream().map(tiles -> tiles.without(resident)).toList());
        }

        private TileSet someTiles() {
            TileSet tiles = TileSet.none(LEVELS);
            for (int i = random.nextInt(8); i > 0; i--) {
                tiles.of(random.nextInt(LEVELS)).set(random.nextInt(TILES));
            }
            return tiles;
        }

        private void interactive(boolean value) {
            isInteractive = value;
            scheduler.interactive(value);
        }

        private void idle() {
            if (!isClosed) {
                idle++;
            }
            scheduler.whenIdle(new CancellationToken(), () -> {
                assertUnlocked();
                assertThat(isClosed || isInteractive).as("idle").isFalse();
                idleDone++;
            });
        }

        private void take() {
            isTold = false;
            try {
                for (Optional<Scheduler.BakedTiles> made = scheduler.poll();
                        made.isPresent();
                        made = scheduler.poll()) {
                    BitSet tiles = made.get().tiles();
                    assertThat(resident.of(made.get().level()).intersects(tiles))
                            .as("made twice")
                            .isFalse();
                    resident.of(made.get().level()).or(tiles);
                }
            } catch (BrokenException failure) {
                reported++;
            }
        }

        @Override
        public Scheduler.BakedTiles bake(TileSet missing, CancellationToken token) {
            assertThat(isClosed || isBusy).as("closed, or made beside others").isFalse();
            List<Integer> levels = new ArrayList<>();
            for (int level = 0; level < LEVELS; level++) {
                if (!missing.of(level).isEmpty()) {
                    levels.add(level);
                }
            }
            assertThat(levels).as("levels of what is missing").isNotEmpty();
            int level = levels.get(random.nextInt(levels.size()));
            BitSet some = new BitSet();
            missing.of(level).stream().limit(1 + random.nextInt(3)).forEach(some::set);
            assertWanted(level, some);
            assertUnlocked();
            meanwhile();
            if (token.isCancelled() && random.nextInt(4) > 0) {
                throw new CancellationException();
            }
            if (random.nextInt(20) == 0) {
                // A canceled job is tried again, and fails then.
                failures += token.isCancelled() ? 0 : 1;
                throw new BrokenException();
            }
            return new Scheduler.BakedTiles(level, some, List.of());
        }

        /** No stale frame: a job belongs to the latest request, and its priority may be baked now. */
        private void assertWanted(int level, BitSet some) {
            List<TileSet> allowed = isInteractive ? request.subList(0, 1) : request;
            assertThat(allowed.stream().anyMatch(tiles -> {
                        BitSet rest = (BitSet) some.clone();
                        rest.andNot(tiles.of(level));
                        return rest.isEmpty();
                    }))
                    .as("asked for")
                    .isTrue();
        }

        private void meanwhile() {
            isBusy = true;
            for (int i = isOver ? 0 : random.nextInt(3); i > 0; i--) {
                act();
            }
            isBusy = false;
        }

        private void assertUnlocked() {
            assertThat(Thread.holdsLock(scheduler)).as("locked").isFalse();
        }

        @Override
        public void close() {
            if (isMakerClosed || !isClosed) {
                fail("closed twice or early");
            }
            assertUnlocked();
            isMakerClosed = true;
        }
    }

    private static final class BrokenException extends IllegalStateException {
        private static final long serialVersionUID = 1;
    }
}
