package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.acceptance.Complaint;
import sunbeam.acceptance.InWorkplace;
import sunbeam.acceptance.SharedData;
import sunbeam.acceptance.SunbeamResult;

/** Files of instruments that lack units or are damaged. */
class ScanTest extends InWorkplace {
    private SunbeamResult inspect(String name, String options) throws Exception {
        return workplace.here(
                "inspect %s --level=none --periodic --json --output sheet.png" + options,
                SharedData.present("scans/" + name));
    }

    /** Files without units are refused; the message names the missing option, with which they are read. */
    @ParameterizedTest
    @CsvSource({"test.gwy, 128", "matrix-5.txt, 10", "xyz-1.txt, 4", "xyz-2.txt, 4"})
    void whatHasNoUnitsIsReadOnceTheyAreGiven(String name, int columns) throws Exception {
        Complaint.assertThatIt(inspect(name, ""), Complaint.UNUSABLE_INPUT, name, "--width", "--height-unit");

        SunbeamResult result = inspect(name, " --width=20um --height-unit=nm");

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
        Complaint.assertThatIt(inspect(name, ""), Complaint.UNUSABLE_INPUT, name);
        assertThat(workplace.files()).isEmpty();
    }
}
