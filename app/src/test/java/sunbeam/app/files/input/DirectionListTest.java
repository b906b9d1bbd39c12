package sunbeam.app.files.input;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.assertj.core.api.AbstractThrowableAssert;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.precompute.files.InputException;

final class DirectionListTest {
    private static final String HEADER = "theta_i,phi_i,theta_r,phi_r";

    @TempDir
    private Path folder;

    private Path file(String text) throws IOException {
        return Files.writeString(folder.resolve("in.csv"), text);
    }

    private DirectionList read(String text) throws IOException {
        return DirectionList.read(file(text));
    }

    private AbstractThrowableAssert<?, ?> assertRefused(String text) {
        return assertThatThrownBy(() -> read(text))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(folder.resolve("in.csv").toString());
    }

    @Test
    void columnsAreFoundByNameAndOthersIgnored() throws IOException {
        DirectionList list =
                read("name,phi_i, theta_i ,note,theta_r,phi_r\na,1,2,\"x, \"\"y\"\"\",3,4\nb,-3.5e1,.5,,0,0\n");
        assertThat(list.columns()).containsExactly("theta_i", "phi_i", "theta_r", "phi_r");
        assertThat(list.rows()).containsExactly(new double[] {2, 1, 3, 4}, new double[] {0.5, -35, 0, 0});
    }

    @Test
    void filesFromOtherSystemsAreRead() throws IOException {
        DirectionList list = read("\uFEFF" + HEADER + ",wavelength\r\n\r\n1,2,0,0,550\r\n3,4,0,0,600");
        assertThat(list.rows()).containsExactly(new double[] {1, 2, 0, 0, 550}, new double[] {3, 4, 0, 0, 600});
    }

    @Test
    void aQuotedFieldMayCrossLinesWhichAreCounted() throws IOException {
        String quoted = "note," + HEADER + "\n\"two\nlines\",1,2,0,0\n,3,4,";
        assertThat(read(quoted + "0,0\n").rows()).hasSize(2);
        assertRefused(quoted + "90,0\n")
                .hasMessageContaining("line 4, column theta_r: 90.0 must lie in 0..89.999 degrees");
    }

    @Test
    void mistakesAreNamedWithLineAndColumn() {
        assertRefused(HEADER + "\n1,2,0,0\n\n1,two,0,0\n").hasMessageContaining("line 4, column phi_i: 'two' is not");
        assertRefused(HEADER + "\n1,,0,0\n").hasMessageContaining("line 2, column phi_i: ''");
        assertRefused(HEADER + "\nnan,1,0,0\n").hasMessageContaining("line 2, column theta_i: 'nan'");
        assertRefused(HEADER + "\n1e999,1,0,0\n").hasMessageContaining("finite");
        assertRefused("theta_i,psi\n1,2\n").hasMessageContainingAll("no column phi_i", "theta_i,psi");
        assertRefused(HEADER.replace(",", ";") + "\n1;2;0;0\n").hasMessageContaining("by commas");
        assertRefused(HEADER + ",phi_i\n1,2,0,0,3\n").hasMessageContaining("two columns phi_i");
        assertRefused(HEADER + "\n1,2,0,0\n1\n").hasMessageContaining("line 3: 1 fields, but the header has 4");
        assertRefused(HEADER + "\n\"1,2\n").hasMessageContainingAll("Unclosed quoted field", "line 2");
        assertRefused("").hasMessageContaining("empty");
        assertRefused(HEADER + "\n\n").hasMessageContaining("no row");
    }

    @Test
    void aLineWithoutEndTakesNoMemory() {
        assertRefused(HEADER + "\n" + "1".repeat(70_000))
                .hasMessageContainingAll("line 2", "65536", "is this a table?");
        assertRefused(HEADER + "\n" + "1,".repeat(70_000)).hasMessageContainingAll("line 2", "65536");
        assertRefused(HEADER + "\n1,\"" + "2\n".repeat(70_000)).hasMessageContaining("line 2");
    }

    @Test
    void missingFilesAndFoldersAreReported() {
        Path missing = folder.resolve("missing.csv");
        assertThatThrownBy(() -> DirectionList.read(missing))
                .isInstanceOf(InputException.class)
                .hasMessage("cannot read " + missing + ": there is no such file; check the name");
        assertThatThrownBy(() -> DirectionList.read(folder))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("is a folder");
    }
}
