package sunbeam.app.cli.brdfmap;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import sunbeam.app.cli.options.MethodOptions;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.setting.Choices;

class MapSheetTest {
    private static final Choices ASKED =
            new CommandLine(new MethodOptions()).<MethodOptions>getCommand().choices();
    private static final Direction LIGHT = Direction.ofDegrees(30, 0);

    /** Returns a scan of 20 x 10 um. */
    private static Patch scan(Patch.Repetition repetition) {
        double[] heights = new double[32 * 16];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = 1e-8 * (i * i % 7);
        }
        HeightMap map = new HeightMap(32, 16, 20e-6 / 32, 10e-6 / 16, heights);
        return new Patch("scan", map, map, "made up", List.of(), List.of(), List.of(), List.of(), repetition);
    }

    @Test
    void whatIsNotAsByDefaultIsToldAndNothingElse() {
        assertThat(caption(Patch.Repetition.NONE, "refractive index 0.97+6.5i; "))
                .contains("; refractive index 0.97+6.5i; coherence length 10 um (the scan's height), ");
        assertThat(caption(Patch.Repetition.PERIODIC, ""))
                .contains("azimuth 0\u00b0; coherence length 10 um, ")
                .endsWith("; exposure 2");
    }

    private static String caption(Patch.Repetition repetition, String remarks) {
        MaterialMap.Result map =
                new MaterialMap.Result(scan(repetition), LIGHT, Methods.of(ASKED), "", "", 10e-6, null);
        return String.join("; ", MapSheet.caption(map, remarks, ASKED, "exposure 2"));
    }
}
