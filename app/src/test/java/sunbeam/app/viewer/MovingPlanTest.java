package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SkinIndex;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.NmmMethod;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

class MovingPlanTest {
    private static final Patch SCAN = scan(60e-6);

    private static Patch scan(double width) {
        double[] heights = new double[64];
        heights[3] = 1e-7;
        return new Patch("scan", new HeightMap(8, 8, width / 8, width / 8, heights), "a test", List.of());
    }

    private static <T> Scene with(Setting<T> setting, T value) {
        Scene scene = ViewerInAWindow.scene();
        return scene.withMethod(scene.method().with(Choices.none().with(setting, value)));
    }

    @Test
    void anEnsembleByFullMovesByTables() {
        SceneMethod moving =
                MovingPlan.of(ViewerInAWindow.scene(), SCAN).orElseThrow().method();
        assertThat(moving.type()).isEqualTo(TableMethod.TYPE);
        assertThat(moving.get(MethodSettings.TOLERANCE)).isEqualTo(0.05);
        assertThat(MovingPlan.of(with(MethodSettings.TOLERANCE, 1e-3), SCAN)
                        .orElseThrow()
                        .method()
                        .get(MethodSettings.TOLERANCE))
                .as("nobody sees more while something moves")
                .isEqualTo(0.02);
    }

    @Test
    void whatHasNoSuchTablesDoesNot() {
        Scene scene = ViewerInAWindow.scene();
        assertThat(MovingPlan.of(with(MethodSettings.AVERAGE, Average.COHERENT), SCAN))
                .isEmpty();
        assertThat(MovingPlan.of(with(Methods.METHOD, NmmMethod.TYPE), SCAN)).isEmpty();
        assertThat(MovingPlan.of(with(Methods.METHOD, TableMethod.TYPE), SCAN))
                .as("has its own")
                .isEmpty();
        assertThat(MovingPlan.of(scene.withIndex(SkinIndex.of("gold.csv")), SCAN))
                .isEmpty();
        assertThat(MovingPlan.of(scene, scan(120e-6)))
                .as("a million bins and more")
                .isEmpty();
    }
}
