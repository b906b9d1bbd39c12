package sunbeam.precompute.color;

import de.siegmar.fastcsv.reader.CommentStrategy;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

final class CieData {
    private static final String RESOURCE = "/sunbeam/color/cie_1nm.csv";
    private static final List<NamedCsvRecord> ROWS = rows();

    private CieData() {}

    private static List<NamedCsvRecord> rows() {
        try (CsvReader<NamedCsvRecord> rows = CsvReader.builder()
                .commentStrategy(CommentStrategy.SKIP)
                .ofNamedCsvRecord(CieData.class.getResourceAsStream(RESOURCE), StandardCharsets.UTF_8)) {
            return rows.stream().toList();
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read " + RESOURCE, e);
        }
    }

    static double[] column(String name) {
        return ROWS.stream()
                .mapToDouble(row -> Double.parseDouble(row.getField(name)))
                .toArray();
    }
}
