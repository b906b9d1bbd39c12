package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLoader;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.plan.MethodSettings;

/** Loads that overtake each other; no window. */
@Timeout(60)
class ViewerModelTest {
    @TempDir
    private Path folder;

    private final Background background = new Background("loading");
    private final CountDownLatch begun = new CountDownLatch(1);
    private final CountDownLatch mayEnd = new CountDownLatch(1);
    private final List<String> problems = new ArrayList<>();
    private ViewerModel model;

    private final class Listener implements ViewerModel.Listener {
        @Override
        public void changed() {}

        @Override
        public void loading(double share) {}

        @Override
        public void problem(String message) {
            problems.add(message);
        }
    }

    @BeforeEach
    void load() throws Exception {
        SceneLoader loader =
                new SceneLoader(new Environment(Map.of("XDG_CACHE_HOME", folder.toString()), folder), warning -> {});
        onEvents(() -> {
            model = new ViewerModel(
                    ViewerInAWindow.scene(), (next, previous, progress) -> loaded(loader, next, previous), background);
            model.setListener(new Listener());
            model.start();
            return null;
        });
        awaitLoads();
    }

    @AfterEach
    void close() {
        background.close();
    }

    /** The patch sinusoid takes until it may end. */
    private LoadedScene loaded(SceneLoader loader, Scene next, LoadedScene previous) {
        if (next.patch().patch().equals("sinusoid")) {
            begun.countDown();
            try {
                assertThat(mayEnd.await(30, TimeUnit.SECONDS)).isTrue();
            } catch (InterruptedException interrupted) {
                throw new IllegalStateException(interrupted);
            }
        }
        return LoadedScene.load(loader, next, previous);
    }

    private static <T> T onEvents(Callable<T> work) throws Exception {
        FutureTask<T> task = new FutureTask<>(work);
        SwingUtilities.invokeLater(task);
        return task.get();
    }

    private void awaitLoads() throws Exception {
        // What comes of a load may begin another one.
        for (int load = 0; load < 3; load++) {
            CountDownLatch reached = new CountDownLatch(1);
            background.run(() -> "", done -> reached.countDown(), problem -> {});
            assertThat(reached.await(30, TimeUnit.SECONDS)).isTrue();
        }
    }

    private void patch(String name) throws Exception {
        onEvents(() -> {
            model.change(scene -> scene.withPatch(PatchRequest.of(name)));
            return null;
        });
    }

    private String drawn() throws Exception {
        return onEvents(
                () -> model.loaded().orElseThrow().fine().scene().patch().patch());
    }

    /** Wants sinusoid, then another while that is being loaded. */
    private void overtakeBy(String name) throws Exception {
        patch("sinusoid");
        assertThat(begun.await(30, TimeUnit.SECONDS)).isTrue();
        patch(name);
        mayEnd.countDown();
        awaitLoads();
    }

    @Test
    void aPatchThatFailsToLoadLeavesTheOneBeforeItInPlaceEvenIfThatWasStillBeingLoaded() throws Exception {
        overtakeBy(folder.resolve("missing.json").toString());

        assertThat(drawn()).isEqualTo("sinusoid");
        assertThat(onEvents(() -> model.scene().patch().patch())).isEqualTo("sinusoid");
        assertThat(onEvents(() -> problems)).hasSize(1).first().asString().contains("missing.json");
    }

    @Test
    void aCoherenceLengthBelowThePatchsSamplesIsRefusedInThePlannersWords() throws Exception {
        Scene before = onEvents(() -> model.scene());
        onEvents(() -> {
            // Its samples are 65 um / 1024 apart; a Gaussian of 150 nm has fewer than three of them.
            model.change(scene -> scene.withPatch(PatchRequest.of("elaphe-like"))
                    .withMethod(
                            new SceneMethod(scene.method().choices().with(MethodSettings.COHERENCE_LENGTH, 150e-9))));
            return null;
        });
        awaitLoads();

        assertThat(onEvents(() -> problems))
                .singleElement()
                .asString()
                .contains("150 nm is less than")
                .doesNotContain("internal error");
        assertThat(onEvents(() -> model.scene())).isEqualTo(before);
    }
}
