package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.acceptance.Images;
import sunbeam.acceptance.InWorkplace;
import sunbeam.acceptance.SharedData;
import sunbeam.acceptance.SunbeamResult;

/** Periods of gratings: the interval includes the true period, and is narrow for a simple grating. */
class PeriodTest extends InWorkplace {
    private static final int MANY_WAVELENGTHS_MISSING = 100;

    private JsonNode inspect(String... patch) throws Exception {
        String[] all = new String[patch.length + 5];
        System.arraycopy(new String[] {"inspect", "--json", "--output", "sheet.png", "--patch"}, 0, all, 0, 5);
        System.arraycopy(patch, 0, all, 5, patch.length);
        SunbeamResult result = workplace.succeedHere(all);
        return new ObjectMapper().readTree(result.stdout());
    }

    /** A periodic height map has a whole number of periods. */
    @ParameterizedTest
    @CsvSource({"sinusoid, 2500", "blaze, 2500", "disc, 1600"})
    void aBuiltInGratingHasItsPeriod(String patch, double nanometers) throws Exception {
        JsonNode period = inspect(patch);

        // 0.05 %: whole nanometers would be enough.
        assertThat(1e9 * period.get("period_m").doubleValue()).isBetween(0.9995 * nanometers, 1.0005 * nanometers);
        assertThat(Math.abs(period.get("direction_deg").doubleValue())).isLessThan(0.1);
    }

    /** A scan of 12.3 noisy periods, at an angle. */
    @Test
    void theIntervalOfANoisyScanHoldsTheTruth() throws Exception {
        double period = 1234;
        double angle = Math.toRadians(20);
        SplittableRandom random = new SplittableRandom(5);
        double pitch = 60;
        Images.gray(workplace.resolve("scan.png"), 256, 256, (column, row) -> {
            double along = pitch * (column * Math.cos(angle) - row * Math.sin(angle));
            return (int)
                    Math.round(128 + 90 * Math.sin(2 * Math.PI * along / period) + 20 * (random.nextDouble() - 0.5));
        });

        JsonNode found = inspect("scan.png", "--width", "15.36um", "--max-height", "100nm", "--no-periodic");

        double low = 1e9 * found.get("period_low_m").doubleValue();
        double high = 1e9 * found.get("period_high_m").doubleValue();
        assertThat(low).isLessThan(period).isGreaterThan(0.95 * period);
        assertThat(high).isGreaterThan(period).isLessThan(1.05 * period);
        assertThat(found.get("direction_deg").doubleValue()).isBetween(19.0, 21.0);
    }

    /** The thesis measures 1144 nm along the fingers' rows and 1032 nm as the ensemble's mean; the period lies between them. */
    @Test
    void elapheIsToldAlikeByInspectAndEvaluate() throws Exception {
        String patch = SharedData.patch("elaphe").toString();
        JsonNode seen = inspect(patch);
        workplace.here(
                "evaluate",
                "--patch",
                patch,
                "--azimuth",
                "0",
                "--wavelengths",
                "380:780:" + MANY_WAVELENGTHS_MISSING,
                "--output",
                "result");
        JsonNode measured =
                new ObjectMapper().readTree(workplace.resolve("result.json").toFile());

        assertThat(seen.get("period_m").isNull() && measured.get("period_m").isNull())
                .as("no period at all")
                .isFalse();
        if (!seen.get("period_m").isNull()) {
            assertOverlapsThesis(
                    1e9 * seen.get("period_low_m").doubleValue(),
                    1e9 * seen.get("period_high_m").doubleValue());
        }
        if (!measured.get("period_m").isNull()) {
            assertOverlapsThesis(
                    1e9 * measured.get("period_low_m").doubleValue(),
                    1e9 * measured.get("period_high_m").doubleValue());
        }
    }

    private static void assertOverlapsThesis(double low, double high) {
        assertThat(low).isLessThan(1144).isGreaterThan(850);
        assertThat(high).isGreaterThan(1032).isLessThan(1400);
    }

    @Test
    void lightOnABlazedGratingTellsItsPeriod() throws Exception {
        workplace.succeedHere(
                "evaluate", "--patch", "blaze", "--azimuth", "0", "--wavelengths", "380:780:40", "--output", "result");
        JsonNode report =
                new ObjectMapper().readTree(workplace.resolve("result.json").toFile());

        // A peak is located within a hundredth of an order's width.
        assertThat(1e9 * report.at("/peaks_interpolated/mean_m").doubleValue()).isBetween(2498.0, 2502.0);
        assertThat(1e9 * report.at("/period_low_m").doubleValue()).isLessThanOrEqualTo(2501);
        assertThat(1e9 * report.at("/period_high_m").doubleValue()).isGreaterThanOrEqualTo(2499);
    }

    /** Period across the strongest wave: 1552 nm in the thesis, 1559.8 nm over all wavelengths here. */
    @Test
    void wavesAlongAGivenAzimuthAreTold() throws Exception {
        String patch = SharedData.patch("xenopeltis").toString();
        String options = "--preset thesis --theta-i 75 --azimuth 100 --window-origin centre --wavelengths 380:780:100";
        workplace.succeedHere(("evaluate --output result " + options + " --patch " + patch).split(" ", -1));
        JsonNode report =
                new ObjectMapper().readTree(workplace.resolve("result.json").toFile());

        // The ridge strays by a nanometer from one wavelength to the next.
        assertThat(1e9 * report.at("/peaks_interpolated/mean_m").doubleValue()).isBetween(1555.0, 1565.0);
        assertPeriodContains(report, 1450);
    }

    private static void assertPeriodContains(JsonNode report, double nanometers) {
        assertThat(1e9 * report.at("/period_low_m").doubleValue()).isLessThan(nanometers);
        assertThat(1e9 * report.at("/period_high_m").doubleValue()).isGreaterThan(nanometers);
    }

    @Test
    void noiseHasNoPeriod() throws Exception {
        SplittableRandom random = new SplittableRandom(3);
        Images.gray(workplace.resolve("noise.png"), 200, 200, (column, row) -> random.nextInt(256));

        JsonNode report = inspect("noise.png", "--width", "16um", "--max-height", "100nm", "--no-periodic");

        assertThat(report.get("period_m").isNull()).isTrue();
    }
}
