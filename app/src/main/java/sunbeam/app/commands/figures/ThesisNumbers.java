package sunbeam.app.commands.figures;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import sunbeam.app.files.input.InputException;
import sunbeam.precompute.text.Text;

/**
 * Numbers of a table of the thesis beside ours.
 *
 * @param patch of which they are
 * @param thesis its numbers, by JSON pointers to ours
 * @param file where ours are; need not be there
 */
record ThesisNumbers(String patch, Map<String, Double> thesis, Path file) {

    record Row(String patch, String name, double thesis, double ours) {
        /** Patch, name, thesis's number, ours, difference. */
        List<String> cells() {
            return List.of(patch, name, written(thesis), written(ours), Text.format("%+.2f", ours - thesis));
        }

        private static String written(double value) {
            return Text.format("%.2f", value);
        }
    }

    List<Row> rows() {
        if (!Files.isRegularFile(file)) {
            return List.of();
        }
        try {
            JsonNode tree = new ObjectMapper().readTree(file.toFile());
            return thesis.entrySet().stream()
                    .filter(number -> tree.at(number.getKey()).isNumber())
                    .map(number -> new Row(
                            patch,
                            number.getKey().replaceFirst(".*/", "").replace('_', ' '),
                            number.getValue(),
                            tree.at(number.getKey()).asDouble()))
                    .toList();
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }
}
