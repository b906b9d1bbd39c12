package sunbeam.app.viewer.loop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.fail;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import jrtr.Tile;
import org.joml.Vector3f;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.render.InAScene;
import sunbeam.app.render.Pick;
import sunbeam.app.render.SceneData;
import sunbeam.app.render.SceneShape;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.viewer.ViewerInAWindow;
import sunbeam.app.viewer.model.LoadedScene;

/** Order of the render thread's work, with a simulated clock and a stage that draws nothing and lets events happen during its work. */
final class RenderLoopTest {
    @TempDir
    private static Path folder;

    private static List<LoadedScene> scenes;

    @BeforeAll
    static void load() {
        SceneData one = InAScene.parts(ViewerInAWindow.scene(), folder).get(0);
        // Equal scenes are different objects, as when the light moves.
        scenes = IntStream.range(0, 3)
                .mapToObj(i -> one.scene().withLight(new SceneLight(new Vector3f(i, 0, 1).normalize(), 1, 0)))
                .map(lit -> new LoadedScene(List.of(one.with(lit))))
                .toList();
    }

    @Test
    void theLastPictureIsTheFinalOneOfTheNewestState() {
        IntStream.range(0, 10_000)
                .forEach(seed -> assertThatCode(() -> new Sequence(seed).run())
                        .as("seed %d", seed)
                        .doesNotThrowAnyException());
    }

    /** One sequence of states, tasks, tiles, failures and the end. */
    @SuppressWarnings("ReferenceEquality") // the same request, not an equal one
    private static final class Sequence implements Stage, RenderLoop.Listener {
        private final SplittableRandom random;
        private final boolean isByTable;
        private final RenderLoop loop;
        private long now = 1_000_000_000;
        private Runnable arrived = () -> {};
        // State of the stage: drawn state and tiles.
        private ViewState current;
        private boolean isCoarsestThere;
        private int missing;
        private int untaken;
        private boolean isInteractive;
        private int finerPictures;
        private boolean isBusy;
        private boolean isOver;
        private boolean isClosed;
        // State of the listener.
        private ViewState asked;
        private ViewState shown;
        private boolean isFinal;
        private boolean isRefused;
        private int tasks;
        private int tasksDone;

        Sequence(int seed) {
            random = new SplittableRandom(seed);
            isByTable = random.nextBoolean();
            loop = new RenderLoop(() -> this, news -> news.accept(this), () -> now);
        }

        void run() {
            if (random.nextBoolean()) {
                loop.showBody(scenes.get(0).firstPart().scene(), () -> null, 8, 8);
            }
            for (int step = 3 + random.nextInt(40); step > 0; step--) {
                act();
            }
            isOver = true;
            int turns = 0;
            for (; !isClosed && (loop.pause() < Long.MAX_VALUE || turns < 3 || tilesCome()); turns++) {
                assertThat(turns).as("turns without an end").isLessThan(200);
                now += Math.max(0, Math.min(loop.pause(), 1_000_000_000));
                loop.turn(this);
            }
            if (isClosed) {
                return;
            }
            assertThat(tasksDone).as("tasks").isEqualTo(tasks);
            if (asked != null && !isRefused) {
                assertThat(loop.phase).isEqualTo(RenderLoop.Phase.COMPLETE);
                assertThat(shown).as("newest").isSameAs(asked);
                assertThat(isFinal).as("final").isTrue();
                assertThat(isInteractive).isFalse();
            }
        }

        private void act() {
            switch (random.nextInt(10)) {
                case 0, 1 -> ask();
                case 2 -> {
                    tasks++;
                    loop.submit(stage -> {
                        tasksDone++;
                        if (random.nextInt(5) == 0) {
                            throw new IllegalStateException("task");
                        }
                    });
                }
                case 3 -> tilesCome();
                case 4 -> now += random.nextLong(2 * RenderLoop.STILL_NANOSECONDS);
                case 5 -> {
                    if (random.nextInt(30) == 0) {
                        isClosed = true;
                        loop.close();
                    }
                }
                default -> {
                    if (!isBusy && !isClosed) {
                        loop.turn(this);
                    }
                }
            }
        }

        private void ask() {
            asked = new ViewState(
                    scenes.get(random.nextInt(scenes.size())), random.nextInt(2), 8, 8, random.nextInt(3) == 0);
            isFinal = false;
            isRefused = false;
            loop.show(asked);
        }

        /** Delivers a tile; returns false if none is missing. */
        private boolean tilesCome() {
            boolean isDone = isCoarsestThere && (isInteractive || missing == untaken);
            if (!isByTable || isDone) {
                return false;
            }
            untaken++;
            arrived.run();
            return true;
        }

