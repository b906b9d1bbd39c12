package sunbeam.app.files.input;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.assertj.core.api.AbstractThrowableAssert;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class CsvTableTest {
    @TempDir
    private Path folder;

    private Path file(String text) throws IOException {
        return Files.writeString(folder.resolve("in.csv"), text);
    }

    private CsvTable read(String text) throws IOException {
        return CsvTable.read(file(text), List.of("theta", "phi"), List.of("wavelength"));
    }

    private AbstractThrowableAssert<?, ?> assertRefused(String text) throws IOException {
        Path file = file(text);
        return assertThatThrownBy(() -> CsvTable.read(file, List.of("theta", "phi"), List.of("wavelength")))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(file.toString());
    }

    @Test
    void columnsAreFoundByNameAndOthersIgnored() throws IOException {
        CsvTable table = read("name,phi, theta ,note\na,1,2,\"x, \"\"y\"\"\"\nb,-3.5e1,.5,\n");
        assertThat(table.rows()).isEqualTo(2);
        assertThat(table.column("theta")).containsExactly(2, 0.5);
        assertThat(table.column("phi")).containsExactly(1, -35);
        assertThat(table.has("wavelength")).isFalse();
    }

    @Test
    void filesFromOtherSystemsAreRead() throws IOException {
        CsvTable table = read("\uFEFFtheta,phi,wavelength\r\n\r\n1,2,550\r\n3,4,600");
        assertThat(table.column("theta")).containsExactly(1, 3);
        assertThat(table.at(1, "wavelength")).isEqualTo(600);
    }

    @Test
    void aQuotedFieldMayCrossLinesWhichAreCounted() throws IOException {
        CsvTable table = read("note,theta,phi\n\"two\nlines\",1,2\n,3,4\n");
        assertThat(table.column("phi")).containsExactly(2, 4);
        assertThat(table.failure(1, "phi", "")).hasMessageContaining("line 4");
    }

    @Test
    void aBadNumberIsNamedWithLineAndColumn() throws IOException {
        assertRefused("theta,phi\n1,2\n\n1,two\n").hasMessageContaining("line 4, column phi: 'two' is not");
        assertRefused("theta,phi\n1,\n").hasMessageContaining("line 2, column phi: ''");
        assertRefused("theta,phi\nnan,1\n").hasMessageContaining("line 2, column theta: 'nan'");
        assertRefused("theta,phi\n1e999,1\n").hasMessageContaining("finite");
    }

    @Test
    void aMissingColumnIsNamed() throws IOException {
        assertRefused("theta,psi\n1,2\n").hasMessageContaining("no column phi").hasMessageContaining("theta,psi");
        assertRefused("theta;phi\n1;2\n").hasMessageContaining("by commas");
    }

    @Test
    void aColumnTwiceIsRefused() throws IOException {
        assertRefused("theta,phi,phi\n1,2,3\n").hasMessageContaining("two columns phi");
    }

    @Test
    void aRowOfAnotherLengthIsNamed() throws IOException {
        assertRefused("theta,phi\n1,2\n1\n").hasMessageContaining("line 3: 1 fields, but the header has 2");
        assertRefused("theta,phi\n0,5,1\n").hasMessageContaining("line 2: 3 fields");
        assertRefused("theta,phi\n\"1,2\n").hasMessageContainingAll("Unclosed quoted field", "line 2");
    }

    @Test
    void nothingToReadIsSaid() throws IOException {
        assertRefused("").hasMessageContaining("empty");
        assertRefused("theta,phi\n\n").hasMessageContaining("no row");
    }

    @Test
    void aLineWithoutEndTakesNoMemory() throws IOException {
        assertRefused("theta,phi\n" + "1".repeat(70_000))
                .hasMessageContainingAll("line 2", "65536", "is this a table?");
        assertRefused("theta,phi\n" + "1,".repeat(70_000)).hasMessageContainingAll("line 2", "65536");
        assertRefused("theta,phi\n1,\"" + "2\n".repeat(70_000)).hasMessageContaining("line 2");
    }

    @Test
    void aMissingFileAndAFolderAreSaid() {
        Path missing = folder.resolve("missing.csv");
        assertThatThrownBy(() -> CsvTable.read(missing, List.of("x"), List.of()))
                .isInstanceOf(InputException.class)
                .hasMessage("cannot read " + missing + ": there is no such file; check the name");
        assertThatThrownBy(() -> CsvTable.read(folder, List.of("x"), List.of()))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("is a folder");
    }
}
