package sunbeam.app.cli;

import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.BeforeEach;

/** Test of commands that take a folder of scans: a grating in "scans", reports in "report". */
abstract class CollectionFixture extends CommandLineFixture {
    protected static final double PERIOD = 2e-6;

    protected Path scans;
    protected Path report;

    @BeforeEach
    void prepare() throws IOException {
        scans = Files.createDirectory(folder.resolve("scans"));
        report = folder.resolve("report");
        scan("grating.txt", x -> 50 * Math.sin(2 * Math.PI * x / PERIOD));
    }

    /** Writes a scan of 64 equal rows of 64 samples, 0.25 um apart, in a text format that states its scale. */
    protected final void scan(String name, DoubleUnaryOperator heights) throws IOException {
        String header = "# Channel: Height\n# Width: 16 µm\n# Height: 16 µm\n# Value units: nm\n";
        scan("scans/" + name, header, 64, 64, (column, row) -> heights.applyAsDouble(column * 0.25e-6));
    }

    protected final int inspect(String words) {
        forgetOutput();
        return sunbeam("inspect --output @report " + words);
    }

    protected final List<NamedCsvRecord> table(String name) throws IOException {
        try (CsvReader<NamedCsvRecord> reader =
                CsvReader.builder().ofNamedCsvRecord(Files.readString(report.resolve(name)))) {
            return reader.stream().toList();
        }
    }

    protected final List<String> column(String name) throws IOException {
        return table("table.csv").stream().map(row -> row.getField(name)).toList();
    }

    protected final FileTime time(String picture) throws IOException {
        return Files.getLastModifiedTime(report.resolve("surfaces").resolve(picture));
    }
}
