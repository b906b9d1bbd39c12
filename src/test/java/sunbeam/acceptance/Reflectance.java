package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/** Starts {@code sunbeam reflectance} for a list of directions and reads what it wrote. */
final class Reflectance {
    // Colours by the reference take about 10 s a row on an idle core, and cores are not always idle.
    private static final Duration PATIENCE = Duration.ofMinutes(10);

    private Reflectance() {}

    static CsvFile of(Workplace workplace, String patch, CsvFile directions, String... options) throws Exception {
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
        SunbeamResult result = workplace
                .command(arguments.toArray(String[]::new))
                .within(PATIENCE)
                .run();
        assertThat(result.exitCode()).as("%s", result).isZero();
        CsvFile results = CsvFile.read(output);
        assertThat(results.size()).as("rows of %s", result).isEqualTo(directions.size());
        return results;
    }
}
