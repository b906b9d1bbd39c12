package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Runs {@code sunbeam reflectance} for a list of directions and reads its output. */
public final class Reflectance {
    private Reflectance() {}

    public static CsvFile of(Workplace workplace, String patch, CsvFile directions, String... options)
            throws Exception {
        directions.write(workplace.resolve("directions.csv"));
        Path output = workplace.resolve("reflectance.csv");
        List<String> arguments = new ArrayList<>(List.of(
                "reflectance",
                "--patch",
                patch,
                "--directions",
                "directions.csv",
                "--output",
                "reflectance.csv",
                "--force"));
        arguments.addAll(List.of(options));
        SunbeamResult result = workplace.succeedHere(arguments.toArray(String[]::new));
        CsvFile results = CsvFile.read(output);
        assertThat(results.size()).as("rows of %s", result).isEqualTo(directions.size());
        return results;
    }
}
