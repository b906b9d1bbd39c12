package sunbeam.app.cli.options;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;

class CertifyOptionTest {
    private static MethodPlan plan(double tolerance) {
        double[] heights = new double[32 * 32];
        Arrays.setAll(heights, i -> i % 32 < 16 ? 0 : 100e-9);
        HeightMap map = new HeightMap(32, 32, 100e-9, 100e-9, heights);
        return new FullMethod(TableChoices.within(tolerance), GaussianArea.STANDARD)
                .plan(Surface.of(new Patch("lines", map, "made up", List.of())), VisibleRange.all());
    }

    @Test
    void aFinerToleranceIsAdvisedOnlyWhereAPlanCanKeepIt() {
        assertThat(CertifyOption.remedy(Choices.none(), plan(1e-3))).startsWith("give a finer --tolerance");
        assertThat(CertifyOption.remedy(Choices.none(), plan(1e-5)))
                .startsWith("no finer --tolerance helps")
                .contains("--method reference");
    }
}
