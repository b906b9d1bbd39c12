package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Eight programs that start together in one folder with an empty cache. */
@Tag("thorough")
class EightAtOnceTest extends InWorkplace {
    private static final int PROGRAMS = 8;

    @Test
    void eachHasItsOutputAndOneTableIsLeft() throws Exception {
        List<RunningSunbeam> programs = new ArrayList<>();
        try {
            for (int i = 0; i < PROGRAMS; i++) {
                programs.add(
                        workplace.command("brdf-map --patch lamellar --size 16").start());
            }
            Set<String> outputs = new TreeSet<>();
            for (RunningSunbeam program : programs) {
                SunbeamResult result = program.end(Duration.ofMinutes(5));
                assertThat(result.exitCode()).as("%s", result).isZero();
                outputs.add(result.stdout().lines().reduce((one, last) -> last).orElseThrow());
            }
            assertThat(outputs).hasSize(PROGRAMS).contains("brdf-lamellar.png", "brdf-lamellar-8.png");
            assertThat(workplace.files()).containsExactlyElementsOf(outputs);
            // The cache has one table and no unfinished file.
            assertThat(workplace.tables().stream()
                            .filter(file -> file.toString().endsWith(".tables")))
                    .hasSize(1);
            assertThat(workplace.tables().stream()
                            .filter(file -> file.toString().endsWith(".part")))
                    .isEmpty();
        } finally {
            for (RunningSunbeam program : programs) {
                program.close();
            }
        }
    }
}
