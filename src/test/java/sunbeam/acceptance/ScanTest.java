package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Periods of gratings, and files of instruments that lack units or are damaged. */
class ScanTest extends InWorkplace {
    /** The thesis measures 1144 nm along the fingers' rows and 1032 nm as the ensemble's mean; the period lies between them. */
    @Test
    void elapheIsToldAlikeByInspectAndEvaluate() throws Exception {
        Path patch = SharedData.patch("elaphe");
        JsonNode seen = workplace.json("inspect --json --output sheet.png --patch %s", patch);
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
