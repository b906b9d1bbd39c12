package sunbeam.app.files.input;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.assertj.core.api.AbstractThrowableAssert;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.precompute.files.InputException;

final class CsvTableTest {
    @TempDir
    private Path folder;

    private Path file(String text) throws IOException {
        return Files.writeString(folder.resolve("in.csv"), text);
    }

    private CsvTable read(String text) throws IOException {
        return CsvTable.read(file(text), List.of("theta", "phi"), List.of("wavelength"), CsvTableTest::complaint);
    }

    private static Optional<String> complaint(String column, double value) {
        return value == 90 ? Optional.of("is too much for " + column) : Optional.empty();
    }

    private static double[] column(CsvTable table, String name) {
        int column = table.columns().indexOf(name);
        return table.rows().stream().mapToDouble(row -> row[column]).toArray();
    }

    private AbstractThrowableAssert<?, ?> assertRefused(String text) {
        return assertThatThrownBy(() -> read(text))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(folder.resolve("in.csv").toString());
    }

    @Test
    void columnsAreFoundByNameAndOthersIgnored() throws IOException {
        CsvTable table = read("name,phi, theta ,note\na,1,2,\"x, \"\"y\"\"\"\nb,-3.5e1,.5,\n");
        assertThat(table.rows()).hasSize(2);
        assertThat(column(table, "theta")).containsExactly(2, 0.5);
        assertThat(column(table, "phi")).containsExactly(1, -35);
        assertThat(table.columns()).containsExactly("theta", "phi");
    }

    @Test
    void filesFromOtherSystemsAreRead() throws IOException {
        CsvTable table = read("\uFEFFtheta,phi,wavelength\r\n\r\n1,2,550\r\n3,4,600");
        assertThat(column(table, "theta")).containsExactly(1, 3);
        assertThat(column(table, "wavelength")).containsExactly(550, 600);
    }

    @Test
    void aQuotedFieldMayCrossLinesWhichAreCounted() throws IOException {
        CsvTable table = read("note,theta,phi\n\"two\nlines\",1,2\n,3,4\n");
        assertThat(column(table, "phi")).containsExactly(2, 4);
        assertRefused("note,theta,phi\n\"two\nlines\",1,2\n,3,90\n")
                .hasMessageContaining("line 4, column phi: 90.0 is too much for phi");
    }

    @Test
    void mistakesAreNamedWithLineAndColumn() {
        assertRefused("theta,phi\n1,2\n\n1,two\n").hasMessageContaining("line 4, column phi: 'two' is not");
        assertRefused("theta,phi\n1,\n").hasMessageContaining("line 2, column phi: ''");
        assertRefused("theta,phi\nnan,1\n").hasMessageContaining("line 2, column theta: 'nan'");
        assertRefused("theta,phi\n1e999,1\n").hasMessageContaining("finite");
        assertRefused("theta,psi\n1,2\n").hasMessageContaining("no column phi").hasMessageContaining("theta,psi");
        assertRefused("theta;phi\n1;2\n").hasMessageContaining("by commas");
        assertRefused("theta,phi,phi\n1,2,3\n").hasMessageContaining("two columns phi");
        assertRefused("theta,phi\n1,2\n1\n").hasMessageContaining("line 3: 1 fields, but the header has 2");
        assertRefused("theta,phi\n\"1,2\n").hasMessageContainingAll("Unclosed quoted field", "line 2");
        assertRefused("").hasMessageContaining("empty");
        assertRefused("theta,phi\n\n").hasMessageContaining("no row");
    }

    @Test
    void aLineWithoutEndTakesNoMemory() {
        assertRefused("theta,phi\n" + "1".repeat(70_000))
                .hasMessageContainingAll("line 2", "65536", "is this a table?");
        assertRefused("theta,phi\n" + "1,".repeat(70_000)).hasMessageContainingAll("line 2", "65536");
        assertRefused("theta,phi\n1,\"" + "2\n".repeat(70_000)).hasMessageContaining("line 2");
    }

    @Test
    void missingFilesAndFoldersAreReported() {
        Path missing = folder.resolve("missing.csv");
        assertThatThrownBy(() -> CsvTable.read(missing, List.of("x"), List.of(), CsvTableTest::complaint))
                .isInstanceOf(InputException.class)
                .hasMessage("cannot read " + missing + ": there is no such file; check the name");
        assertThatThrownBy(() -> CsvTable.read(folder, List.of("x"), List.of(), CsvTableTest::complaint))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("is a folder");
    }
}
