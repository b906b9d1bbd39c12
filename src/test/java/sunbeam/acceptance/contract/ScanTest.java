package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.StreamSupport;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.acceptance.Complaint;
import sunbeam.acceptance.InWorkplace;
import sunbeam.acceptance.SharedData;
import sunbeam.acceptance.SunbeamResult;

/** Files of instruments: {@code inspect} reads the same sizes and heights as other programs. */
class ScanTest extends InWorkplace {
    private SunbeamResult inspect(String name, String... more) throws Exception {
        List<String> words = new ArrayList<>(List.of(
                "inspect",
                SharedData.present("scans/" + name).toString(),
                "--level=none",
                "--periodic",
                "--json",
                "--output",
                "sheet.png"));
        words.addAll(List.of(more));
        return workplace.here(words.toArray(String[]::new));
    }

    @ParameterizedTest
    @CsvSource({
        "di-1.di, ''",
        "di-3.di, Height",
        "spot_1-1000nm.ibw, ''",
        "nid-1.nid, Z-Axis forward",
        "example_ps.tiff, ''",
        "sample_0.jpk, Height (measured) (retrace)",
        "stp-1.stp, ''",
        "top-1.top, ''",
        "x3p-2.x3p, ''",
        "sdf-1.sdf, ''",
        "mi-1.mi, ''",
        "sur-2.sur, ''",
        "matrix-3.txt, ''",
        "txt_example.txt, ''"
    })
    void sizesAndReliefAreThoseOfOtherPrograms(String name, String channel) throws Exception {
        Path table = SharedData.present("scans/expected.json");
        JsonNode expected =
                new ObjectMapper().readTree(table.toFile()).get(name).get("heights");

        SunbeamResult result = channel.isEmpty() ? inspect(name) : inspect(name, "--channel=" + channel);

        assertThat(result.exitCode()).as("%s", result).isIn(0, 3);
        JsonNode read = new ObjectMapper().readTree(result.stdout());
        assertThat(StreamSupport.stream(expected.spliterator(), false))
                .as("one of %s, as %s", expected, read)
                .anyMatch(heights -> agree(heights, read));
    }

    private static boolean agree(JsonNode expected, JsonNode read) {
        double side = expected.get("unit_xy").asText().equals("mm") ? 1e-3 : 1;
        double unit = expected.get("unit_z").asText().equals("mm") ? 1e-3 : 1;
        double relief =
                unit * (expected.get("max").asDouble() - expected.get("min").asDouble());
        // Files have seven digits.
        return read.get("columns").equals(expected.get("columns"))
                && read.get("rows").equals(expected.get("rows"))
                && isNear(read.get("width_m"), side * expected.get("width").asDouble(), 1e-6)
                && isNear(read.get("height_m"), side * expected.get("height").asDouble(), 1e-6)
                && isNear(read.get("relief_m"), relief, 1e-5);
    }

    private static boolean isNear(JsonNode value, double expected, double relative) {
        return Math.abs(value.doubleValue() - expected) <= relative * expected;
    }

    /** Files without units are refused; the message names the missing option, with which they are read. */
    @ParameterizedTest
    @CsvSource({"test.gwy, 128", "matrix-5.txt, 10", "xyz-1.txt, 4", "xyz-2.txt, 4"})
    void whatHasNoUnitsIsReadOnceTheyAreGiven(String name, int columns) throws Exception {
        Complaint.assertThatIt(inspect(name), Complaint.UNUSABLE_INPUT, name, "--width", "--height-unit");

        SunbeamResult result = inspect(name, "--width=20um", "--height-unit=nm");

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
        Complaint.assertThatIt(inspect(name), Complaint.UNUSABLE_INPUT, name);
        assertThat(workplace.files()).isEmpty();
    }
}
