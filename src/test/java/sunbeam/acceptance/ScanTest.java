package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Periods of gratings, and files of instruments that lack units or are damaged. */
class ScanTest extends InWorkplace {
    private JsonNode inspect(Object patch, String options) throws Exception {
        return workplace.json("inspect --json --output sheet.png --patch %s" + options, patch);
    }

    /** A periodic height map has a whole number of periods. */
    @ParameterizedTest
    @CsvSource({"sinusoid, 2500", "blaze, 2500", "disc, 1600"})
    void aBuiltInGratingHasItsPeriod(String patch, double nanometers) throws Exception {
        JsonNode period = inspect(patch, "");

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

        JsonNode found = inspect("scan.png", " --width 15.36um --max-height 100nm --no-periodic");

        double low = 1e9 * found.get("period_low_m").doubleValue();
        double high = 1e9 * found.get("period_high_m").doubleValue();
        assertThat(low).isLessThan(period).isGreaterThan(0.95 * period);
        assertThat(high).isGreaterThan(period).isLessThan(1.05 * period);
        assertThat(found.get("direction_deg").doubleValue()).isBetween(19.0, 21.0);
    }

    /** The thesis measures 1144 nm along the fingers' rows and 1032 nm as the ensemble's mean; the period lies between them. */
    @Test
    void elapheIsToldAlikeByInspectAndEvaluate() throws Exception {
        Path patch = SharedData.patch("elaphe");
        JsonNode seen = inspect(patch, "");
        workplace.here("evaluate --patch %s --azimuth 0 --wavelengths 380:780:100 --output result", patch);
        JsonNode measured = workplace.readJson("result.json");

        List<JsonNode> periods = Stream.of(seen, measured)
                .filter(report -> !report.get("period_m").isNull())
                .toList();
        assertThat(periods).as("reports with a period").isNotEmpty().allSatisfy(report -> {
            assertThat(1e9 * report.get("period_low_m").doubleValue()).isBetween(850.0, 1144.0);
            assertThat(1e9 * report.get("period_high_m").doubleValue()).isBetween(1032.0, 1400.0);
        });
    }

    /** Period across the strongest wave: 1552 nm in the thesis, 1559.8 nm over all wavelengths here. */
    @Test
    void wavesAlongAGivenAzimuthAreTold() throws Exception {
        workplace.succeedHere(
                "evaluate --output result --preset thesis --theta-i 75 --azimuth 100 --window-origin centre"
                        + " --wavelengths 380:780:100 --patch %s",
                SharedData.patch("xenopeltis"));
        JsonNode report = workplace.readJson("result.json");

        // The ridge strays by a nanometer from one wavelength to the next.
        assertThat(1e9 * report.at("/peaks_interpolated/mean_m").doubleValue()).isBetween(1555.0, 1565.0);
        assertThat(1e9 * report.at("/period_low_m").doubleValue()).isLessThan(1450);
        assertThat(1e9 * report.at("/period_high_m").doubleValue()).isGreaterThan(1450);
    }

    private SunbeamResult inspectScan(String name, String options) throws Exception {
        return workplace.here(
                "inspect %s --level=none --periodic --json --output sheet.png" + options,
                SharedData.present("scans/" + name));
    }

    /** Files without units are refused; the message names the missing option, with which they are read. */
    @ParameterizedTest
    @CsvSource({"test.gwy, 128", "matrix-5.txt, 10", "xyz-1.txt, 4", "xyz-2.txt, 4"})
    void whatHasNoUnitsIsReadOnceTheyAreGiven(String name, int columns) throws Exception {
        inspectScan(name, "").complains(SunbeamResult.UNUSABLE_INPUT, name, "--width", "--height-unit");

        SunbeamResult result = inspectScan(name, " --width=20um --height-unit=nm");

        assertThat(result.exitCode()).as("%s", result).isIn(0, 3);
        JsonNode read = new ObjectMapper().readTree(result.stdout());
        assertThat(read.get("columns").intValue()).isEqualTo(columns);
        assertThat(read.get("width_m").doubleValue()).isCloseTo(20e-6, within(1e-12));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "di_corrupted.di",
                // Heights of meters on a side of micrometers: impossible units.
                "gwyddion-export-english.txt",
                "gwyddion-export-german.txt",
                "matrix-6.txt"
            })
    void whatCannotBeUsedIsToldInOneLine(String name) throws Exception {
        inspectScan(name, "").complains(SunbeamResult.UNUSABLE_INPUT, name);
        assertThat(workplace.files()).isEmpty();
    }
}
