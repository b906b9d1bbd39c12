package sunbeam.app.measure.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.Sunbeam;
import sunbeam.app.terminal.Environment;

/** What accuracy would not heed is refused at once, and not after hours of something else. */
final class AccuracyTasksTest {
    @TempDir
    private Path home;

    @ParameterizedTest
    @CsvSource({
        "--seed 3, --seed 3 belongs to --random",
        "--cases nowhere --seed 3, --seed 3 belongs to --random",
        "--cases nowhere --random 2, --cases and --random are several tasks",
        "--cases nowhere --patch blaze, --patch and --quick are not for --cases",
        "--random 2 --patch blaze, --patch and --quick are not for --random",
        "--random 2 --quick, --patch and --quick are not for --random",
        "--random 2 --tolerance 1e-3, --tolerance belongs to --cases",
        "--tolerance 1e-3, --tolerance belongs to --cases",
        "--keep found, --keep found belongs to --random",
        "--cases nowhere --keep found, --keep found belongs to --random",
        "--random 0, --random 0 is out of range",
    })
    void optionsOfAnotherTaskAreRefused(String options, String complaint) {
        StringWriter err = new StringWriter();
        Sunbeam sunbeam =
                new Sunbeam(new Environment(Map.of(), home), new PrintWriter(new StringWriter()), new PrintWriter(err));
        assertThat(sunbeam.run(("accuracy " + options).split(" "))).isEqualTo(2);
        assertThat(err.toString().lines()).singleElement().asString().startsWith("sunbeam: " + complaint);
    }
}
