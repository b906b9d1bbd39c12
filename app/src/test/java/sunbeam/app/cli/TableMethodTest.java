package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;

/** Method table, and colors under several illuminants. */
@NeedsDisplay
class TableMethodTest {
    // A short window makes small tables.
    private static final String TABLE = "--coherence-length 6um --method table";

    @TempDir
    private Path home;

    private static double[] xyz(float[] color) {
        return new double[] {color[0], color[1], color[2]};
    }

    @Test
    void nothingRingsBesideTheSpecularPeak() {
        // Between the mirror order and the next one there is only its tail, down to 1e-9.
        MethodProbe probe = new MethodProbe(home, "--patch blaze");
        List<DirectionPair> skirt = IntStream.range(0, 30)
                .mapToDouble(i -> 0.002 * i)
                .mapToObj(sine -> new DirectionPair(new Direction(0, 0, 1), Direction.ofDisc(0.3 * sine, sine)))
                .toList();
        List<float[]> exact = probe.colors(skirt, "--tolerance 1e-4");
        List<float[]> table = probe.colors(skirt, "--method table --tolerance 1e-3");
        int[] lit = IntStream.range(0, skirt.size())
                .filter(i -> exact.get(i)[1] > 1e-8)
                .toArray();
        assertThat(IntStream.of(lit).mapToDouble(i -> exact.get(i)[1]).min().orElseThrow())
                .as("the wing's end")
                .isLessThan(1e-6);
        ErrorStatistics errors = ErrorStatistics.of(IntStream.of(lit)
                .mapToDouble(i -> new Comparison(xyz(table.get(i)), xyz(exact.get(i)), 1).relative())
                .toArray());
        assertThat(errors.keep(1e-3)).as("%s", errors).isTrue();
    }

    @Test
    void lightFromTheHorizonGivesNumbersEverywhere() {
        List<DirectionPair> grazing = IntStream.rangeClosed(0, 20)
                .mapToObj(i -> MethodProbe.inPlane(90, -4.5 * i))
                .toList();
        assertThat(probe().colors(grazing, TABLE + " --tolerance 1e-2"))
                .allMatch(xyz -> Float.isFinite(xyz[1]) && xyz[1] >= 0);
    }

    @Test
    void whatItHasNoAnswerForIsRefusedInOneLine() {
        assertThatThrownBy(() -> probe().powers(List.of(MethodProbe.inPlane(20, -10)), 500e-9, TABLE))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("column wavelength");
    }

    @Test
    void aTableThatHasNoRoomIsRefusedBeforeAnythingIsTakenForIt() {
        VisibleRange map = VisibleRange.of(new Direction(0, 0, 1));
        assertRefused(map, "10mm", "(?s).* layers, more than .*coarser --tolerance.*");
        assertRefused(map, "600um", "(?s).*need a texture of [0-9.]+ GB, more than .*");
        assertRefused(VisibleRange.all(), "10mm", "(?s).*texels along a side.*");
    }

    private void assertRefused(VisibleRange range, String coherenceLength, String message) {
        MethodProbe probe = new MethodProbe(home, "--patch blaze");
        assertThatThrownBy(() -> probe.plan(range, "--method table --coherence-length " + coherenceLength))
                .isInstanceOf(SettingException.class)
                .hasMessageMatching(message);
    }

    private MethodProbe probe() {
        return new MethodProbe(home, "--patch sinusoid");
    }

    /** Medians keep the tolerance of 1e-3. */
    @ParameterizedTest
    @CsvSource({
        "full, --illuminant=F11, ensemble",
        "full, --wavelengths=632.8nm, coherent",
        "full, --wavelengths=500nm..560nm, ensemble",
        "full, --illuminant=A, ensemble",
        "table, --illuminant=F11, ensemble",
        "table, --wavelengths=532nm, ensemble"
    })
    void colorsAreThoseOfTheReference(String method, String light, String average) {
        MethodProbe probe = probe();
        String options = "--method=" + method + " " + light + " --average=" + average + " --coherence-length=20um";
        Choices choices = CommandLine.populateCommand(new MethodOptions(), MethodProbe.words(options))
                .choices();
        ExactLight exact = probe.setup().withLight(LightTable.of(choices)).exact(Methods.of(choices));
        List<DirectionPair> pairs = MethodProbe.gratingPlane(13);

        List<float[]> colors = probe.colors(pairs, options);

        double brightest = colors.stream().mapToDouble(color -> color[1]).max().orElseThrow();
        for (int i = 0; i < colors.size(); i++) {
            double[] expected = exact.xyz(pairs.get(i), ExactLight.Quadrature.INTEGRATED);
            float[] rounded = {(float) expected[0], (float) expected[1], (float) expected[2]};
            double error = MethodProbe.relativeError(colors.get(i), rounded);
            // Three times the tolerance, relative to at least a thousandth of the brightest color.
            assertThat(error).isLessThanOrEqualTo(3e-3 * Math.max(1, 1e-3 * brightest / expected[1]));
        }
    }

    private static DirectionPair at(double sine) {
        return MethodProbe.inPlane(0, Math.toDegrees(Math.asin(sine)));
    }

    @ParameterizedTest
    @CsvSource({"nmm", "gem"})
    void whatSeesOneWavelengthAnOrderRefusesLines(String method) {
        assertThatThrownBy(() -> probe().colors(List.of(at(0.2)), "--method=" + method + " --illuminant=F11"))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("has lines");
    }
}