        private void meanwhile() {
            isBusy = true;
            for (int i = isOver ? 0 : random.nextInt(3); i > 0; i--) {
                act();
            }
            isBusy = false;
        }

        private void mayFail() {
            if (random.nextInt(60) == 0) {
                throw new IllegalStateException("broken");
            }
        }

        @Override
        public BufferedImage body(Scene scene, SceneShape shape, int width, int height) {
            mayFail();
            assertThat(current).as("state drawn before the body").isNull();
            return new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        }

        @Override
        public void update(ViewState next, Runnable told) {
            mayFail();
            if (current == null || !next.showsThePictureOf(current)) {
                missing = 0;
            }
            current = next;
            arrived = told;
        }

        @Override
        public void interactive(boolean value) {
            isInteractive = value;
        }

        @Override
        public boolean takeTiles() {
            mayFail();
            boolean some = untaken > 0;
            if (!isCoarsestThere && some) {
                isCoarsestThere = true;
                untaken--;
            }
            missing = Math.max(0, missing - untaken);
            untaken = 0;
            return some;
        }

        private Optional<Preview> preview() {
            mayFail();
            meanwhile();
            return Optional.of(new Preview(image(), 1, true, 1, 0, OptionalInt.empty()));
        }

        private BufferedImage image() {
            return new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
        }

        @Override
        public Optional<Preview> moving(BooleanSupplier interrupted) {
            finerPictures = 2;
            return preview();
        }

        @Override
        public Optional<Preview> byTiles() {
            return isByTable ? preview() : Optional.empty();
        }

        @Override
        public Optional<Preview> finer(BooleanSupplier interrupted) {
            Optional<Preview> finer = isByTable || finerPictures == 0 ? Optional.empty() : preview();
            finerPictures--;
            return interrupted.getAsBoolean() ? Optional.empty() : finer;
        }

        @Override
        public double coarsestShare() {
            return isCoarsestThere || !isByTable ? 1 : 0;
        }

        @Override
        public boolean request(BooleanSupplier interrupted) {
            assertThat(isInteractive).isFalse();
            meanwhile();
            missing = isByTable ? random.nextInt(4) : 0;
            untaken = 0;
            return !interrupted.getAsBoolean();
        }

        @Override
        public double requestedShare() {
            return missing == 0 ? 1 : 0.5;
        }

        @Override
        public Optional<Final> refine(BooleanSupplier interrupted, PartListener drawn) {
            assertThat(missing).as("missing tiles").isZero();
            for (int part = 0; part < 3; part++) {
                mayFail();
                meanwhile();
                if (interrupted.getAsBoolean()) {
                    return Optional.empty();
                }
                drawn.drawn(Tile.whole(1, 1), image(), 0.3 * part);
            }
            return Optional.of(new Final(image(), 1, OptionalInt.empty()));
        }

        @Override
        public void map(
                MapRequest request,
                boolean isFinal,
                BooleanSupplier interrupted,
                BiConsumer<BufferedImage, Boolean> drawn) {
            throw new UnsupportedOperationException();
        }

        @Override
        public void prefetch() {
            assertThat(isInteractive).isFalse();
        }

        @Override
        public String renderer() {
            throw new UnsupportedOperationException();
        }

        @Override
        public BufferedImage strokes(int width, int height) {
            throw new UnsupportedOperationException();
        }

        @Override
        public Optional<Pick> pick(int x, int y, int width, int height) {
            throw new UnsupportedOperationException();
        }

        @Override
        public void close() {
            // nothing is open
        }

        @Override
        public void opened(String renderer) {
            fail("is opened by a thread");
        }

        @Override
        public void failed(String message) {
            fail(message);
        }

        @Override
        public void refused(String message) {
            assertThat(message).as("refuses the picture").doesNotContain("task");
            isRefused = true;
        }

        @Override
        public void problem(String message) {
            // the picture goes on
        }

        @Override
        public void body(BufferedImage image) {
            assertThat(shown).as("picture before the body").isNull();
        }

        @Override
        public void preview(ViewState state, Preview preview) {
            assertNotAfterTheFinalOne(state);
            shown = state;
        }

        @Override
        public void complete(RenderLoop.Finished finished) {
            // A state requested meanwhile shows the same picture, or is drawn next.
            shown = finished.state();
            isFinal = shown == asked;
        }

        @Override
        public void waiting(double share) {
            assertThat(share).isLessThan(1);
        }

        @Override
        public void tile(ViewState of, BufferedImage image, int x, int y, double shareDone) {
            assertNotAfterTheFinalOne(current);
        }

        private void assertNotAfterTheFinalOne(ViewState state) {
            assertThat(isFinal && state == shown).as("after the final picture").isFalse();
        }
    }
}
