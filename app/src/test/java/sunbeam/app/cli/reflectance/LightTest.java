package sunbeam.app.cli.reflectance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import sunbeam.app.cli.options.MethodOptions;
import sunbeam.app.files.input.LightTable;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;

/** Compares colors under several illuminants with the exact reference and the grating equation. */
class LightTest {
    private static final double PERIOD = 2.5e-6;

    @TempDir
    private Path home;

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

        double brightest = 0;
        for (float[] color : colors) {
            brightest = Math.max(brightest, color[1]);
        }
        for (int i = 0; i < colors.size(); i++) {
            double[] expected = exact.xyz(pairs.get(i), ExactLight.Quadrature.INTEGRATED);
            float[] rounded = {(float) expected[0], (float) expected[1], (float) expected[2]};
            double error = MethodProbe.relativeError(colors.get(i), rounded);
            // Three times the tolerance, relative to at least a thousandth of the brightest color.
            assertThat(error).isLessThanOrEqualTo(3e-3 * Math.max(1, 1e-3 * brightest / expected[1]));
        }
    }

    @Test
    void aLaserIsSeenWhereTheGratingEquationSendsIt() {
        double sine = 532e-9 / PERIOD;
        List<DirectionPair> pairs = List.of(at(sine), at(sine - 0.1), at(sine + 0.1));

        List<float[]> colors = probe().colors(pairs, "--wavelengths=532nm --coherence-length=20um");

        // sigma_f is 0.032 / um, so that an order's power has a deviation of 0.012 in u: exp(-0.5 (0.1 / 0.012)^2) is
        // 1e-15.
        assertThat(colors.get(0)[1]).isGreaterThan(1e4f * colors.get(1)[1]).isGreaterThan(1e4f * colors.get(2)[1]);
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
